#pragma once

#include <array>

#include "drive/jog/jog.hpp"
#include "drive/parameter/row.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<Jog> = with_module(function_module::kSetpointChannel, std::array{
    Row{1055, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&Jog::Inputs::jog_1>, Output::No, "BI: jog 1", "with ON = 0 switches on and leads p1058"},
    Row{1056, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&Jog::Inputs::jog_2>, Output::No, "BI: jog 2", "with ON = 0 switches on and leads p1059"},
    Row{1058, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 150.0, When::Always, setting<&Jog::Settings::speed_1>, Output::Connector, "Jog 1 speed setpoint", "setpoint while p1055 jogs"},
    Row{1059, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, -150.0, When::Always, setting<&Jog::Settings::speed_2>, Output::Connector, "Jog 2 speed setpoint", "setpoint while p1056 jogs"},
});
// clang-format on

}  // namespace drive::rows
