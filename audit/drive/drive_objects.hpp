#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

/// Objects of an axis that are judged (CiA 402-2), and what their bits mean.
namespace audit::drive_object {

inline constexpr std::uint16_t kErrorCode = 0x603F;
inline constexpr std::uint16_t kControlword = 0x6040;
inline constexpr std::uint16_t kStatusword = 0x6041;
inline constexpr std::uint16_t kTargetVelocityOfVl = 0x6042;
inline constexpr std::uint16_t kMode = 0x6060;
inline constexpr std::uint16_t kModeDisplay = 0x6061;
inline constexpr std::uint16_t kActualPosition = 0x6064;
inline constexpr std::uint16_t kFollowingErrorWindow = 0x6065;
inline constexpr std::uint16_t kTargetTorque = 0x6071;
inline constexpr std::uint16_t kTargetPosition = 0x607A;
inline constexpr std::uint16_t kPositionLimits = 0x607D;
inline constexpr std::uint16_t kTargetVelocity = 0x60FF;
inline constexpr std::uint16_t kSupportedModes = 0x6502;

struct Row {
  std::uint16_t object;
  bool is_signed;
};
inline constexpr std::array kRows{
    Row{kErrorCode, false},
    Row{kControlword, false},
    Row{kStatusword, false},
    Row{kTargetVelocityOfVl, true},
    Row{kMode, true},
    Row{kModeDisplay, true},
    Row{kActualPosition, true},
    Row{kFollowingErrorWindow, false},
    Row{kTargetTorque, true},
    Row{kTargetPosition, true},
    Row{kPositionLimits, true},
    Row{kTargetVelocity, true},
    Row{kSupportedModes, false},
};

constexpr const Row* row_of(std::uint16_t object) noexcept {
  const auto row = std::ranges::find(kRows, object, &Row::object);
  return row == kRows.end() ? nullptr : &*row;
}
constexpr bool is_judged(std::uint16_t object) noexcept {
  return row_of(object) != nullptr;
}
constexpr bool is_signed(std::uint16_t object) noexcept {
  const Row* const row = row_of(object);
  return row != nullptr && row->is_signed;
}

/// @p to - @p from of positions that overflow (32 bits).
constexpr std::int64_t difference(std::int64_t to, std::int64_t from) noexcept {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}

// Controlword.
inline constexpr std::uint16_t kSwitchOn = 0x01, kEnableAll = 0x0F, kNewSetPoint = 0x10, kRelative = 0x40,
                               kFaultReset = 0x80, kHalt = 0x100;
inline constexpr std::uint16_t kCommandBits = 0x8F;
// Statusword.
inline constexpr std::uint16_t kFault = 0x08, kTargetReached = 0x400, kSetPointTaken = 0x1000,
                               kSpeedIsZero = 0x1000, kHomingAttained = 0x1000, kHomingError = 0x2000;

constexpr bool is_switch_on_disabled(std::int64_t statusword) noexcept {
  return (statusword & 0x4F) == 0x40;
}
constexpr bool is_fault(std::int64_t statusword) noexcept {
  return (statusword & 0x4F) == kFault;
}
constexpr bool is_enabled(std::int64_t statusword) noexcept {
  return (statusword & 0x6F) == 0x27;
}

/// The state that @p statusword shows, as CiA 402-2 names it.
constexpr std::string_view state_in(std::int64_t statusword) noexcept {
  struct State {
    std::int64_t mask, value;
    std::string_view name;
  };
  constexpr std::array kStates{
      State{0x4F, 0x00, "Not ready to switch on"}, State{0x4F, 0x40, "Switch on disabled"},
      State{0x6F, 0x21, "Ready to switch on"},     State{0x6F, 0x23, "Switched on"},
      State{0x6F, 0x27, "Operation enabled"},      State{0x6F, 0x07, "Quick stop active"},
      State{0x4F, 0x0F, "Fault reaction active"},  State{0x4F, 0x08, "Fault"},
  };
  for (const State& state : kStates)
    if ((statusword & state.mask) == state.value) return state.name;
  return "";
}

/// Whether @p statusword shows the state to which @p controlword leads (CiA 402-2, 8.4).
constexpr bool is_led_to(std::int64_t controlword, std::int64_t statusword) noexcept {
  struct Command {
    std::int64_t mask, value, state_mask, state;
  };
  constexpr std::array kCommands{
      Command{0x82, 0x00, 0x4F, 0x40},  // disable voltage: Switch on disabled
      Command{0x86, 0x02, 0x4F, 0x40},  // quick stop, which is of no effect there
      Command{0x87, 0x06, 0x6F, 0x21},  // shutdown: Ready to switch on
      Command{0x8F, 0x07, 0x6F, 0x23},  // switch on: Switched on
      Command{0x8F, 0x0F, 0x6F, 0x27},  // enable operation: Operation enabled
  };
  return std::ranges::any_of(kCommands, [=](const Command& command) {
    return (controlword & command.mask) == command.value && (statusword & command.state_mask) == command.state;
  });
}

// Modes of operation.
inline constexpr std::int64_t kProfilePosition = 1, kProfileVelocity = 3, kHoming = 6, kCyclicPosition = 8;

/// Whether @p statusword shows that a drive that is enabled moves in @p mode; false where its bits do not tell.
constexpr bool moves(std::int64_t mode, std::int64_t statusword) noexcept {
  switch (mode) {
    case kProfilePosition:
      return (statusword & kTargetReached) == 0;
    case kProfileVelocity:
      return (statusword & kSpeedIsZero) == 0;
    case kHoming:
      return (statusword & (kTargetReached | kHomingAttained | kHomingError)) == 0;
    default:
      return false;
  }
}

}  // namespace audit::drive_object
