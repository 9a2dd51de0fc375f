#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "trace/signal/place.hpp"
#include "unit/time.hpp"

namespace trace {

/// Something that has happened in the unit, on the time axis of the trace. It is a value; the texts are those of
/// tables that outlive it.
struct Event {
  unit::TimePoint time{};
  std::string_view kind;  ///< one of event_kind, or what else the program tells of: "nmt", "link"
  Place place = kControlUnitPlace;
  bool active = true;        ///< it has come; false: it has gone
  std::uint16_t number = 0;  ///< of a message, parameter or object
  std::uint16_t index = 0;   ///< of a parameter, or sub-index of an object
  std::optional<double> value{};
  std::string_view text{};  ///< state, name of a message
};

/// What a trace sees itself.
namespace event_kind {
inline constexpr std::string_view kFault = "fault";
inline constexpr std::string_view kAlarm = "alarm";
inline constexpr std::string_view kDriveState = "drive-state";
}  // namespace event_kind

}  // namespace trace
