#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {

/// The parts of a process-data cycle (p8848) in their order. The axes of a unit run each of them side by side:
/// first the inputs of the blocks that have their turn in it are taken, on all axes, then the blocks run. So an
/// output reaches the blocks of a later part in the same cycle, and all axes see each other alike.
enum class Phase : std::uint8_t {
  Sequence,         ///< enables, messages that inputs bring, mode of operation
  Setpoint,         ///< choice and limits of the setpoint
  Torque,           ///< torque setpoint, holding brake, identification
  ActualPosition,   ///< in each slice: position of the load
  Positioner,       ///< in each slice: references, modes, profile
  PositionControl,  ///< in each slice: position controller
  Values,           ///< after all steps of 125 µs: means of the cycle
  Messages,         ///< monitoring, causes and their messages
  Status,           ///< what the statusword shows of other blocks
};
inline constexpr std::array kBeforeTheSteps{Phase::Sequence, Phase::Setpoint, Phase::Torque};
/// A slice of 1 ms begins: of axes that have position control. They lie among the steps.
inline constexpr std::array kInTheSlices{Phase::ActualPosition, Phase::Positioner, Phase::PositionControl};
inline constexpr long kStepsInASlice = 8;  // of 125 µs
inline constexpr std::array kAfterTheSteps{Phase::Values, Phase::Messages, Phase::Status};
inline constexpr std::size_t kPhases = kBeforeTheSteps.size() + kInTheSlices.size() + kAfterTheSteps.size();

}  // namespace drive
