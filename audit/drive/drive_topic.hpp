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
  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;

 private:
  DriveValues values_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, AxisCourse> axes_;  ///< by node and axis
};

}  // namespace audit
