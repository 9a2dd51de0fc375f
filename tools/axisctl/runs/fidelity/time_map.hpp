#pragma once

#include <vector>

#include "tools/axisctl/runs/fidelity/verdict.hpp"
#include "tools/axisctl/runs/replay/course.hpp"

namespace runs {

/// Where in a course the times of another one lie: as far behind the same frame of the master.
class TimeMap {
 public:
  /// What takes a second in @p here takes @p pace seconds in @p there.
  TimeMap(const Course& here, const Course& there, const Yardstick& yardstick, double pace);

  /// The time there of @p at here.
  [[nodiscard]] canopen::Duration there(canopen::Duration at) const;
  /// By how much a time there may differ from there() of @p at.
  [[nodiscard]] canopen::Duration band(canopen::Duration at) const;
  /// How long what takes @p time here takes there.
  [[nodiscard]] canopen::Duration length_there(canopen::Duration time) const noexcept;

 private:
  struct Mark {
    canopen::Duration here, there;
  };
  [[nodiscard]] const Mark& mark_before(canopen::Duration at) const;

  std::vector<Mark> marks_;  ///< frames of the master
  const Yardstick& yardstick_;
  double pace_;
};

}  // namespace runs
