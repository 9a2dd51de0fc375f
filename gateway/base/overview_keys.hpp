#pragma once

#include <array>
#include <span>
#include <string_view>

namespace gateway {

/// What the overview takes over of the `status` of a unit.
inline constexpr std::array<std::string_view, 6> kOverviewKeys{"node_id",  "profile",   "nmt_state",
                                                               "uptime_s", "dc_link_V", "skipped_cycles"};

/// Members of an object in `status`.
struct OverviewPart {
  std::string_view key;
  std::array<std::string_view, 4> members;  ///< empty ones at the end
};
inline constexpr std::array kOverviewParts{
    OverviewPart{"leds", {"run", "error"}},
    OverviewPart{"bus", {"state", "link", "received", "sent"}},
    OverviewPart{"control_unit", {"faults", "alarms"}},
    OverviewPart{"infeed", {"name", "state", "faults", "alarms"}},
};

/// Members of each of its `axes`.
inline constexpr std::array<std::string_view, 14> kOverviewAxis{
    "axis",      "name",         "type",      "state",     "mode",     "homed",
    "speed_rpm", "setpoint_rpm", "torque_Nm", "current_A", "position", "motor_temperature_C",
    "faults",    "alarms"};

}  // namespace gateway
