#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gateway {

/// What kind of thing a family of metrics is, in the words of Prometheus.
enum class MetricType : std::uint8_t { Counter, Gauge, Histogram };

/// Where the samples of a family come from.
enum class Source : std::uint8_t {
  Unit,     ///< one sample: a number of the answers, at a JSON pointer below {"status": ..., "metrics": ...}
  Axis,     ///< one sample an axis: a number of its status
  Special,  ///< a function of exposition.cpp
};

/// A family of metrics.
struct Family {
  std::string_view name;
  MetricType type;
  std::string_view help;
  Source source;
  std::string_view pointer{};  ///< of the value, or of the histogram
};

namespace family {
inline constexpr std::string_view kUp = "axisd_up";
inline constexpr std::string_view kInfo = "axisd_unit_info";
inline constexpr std::string_view kNmtState = "axisd_nmt_state";
inline constexpr std::string_view kBusState = "axisd_bus_state";
inline constexpr std::string_view kLinkUp = "axisd_bus_link_up";
inline constexpr std::string_view kSdoFrames = "axisd_sdo_response_frames_total";
inline constexpr std::string_view kMessages = "axisd_messages_total";
inline constexpr std::string_view kActive = "axisd_messages_active";
inline constexpr std::string_view kAxisState = "axisd_axis_state";
}  // namespace family

/// Every family, in the order of the page.
inline constexpr std::array kFamilies{
    Family{family::kUp, MetricType::Gauge, "1 if the unit answers and is switched on", Source::Special},
    Family{family::kInfo, MetricType::Gauge, "1; what the unit is", Source::Special},
    Family{"axisd_uptime_seconds", MetricType::Gauge, "since the power-on of the unit", Source::Unit,
           "/metrics/uptime_s"},
    Family{family::kNmtState, MetricType::Gauge, "1 for the NMT state of the node", Source::Special},
    Family{family::kLinkUp, MetricType::Gauge, "1 if the bus can be used", Source::Special},
    Family{family::kBusState, MetricType::Gauge, "1 for the error state of the CAN controller", Source::Special},
    Family{"axisd_frames_received_total", MetricType::Counter, "frames given to the unit", Source::Unit,
           "/metrics/frames/received"},
    Family{"axisd_frames_sent_total", MetricType::Counter, "frames that went out", Source::Unit,
           "/metrics/frames/sent"},
    Family{"axisd_frames_overflowed_total", MetricType::Counter,
           "received frames lost in the socket because they were not read in time", Source::Unit,
           "/status/bus/dropped"},
    Family{"axisd_frames_unsent_total", MetricType::Counter, "frames lost because the link was down", Source::Unit,
           "/status/bus/send_dropped"},
    Family{"axisd_tpdos_replaced_total", MetricType::Counter, "waiting TPDOs that a newer one made obsolete",
           Source::Unit, "/status/bus/replaced"},
    Family{"axisd_frames_foreign_total", MetricType::Counter,
           "frames of another station under identifiers of this node", Source::Unit, "/status/bus/foreign"},
    Family{"axisd_rpdos_overwritten_total", MetricType::Counter,
           "frames of asynchronous RPDOs that the next one overwrote before a cycle took them (A08751)",
           Source::Unit, "/status/bus/lost_telegrams"},
    Family{"axisd_rpdos_short_total", MetricType::Counter, "RPDO frames shorter than their mapping", Source::Unit,
           "/status/bus/short_rpdos"},
    Family{family::kSdoFrames, MetricType::Counter,
           "frames that SDO servers have sent, by result: ok or the abort code", Source::Special},
    Family{"axisd_cycle_period_seconds", MetricType::Gauge, "process-data cycle in force (p8848)", Source::Unit,
           "/metrics/cycles/period_s"},
    Family{"axisd_cycles_total", MetricType::Counter,
           "process-data cycles that were run; a unit at rest runs none", Source::Unit, "/metrics/cycles/run"},
    Family{"axisd_cycles_skipped_total", MetricType::Counter,
           "cycles left out because the daemon was kept from running for more than 100 ms", Source::Unit,
           "/metrics/cycles/skipped"},
    Family{"axisd_cycle_overruns_total", MetricType::Counter,
           "turns of the loop whose cycles were over only when the next one was due", Source::Unit,
           "/metrics/cycles/overruns"},
    Family{"axisd_cycle_duration_seconds", MetricType::Histogram,
           "from the beginning of a turn of the loop until its cycles were over", Source::Unit,
           "/metrics/cycles/duration_s"},
    Family{"axisd_cycle_lateness_seconds", MetricType::Histogram,
           "from when cycles were due until that turn began", Source::Unit, "/metrics/cycles/lateness_s"},
    Family{family::kMessages, MetricType::Counter, "faults and alarms that have come, by drive object and code",
           Source::Special},
    Family{family::kActive, MetricType::Gauge, "faults and alarms that are there", Source::Special},
    Family{"axisd_dc_link_volts", MetricType::Gauge, "voltage of the DC link", Source::Unit, "/status/dc_link_V"},
    Family{family::kAxisState, MetricType::Gauge, "1 for the state of the axis (CiA 402)", Source::Special},
    Family{"axisd_axis_speed_rpm", MetricType::Gauge, "measured speed", Source::Axis, "/speed_rpm"},
    Family{"axisd_axis_setpoint_rpm", MetricType::Gauge, "target velocity", Source::Axis, "/setpoint_rpm"},
    Family{"axisd_axis_torque_newton_metres", MetricType::Gauge, "torque of the motor", Source::Axis,
           "/torque_Nm"},
    Family{"axisd_axis_current_amperes", MetricType::Gauge, "motor current (rms)", Source::Axis, "/current_A"},
    Family{"axisd_axis_motor_temperature_celsius", MetricType::Gauge, "true temperature of the winding",
           Source::Axis, "/motor_temperature_C"},
    Family{"axisd_axis_position_increments", MetricType::Gauge, "encoder increments (6063h)", Source::Axis,
           "/position"},
};

}  // namespace gateway
