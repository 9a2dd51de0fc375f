#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cia402 {

/// States of the power drive system (CiA 402-2).
enum class State : std::uint8_t {
  NotReadyToSwitchOn,
  SwitchOnDisabled,
  ReadyToSwitchOn,
  SwitchedOn,
  OperationEnabled,
  QuickStopActive,
  FaultReactionActive,
  Fault,
};
inline constexpr std::size_t kStateCount = 8;

/// A state as it is printed, and as the statusword tells it.
struct StateRow {
  State state;
  std::string_view name;
  std::uint16_t bits;  ///< of 6041h: 0 to 3, 5 and 6
  std::uint16_t mask;  ///< what of the statusword has to be looked at to know the state
};

/// One row a state, in the order of the enumeration.
inline constexpr std::array<StateRow, kStateCount> kStates{{
    // clang-format off
    {State::NotReadyToSwitchOn,  "Not ready to switch on", 0x00, 0x4F},
    {State::SwitchOnDisabled,    "Switch on disabled",     0x40, 0x4F},
    {State::ReadyToSwitchOn,     "Ready to switch on",     0x21, 0x6F},
    {State::SwitchedOn,          "Switched on",            0x23, 0x6F},
    {State::OperationEnabled,    "Operation enabled",      0x27, 0x6F},
    {State::QuickStopActive,     "Quick stop active",      0x07, 0x6F},
    {State::FaultReactionActive, "Fault reaction active",  0x0F, 0x4F},
    {State::Fault,               "Fault",                  0x08, 0x4F},
    // clang-format on
}};
static_assert([] {
  for (std::size_t i = 0; i < kStateCount; ++i)
    if (kStates[i].state != static_cast<State>(i)) return false;
  return true;
}());

constexpr const StateRow& row_of(State state) noexcept {
  return kStates[static_cast<std::size_t>(state)];
}
/// The name of @p state as CiA 402 prints it.
constexpr std::string_view name_of(State state) noexcept {
  return row_of(state).name;
}

}  // namespace cia402
