#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "drive/setpoint_channel/ramp_function_generator.hpp"
#include "motor/lockstep/lane_group.hpp"

namespace drive {

/// Most steps of 125 µs that are planned at once: those of a cycle of 4 ms.
inline constexpr std::size_t kMostPlannedSteps = 32;

/// Setpoints of an axis for some steps, and where its ramp was before them.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): count says how many setpoints there are
struct StepPlan {
  std::array<motor::SpeedStep, kMostPlannedSteps> setpoints;
  std::size_t count = 0;                               // of them
  std::optional<RampFunctionGenerator> ramp_before{};  // none: it rests, and all setpoints are the same
};

}  // namespace drive
