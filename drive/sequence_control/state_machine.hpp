#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace drive {

/// States of the sequence control: the CiA 402 power drive system, with OFF1 braking and STOP2 of a SINAMICS.
enum class State : std::uint8_t {
  NotReadyToSwitchOn,   ///< run-up, r0002 = 70
  SwitchOnDisabled,     ///< switching on inhibited, r0002 = 41..43
  ReadyToSwitchOn,      ///< r0002 = 31
  SwitchedOn,           ///< ready for operation, pulses off, r0002 = 21
  OperationEnabled,     ///< r0002 = 0
  Off1Braking,          ///< ramp down on p1121, then Ready to switch on, r0002 = 16
  QuickStopActive,      ///< OFF3: ramp down on p1135, then Switch on disabled, r0002 = 17
  FaultReactionActive,  ///< braking because of a fault, then Fault, r0002 = 18
  Stop2Active,          ///< the same on p1135, but then the motor holds at zero until OFF or an acknowledgement
  Fault,                ///< pulses off, r0002 = 45
};
inline constexpr std::size_t kStateCount = 10;

/// The name of @p state as CiA 402 prints it.
constexpr std::string_view name_of(State state) noexcept {
  constexpr std::array<std::string_view, kStateCount> kNames{
      "Not ready to switch on", "Switch on disabled", "Ready to switch on",    "Switched on", "Operation enabled",
      "OFF1 braking",           "Quick stop active",  "Fault reaction active", "STOP2",       "Fault"};
  return kNames[static_cast<std::size_t>(state)];
}

/// What moves the sequence control: the command in the controlword, or something that happened.
enum class Event : std::uint8_t {
  Shutdown,          ///< controlword xxxx x110: OFF1
  SwitchOn,          ///< xxxx 0111, from Operation enabled also called disable operation
  EnableOperation,   ///< xxxx 1111
  DisableVoltage,    ///< xxxx xx0x: OFF2
  QuickStop,         ///< xxxx x01x: OFF3
  Initialised,       ///< run-up is over
  Standstill,        ///< braking has ended and the pulse suppression delay is over
  FaultOff1,         ///< a fault with the reaction OFF1
  FaultOff2,         ///< a fault with the reaction OFF2
  FaultOff3,         ///< a fault with the reaction OFF3
  FaultStop2,        ///< a fault with the reaction STOP2
  Acknowledged,      ///< the last fault is gone
  MeasurementEnded,  ///< p1910 or p1960 has found what it was to find, or has given up
};
inline constexpr std::size_t kEventCount = 13;

/// What the axis has to do on a transition.
enum class Action : std::uint8_t {
  None,
  EnablePulses,    ///< pulses on, the ramp starts at the actual speed
  InhibitPulses,   ///< pulses off, the motor coasts
  FollowSetpoint,  ///< leave a braking ramp, go on with the setpoint
  BrakeOnOff1,     ///< setpoint zero, ramp p1121
  BrakeOnOff3,     ///< setpoint zero, ramp p1135
};

/// One row of the transition table.
struct Transition {
  State from;
  Event on;
  State to;
  Action action;
};

/// The command in @p controlword, by CiA 402's masks on bits 0..3.
Event command_of(std::uint16_t controlword) noexcept;

/// The row for @p event in @p state, or nullptr: the event then changes nothing.
const Transition* find_transition(State state, Event event) noexcept;

/// All rows of the table.
std::span<const Transition> transitions() noexcept;

/// Whether the motor is on power in @p state.
bool pulses_enabled_in(State state) noexcept;

/// Whether @p state is one of the three that brake to standstill and then switch the pulses off.
bool is_braking(State state) noexcept;

}  // namespace drive
