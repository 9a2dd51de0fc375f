#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace drive {

/// A fault switches the axis off and waits for an acknowledgement; an alarm comes and goes with its cause.
enum class Kind : std::uint8_t { Fault, Alarm };

/// Drive objects on which a message can appear.
enum class Scope : std::uint8_t { Axis, ControlUnit, Both };

/// What a fault does to the motor.
enum class Reaction : std::uint8_t {
  None,
  Off1,          ///< ramp down on p1121, then pulses off
  Off2,          ///< pulses off at once
  Off3,          ///< ramp down on p1135, then pulses off
  Encoder,       ///< p0491; here OFF2 whatever it says
  Stop2,         ///< brake on p1135, then hold at zero with the pulses on
  ShortCircuit,  ///< armature short-circuit or DC brake; here the pulses go off as after OFF2
};

/// A set of reactions, one bit each in the order of the enumeration.
using Reactions = std::uint8_t;
constexpr Reactions bit_of(Reaction reaction) noexcept {
  return static_cast<Reactions>(1U << static_cast<unsigned>(reaction));
}

/// Whether a message that comes from one drive object appears on every one of the unit.
enum class Propagation : std::uint8_t { Local, Global };

/// When an acknowledgement removes a fault.
enum class Acknowledge : std::uint8_t {
  None,          ///< an alarm
  Immediately,   ///< as soon as the cause is gone
  PulseInhibit,  ///< only with the pulses off
  PowerOn,       ///< only by switching the unit off and on
};

/// One fault or alarm.
struct FaultRow {
  std::uint16_t number;
  Kind kind;
  Scope scope;
  Reaction reaction;
  Reactions alternatives;  ///< what p2100 and p2101 can set instead; of an alarm, its reaction as a fault or none
  Acknowledge acknowledge;
  Propagation propagation;
  std::uint16_t emcy_code;      ///< 0 = no EMCY
  std::uint8_t error_register;  ///< bits it sets in 1001h
  std::string_view name;
  std::string_view cause;
};

/// The reaction to @p row where p2100 and p2101 name no other one; of an alarm, that to the fault which p2118 and
/// p2119 make of it.
constexpr Reaction standard_reaction(const FaultRow& row) noexcept {
  const bool stops = row.kind == Kind::Alarm && row.alternatives == bit_of(Reaction::Off1);
  return stops ? Reaction::Off1 : row.reaction;
}

/// There are no more rows than this.
inline constexpr std::size_t kMostFaultRows = 256;

/// Every fault and alarm of the unit, ascending by number.
std::span<const FaultRow> fault_rows() noexcept;

/// The row of @p number, or nullptr; numbers are unique over faults and alarms.
const FaultRow* find_fault(std::uint16_t number) noexcept;

/// "F07900" or "A08751".
std::string fault_text(const FaultRow& row);
/// The same of a message that p2119 may have made another @p kind.
std::string message_code(std::uint16_t number, Kind kind);

}  // namespace drive
