#include "cia402/state/option_codes.hpp"

#include <array>
#include <cassert>

namespace cia402 {
namespace {

using enum StopCause;
using enum Braking;

// clang-format off
constexpr std::array kStops{
    // Codes 5 to 8 brake like 1 to 4, but the axis is held at rest.
    StopRow{QuickStop, 0, None,          State::SwitchOnDisabled},
    StopRow{QuickStop, 1, SlowDownRamp,  State::SwitchOnDisabled},
    StopRow{QuickStop, 2, QuickStopRamp, State::SwitchOnDisabled},
    StopRow{QuickStop, 3, MaxTorque,     State::SwitchOnDisabled},
    StopRow{QuickStop, 4, MaxTorque,     State::SwitchOnDisabled},
    StopRow{QuickStop, 5, SlowDownRamp,  State::QuickStopActive},
    StopRow{QuickStop, 6, QuickStopRamp, State::QuickStopActive},
    StopRow{QuickStop, 7, MaxTorque,     State::QuickStopActive},
    StopRow{QuickStop, 8, MaxTorque,     State::QuickStopActive},

    StopRow{Shutdown, 0, None,         State::ReadyToSwitchOn},
    StopRow{Shutdown, 1, SlowDownRamp, State::ReadyToSwitchOn},

    StopRow{DisableOperation, 0, None,         State::SwitchedOn},
    StopRow{DisableOperation, 1, SlowDownRamp, State::SwitchedOn},

    StopRow{Halt, 1, SlowDownRamp,  State::OperationEnabled},
    StopRow{Halt, 2, QuickStopRamp, State::OperationEnabled},
    StopRow{Halt, 3, MaxTorque,     State::OperationEnabled},
    StopRow{Halt, 4, MaxTorque,     State::OperationEnabled},

    StopRow{FaultReaction, 0, None,          State::Fault},
    StopRow{FaultReaction, 1, SlowDownRamp,  State::Fault},
    StopRow{FaultReaction, 2, QuickStopRamp, State::Fault},
    StopRow{FaultReaction, 3, MaxTorque,     State::Fault},
    StopRow{FaultReaction, 4, MaxTorque,     State::Fault},
};
// clang-format on

const StopRow* find(StopCause cause, std::int16_t code) noexcept {
  for (const StopRow& row : kStops)
    if (row.cause == cause && row.code == code) return &row;
  return nullptr;
}

}  // namespace

std::int16_t OptionCodes::of(StopCause cause) const noexcept {
  switch (cause) {
    case QuickStop:
      return quick_stop;
    case Shutdown:
      return shutdown;
    case DisableOperation:
      return disable_operation;
    case Halt:
      return halt;
    case FaultReaction:
      break;
  }
  return fault_reaction;
}

std::span<const StopRow> stop_rows() noexcept {
  return kStops;
}

const StopRow& stop_of(StopCause cause, const OptionCodes& codes) noexcept {
  const StopRow* row = find(cause, codes.of(cause));
  if (row == nullptr) row = find(cause, OptionCodes{}.of(cause));
  assert(row != nullptr);
  return *row;
}

}  // namespace cia402
