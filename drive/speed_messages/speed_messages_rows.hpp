#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/speed_messages/speed_messages.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<SpeedMessages> = std::array{
    Row{53, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_status>, Output::Both, "Status word 2 (VECTOR)", "bits 1 to 9: speed above p1226, p1080, current from p2170, speed above and up to p2155, from r1119, DC link up to and above p2172, ramp ended"},
    Row{2141, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 5.0, When::Always, setting<&SpeedMessages::Settings::threshold_1>, Output::No, "Speed threshold 1", "r2199.1 from it on"},
    Row{2142, 1, kAxes, F32, Unit::Rpm, {0.0, 300.0}, 2.0, When::Always, setting<&SpeedMessages::Settings::hysteresis_1>, Output::No, "Hysteresis speed 1", "r2199.1 falls so far below p2141"},
    Row{2150, 1, kAxes, F32, Unit::Rpm, {0.0, 300.0}, 2.0, When::Always, setting<&SpeedMessages::Settings::hysteresis_3>, Output::No, "Hysteresis speed 3", "r2197.3 falls so far below zero"},
    Row{2151, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::message_setpoint, When::Always, value_input<&SpeedMessages::Inputs::setpoint>(Quantity::Speed), Output::No, "CI: speed setpoint for messages", "setpoint of r2197.7"},
    Row{2153, 1, kAxes, F32, Unit::Milliseconds, {0.0, 1000000.0}, 0.0, When::Always, Stored{"speed messages that are filtered"}, Output::No, "Speed actual filter time for messages", ""},
    Row{2155, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 900.0, When::Always, setting<&SpeedMessages::Settings::threshold_2>, Output::No, "Speed threshold 2", "bits 4 and 5 of r0053, r2197.1"},
    Row{2161, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 5.0, When::Always, setting<&SpeedMessages::Settings::zero_speed_threshold>, Output::No, "Speed threshold 3 (zero speed signal)", "statusword bit 12 below it"},
    Row{2162, 1, kAxes, F32, Unit::Rpm, {0.0, 60000.0}, factory::overspeed_hysteresis, When::Always, setting<&SpeedMessages::Settings::overspeed_hysteresis>, Output::No, "Overspeed hysteresis", "F07901 so far above the speed limit"},
    Row{2163, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 90.0, When::Always, setting<&SpeedMessages::Settings::target_window>, Output::No, "Speed threshold 4 (target reached window)", "statusword bit 10 within it"},
    Row{2164, 1, kAxes, F32, Unit::Rpm, {0.0, 200.0}, 2.0, When::Always, setting<&SpeedMessages::Settings::target_hysteresis>, Output::No, "Hysteresis 4", "added to p2163 on leaving"},
    Row{2166, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, 200.0, When::Always, setting<&SpeedMessages::Settings::target_off_delay>, Output::No, "Off delay n_act=n_set", "so long outside until bit 10 falls"},
    Row{2167, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, 200.0, When::Always, setting<&SpeedMessages::Settings::target_on_delay>, Output::No, "On delay n_act=n_set", "so long inside until r2199.4 comes"},
    Row{2175, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 120.0, When::Always, setting<&SpeedMessages::Settings::blocked_speed_threshold>, Output::No, "Motor blocked speed threshold", "F07900 below it at the torque limit"},
    Row{2177, 1, kAxes, F32, Unit::Seconds, {0.0, 65.0}, 1.0, When::Always, setting<&SpeedMessages::Settings::blocked_delay>, Output::No, "Motor blocked delay time", "F07900 after it"},
    Row{2197, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::monitoring_1>, Output::Both, "Status word monitoring 1", "bits 1, 3, 5, 6 and 7"},
    Row{2198, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::monitoring_2>, Output::Both, "Status word monitoring 2", "bit 6"},
    Row{2199, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::monitoring_3>, Output::Both, "Status word monitoring 3", "bits 0, 1, 4, 5 and 11"},
};
// clang-format on

}  // namespace drive::rows
