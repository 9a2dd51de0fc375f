#pragma once

#include <array>

#include "drive/parameter/row.hpp"

namespace drive::rows {

/// Technology controller.
// clang-format off
inline constexpr std::array kTechnologyRows{
    Row{2200, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "BI: technology controller enable", ""},
    Row{2240, 1, kAxes, F32, Unit::Percent, {-200.0, 200.0}, 0.0, When::Always, Stored{}, Output::No, "Technology controller motorised potentiometer start value", ""},
    Row{2250, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "CO: technology controller motorised potentiometer behind the ramp", ""},
    Row{2257, 1, kAxes, F32, Unit::Seconds, {0.0, 650.0}, 1.0, When::Always, Stored{}, Output::No, "Tec ctrl ramp-up time", ""},
    Row{2258, 1, kAxes, F32, Unit::Seconds, {0.0, 650.0}, 1.0, When::Always, Stored{}, Output::No, "Tec ctrl ramp-down time", ""},
    Row{2260, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "Tec ctrl setpoint after RFG", ""},
    Row{2265, 1, kAxes, F32, Unit::Seconds, {0.0, 60.0}, 0.0, When::Always, Stored{}, Output::No, "Tec ctrl actual value filter time", ""},
    Row{2266, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "Tec ctrl actual value filtered", ""},
    Row{2268, 1, kAxes, F32, Unit::Percent, {-200.0, 200.0}, -100.0, When::Always, Stored{}, Output::No, "Technology controller actual value lower limit", ""},
    Row{2269, 1, kAxes, F32, Unit::Percent, {0.0, 500.0}, 100.0, When::Always, Stored{}, Output::No, "Technology controller actual value gain", ""},
    Row{2274, 1, kAxes, F32, Unit::Seconds, {0.0, 60.0}, 0.0, When::Always, Stored{}, Output::No, "Tec ctrl derivative time", ""},
    Row{2280, 1, kAxes, F32, Unit::None, {0.0, 1000.0}, 1.0, When::Always, Stored{}, Output::No, "Tec ctrl P gain", ""},
    Row{2285, 1, kAxes, F32, Unit::Seconds, {0.0, 60.0}, 0.0, When::Always, Stored{}, Output::No, "Tec ctrl integral time", ""},
    Row{2291, 1, kAxes, F32, Unit::Percent, {-200.0, 200.0}, 100.0, When::Always, Stored{}, Output::No, "Tec ctrl maximum limit", ""},
    Row{2292, 1, kAxes, F32, Unit::Percent, {-200.0, 200.0}, 0.0, When::Always, Stored{}, Output::No, "Tec ctrl minimum limit", ""},
    Row{2294, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "Tec ctrl output", ""},
    Row{2349, 1, kAxes, U16, Unit::None, kWhole, 1.0, When::ReadOnly, Fixed{1.0}, Output::Both, "CO/BO: technology controller status word", "bit 0: deactivated"},
};
// clang-format on

}  // namespace drive::rows
