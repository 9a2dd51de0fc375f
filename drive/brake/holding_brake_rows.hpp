#pragma once

#include <array>

#include "drive/brake/holding_brake.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<HoldingBrake> = std::array{
    Row{1215, 1, kAxes, I16, Unit::None, {0.0, 3.0}, factory::brake_configuration, When::Ready, setting<&HoldingBrake::Settings::configuration>, Output::No, "Motor holding brake configuration", "0 none, 1 and 3 by the sequence control, 2 always open"},
    Row{1216, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, factory::brake_opening_time, When::Always, setting<&HoldingBrake::Settings::opening_time>, Output::No, "Motor holding brake opening time", "the setpoint waits so long after the pulses have come"},
    Row{1217, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, factory::brake_closing_time, When::Always, setting<&HoldingBrake::Settings::closing_time>, Output::No, "Motor holding brake closing time", "the motor holds so long after the brake was told to close"},
};
// clang-format on

}  // namespace drive::rows
