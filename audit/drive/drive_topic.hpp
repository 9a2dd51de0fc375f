#pragma once

#include <map>
#include <utility>

#include "audit/base/topic.hpp"
#include "audit/drive/axis_course.hpp"
#include "audit/drive/drive_values.hpp"

namespace audit {

/// How a master leads drives (CiA 402): states, modes, set-points.
class DriveTopic final : public Topic {
 public:
  /// @p has_times: frames have times.
  explicit DriveTopic(bool has_times) : has_times_{has_times} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;

 private:
  AxisCourse& course_of(const DriveValue& value);

  bool has_times_;
  DriveValues values_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, AxisCourse> axes_;  ///< by node and axis
};

}  // namespace audit
