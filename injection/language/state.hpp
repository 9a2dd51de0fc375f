#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace injection {

/// A state in which a fault may hold: of the node (NMT), or of an axis (CiA 402).
enum class State : std::uint8_t {
  Stopped,
  PreOperational,
  Operational,
  NotReadyToSwitchOn,
  SwitchOnDisabled,
  ReadyToSwitchOn,
  SwitchedOn,
  OperationEnabled,
  QuickStopActive,
  FaultReactionActive,
  Fault,
};

/// The words for them, in their order.
inline constexpr auto kStateNames =
    std::to_array<std::string_view>({"stopped", "pre-operational", "operational", "not-ready-to-switch-on",
                                     "switch-on-disabled", "ready-to-switch-on", "switched-on",
                                     "operation-enabled", "quick-stop-active", "fault-reaction-active", "fault"});

/// Whether @p state is one of the node.
constexpr bool is_nmt_state(State state) noexcept {
  return state <= State::Operational;
}

}  // namespace injection
