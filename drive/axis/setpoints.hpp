#pragma once

#include <cstdint>

namespace drive {

/// What the master sends in one process-data cycle to an axis that is wired as a new one.
struct Setpoints {
  std::uint16_t controlword = 0;
  double speed = 0.0;   ///< rad/s
  double torque = 0.0;  ///< N·m, leads in torque control

  friend bool operator==(const Setpoints&, const Setpoints&) = default;
};

}  // namespace drive
