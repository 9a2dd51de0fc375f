#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "libcanopen/base/time.hpp"

namespace record {

/// What a unit tells of itself. The numbers stand in recordings: they stay.
enum class EventKind : std::uint8_t {
  Power = 0,
  BootUp = 1,
  Nmt = 2,
  Link = 3,
  Bus = 4,
  DriveState = 5,
  Fault = 6,
  Alarm = 7,
  Emergency = 8,
  Parameter = 9,
  Object = 10,
  Refusal = 11,
  Store = 12,
  Restore = 13,
  Control = 14,
};
inline constexpr std::size_t kEventKinds = 15;

/// Who has caused it.
enum class Origin : std::uint8_t {
  Unit = 0,    ///< the unit itself
  Sdo = 1,     ///< a client of an SDO server
  Control = 2  ///< a client of the control socket
};

/// A short text that an event has itself; what is longer is cut.
class Note {
 public:
  static constexpr std::size_t kLongest = 95;  ///< bytes

  constexpr Note() noexcept = default;
  /// Cut between two letters of UTF-8.
  explicit Note(std::string_view text) noexcept;
  std::string_view text() const noexcept { return {bytes_.data(), size_}; }

 private:
  std::array<char, kLongest> bytes_{};
  std::uint8_t size_ = 0;
};

/// Something that has happened in a unit. It is a value: nothing is allocated for it. Which members count depends
/// on its kind (see kEventRows); texts are those of tables that outlive the program's units.
struct Event {
  canopen::TimePoint time{};
  EventKind kind = EventKind::Power;
  Origin origin = Origin::Unit;
  std::uint8_t server = 0;   ///< SDO server that was used, 0 = that of 1200h
  std::uint8_t object = 0;   ///< drive object, 0 = none
  std::uint8_t axis = 0;     ///< the same as an axis, 0 = it is none
  bool active = true;        ///< it has come, is up, is on, has succeeded
  std::uint16_t number = 0;  ///< of a state, message, parameter, object or node
  std::uint16_t index = 0;   ///< of a parameter, or sub-index of an object
  std::uint32_t code = 0;    ///< SDO abort code
  std::optional<double> value{};
  std::optional<double> before{};      ///< the value before a write
  std::array<std::uint8_t, 8> data{};  ///< of an emergency message
  std::string_view text{};             ///< state, name of a message, or method of the control socket
  std::string_view text_before{};      ///< the state before
  Note note{};                         ///< parameters of the method, in short
};

/// A kind of events: its name for subscriptions and JSON, and what it says.
struct EventRow {
  EventKind kind;
  std::string_view name;
  std::string_view summary;
};
/// One row a kind, in their order.
inline constexpr std::array kEventRows{
    EventRow{EventKind::Power, "power", "the unit was switched on or off"},
    EventRow{EventKind::BootUp, "boot-up", "the boot-up message was sent"},
    EventRow{EventKind::Nmt, "nmt", "the NMT state has changed"},
    EventRow{EventKind::Link, "link", "the bus can be used, or cannot"},
    EventRow{EventKind::Bus, "bus", "the error state of the CAN controller has changed"},
    EventRow{EventKind::DriveState, "drive-state", "the state of an axis or of the infeed has changed (CiA 402)"},
    EventRow{EventKind::Fault, "fault", "a fault has come, gone or taken another value"},
    EventRow{EventKind::Alarm, "alarm", "an alarm has come, gone or taken another value"},
    EventRow{EventKind::Emergency, "emcy", "an emergency message was sent"},
    EventRow{EventKind::Parameter, "parameter", "a parameter was written"},
    EventRow{EventKind::Object, "object", "an object of the dictionary was written"},
    EventRow{EventKind::Refusal, "refusal", "an SDO client was refused a write"},
    EventRow{EventKind::Store, "store", "the parameters were saved, or could not be"},
    EventRow{EventKind::Restore, "restore", "the parameters are those of a new unit"},
    EventRow{EventKind::Control, "control", "a client of the control socket has acted on the unit"},
};
static_assert([] {
  for (std::size_t i = 0; i < kEventRows.size(); ++i)
    if (kEventRows[i].kind != static_cast<EventKind>(i)) return false;
  return kEventRows.size() == kEventKinds;
}());

/// The row of @p kind.
constexpr const EventRow& row_of(EventKind kind) noexcept {
  return kEventRows[static_cast<std::size_t>(kind)];
}
/// The kind called @p name, if there is one.
std::optional<EventKind> kind_named(std::string_view name) noexcept;
/// "unit", "sdo" or "control".
std::string_view name_of(Origin origin) noexcept;

/// @p event as docs/reference/control.md shows it; `t` is in seconds since @p start.
nlohmann::json json_of(const Event& event, canopen::TimePoint start);

}  // namespace record
