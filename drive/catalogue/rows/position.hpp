#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::rows {

/// Position control (LR).
// clang-format off
inline constexpr std::array kPositionRows{
    Row{2502, 1, kAxes, I16, Unit::None, {0.0, 3.0}, 1.0, When::Ready, Stored{}, Output::No, "LR encoder assignment", ""},
    Row{2503, 1, kAxes, U32, Unit::LengthUnits, {1.0, 2147483647.0}, 10000.0, When::Ready, Stored{}, Output::No, "LR LU per 10 mm (linear encoder)", ""},
    Row{2504, 1, kAxes, U32, Unit::None, {1.0, 1048576.0}, 1.0, When::Ready, Slot{}, Output::No, "LR motor revolutions of gear ratio", "r2521, r2522, r2524"},
    Row{2505, 1, kAxes, I32, Unit::None, {-1048576.0, 1048576.0}, 1.0, When::Ready, Slot{}, Output::No, "LR load revolutions of gear ratio", "r2521, r2522, r2524"},
    Row{2506, 1, kAxes, U32, Unit::LengthUnits, {1.0, 2147483647.0}, 10000.0, When::Ready, Slot{}, Output::No, "LR LU per load revolution", "r2521, r2522, r2524"},
    Row{2507, 1, kAxes, I16, Unit::None, {0.0, 3.0}, 1.0, When::Ready, Stored{}, Output::No, "LR absolute encoder adjustment status", ""},
    Row{2510, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "BI: LR measuring probe selection", ""},
    Row{2511, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "BI: LR measuring probe edge", ""},
    Row{2521, 4, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, shown<axis_value::position>, Output::Connector, "LR position actual value", "[0] from encoder, gear and p2525"},
    Row{2522, 4, kAxes, I32, Unit::ThousandLengthUnitsPerMinute, kWhole, 0.0, When::ReadOnly, shown<axis_value::position_velocity>, Output::Connector, "LR velocity actual value", "[0]"},
    Row{2523, 4, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "LR measured value", ""},
    Row{2524, 1, kAxes, F32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, shown<axis_value::units_per_revolution>, Output::Connector, "LR LU per motor revolution", "p2506, p2505 and p2504"},
    Row{2525, 1, kAxes, U32, Unit::LengthUnits, {0.0, 4294967295.0}, 0.0, When::Ready, Slot{}, Output::No, "LR encoder adjustment offset", "r2521"},
    Row{2526, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Both, "LR status word", ""},
    Row{2527, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Both, "LR actual value sensing status encoder 1", ""},
    Row{2530, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "CI: LR position setpoint", ""},
    Row{2534, 1, kAxes, F32, Unit::Percent, {0.0, 200.0}, 0.0, When::Always, Stored{}, Output::No, "LR velocity precontrol factor", ""},
    Row{2538, 1, kAxes, F32, Unit::ThousandPerMinute, {0.0, 300.0}, 1.0, When::Always, Stored{}, Output::No, "LR proportional gain (Kv)", ""},
    Row{2539, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 0.0, When::Always, Stored{}, Output::No, "LR integral time", ""},
    Row{2542, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 200.0, When::Always, Stored{}, Output::No, "LR standstill window", ""},
    Row{2543, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 200.0, When::Always, Stored{}, Output::No, "LR standstill monitoring time", ""},
    Row{2544, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 40.0, When::Always, Stored{}, Output::No, "LR positioning window", ""},
    Row{2545, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 1000.0, When::Always, Stored{}, Output::No, "LR positioning monitoring time", ""},
    Row{2546, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 1000.0, When::Always, Stored{}, Output::No, "LR following error tolerance", ""},
    Row{2547, 1, kAxes, I32, Unit::LengthUnits, {-2147483648.0, 2147483647.0}, 0.0, When::Always, Stored{}, Output::No, "LR cam switching position 1", ""},
    Row{2548, 1, kAxes, I32, Unit::LengthUnits, {-2147483648.0, 2147483647.0}, 0.0, When::Always, Stored{}, Output::No, "LR cam switching position 2", ""},
    Row{2556, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "LR position setpoint after smoothing", ""},
    Row{2563, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "LR following error dynamic model", ""},
    Row{2565, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "LR following error actual", ""},
};
// clang-format on

}  // namespace drive::rows
