#pragma once

#include <array>

#include "drive/base/unit_inputs.hpp"
#include "drive/clock/unit_clock.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/clock_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<UnitClock> = std::array{
    Row{2114, 2, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<clock_value::runtime>, Output::No, "System runtime", "operating time over all lives: [0] ms of the day, [1] days"},
    Row{3100, 1, kControlUnit, U16, Unit::None, {0.0, 1.0}, 0.0, When::Always, shown<clock_value::mode, clock_value::set_mode>, Output::No, "RTC time stamp mode", "0 operating time, 1 UTC, which begins at 0 with the write; messages to come are stamped so"},
    Row{3101, 2, kControlUnit, U32, Unit::None, {0.0, 86399999.0}, 0.0, When::Always, shown<clock_value::given, clock_value::set_given>, Output::No, "Set UTC time", "[1] days since 1970, to 65535; then [0] ms of the day, which sets the clock as p3103 says", Keep::No, check::clock_time},
    Row{3102, 2, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<clock_value::utc>, Output::No, "Display UTC time", "[0] ms of the day, [1] days since 1970; 0 with p3100 = 0"},
    Row{3103, 1, kControlUnit, I16, Unit::None, {0.0, 4.0}, 0.0, When::Always, shown<clock_value::method, clock_value::set_method>, Output::No, "UTC synchronisation method", "0 ping-snap, 2 simple, 4 NTP: the clock of the host", Keep::Stored, check::clock_method},
    Row{3104, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&UnitInputs::utc_ping>, Output::No, "BI: UTC ping synchronisation", "a rising edge is the moment that the next p3101 is about"},
    Row{3105, 4, kControlUnit, U8, Unit::None, {0.0, 255.0}, 0.0, When::Always, Stored{"an NTP client; with p3103 = 4 the clock of the host is the answer"}, Output::No, "NTP server IP address", ""},
    Row{3106, 1, kControlUnit, I16, Unit::None, kWhole, 0.0, When::Always, Stored{"times other than UTC"}, Output::No, "NTP time zone", ""},
    Row{3107, 4, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<clock_value::violation>, Output::No, "UTC time of the tolerance violation", "[0] ms, [1] days before the last correction beyond p3109, [2], [3] after it"},
    Row{3108, 2, kControlUnit, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<clock_value::deviation>, Output::No, "UTC synchronisation deviation", "ms by which the clock was set on: [0] last correction, [1] last one beyond p3109"},
    Row{3109, 1, kControlUnit, U16, Unit::Milliseconds, {0.0, 1000.0}, 100.0, When::Always, setting<&UnitClock::Settings::tolerance>, Output::No, "UTC synchronisation tolerance", "a correction beyond it raises A01099 until the next one within it; the first one does not"},
    Row{3116, 1, kAll, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{"faults that are acknowledged without being asked to; there are none"}, Output::No, "BI: suppress automatic acknowledgement", ""},
};
// clang-format on

}  // namespace drive::rows
