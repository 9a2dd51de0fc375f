#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/values/profile_values.hpp"

namespace drive::rows {

/// What masters look up that know PROFIdrive but not the drive, and who may write.
// clang-format off
inline constexpr std::array kProfileRows{
    Row{107, 1, kAxes | kInfeed, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::object_type>, Output::No, "Drive object type", "11 servo, 12 vector; infeed 10, 20, 30"},
    Row{927, 1, kAll, U16, Unit::None, {0.0, 65535.0}, 65535.0, When::Always, Slot{}, Output::No, "Parameter access authority", "bit 0: records (DS47) and registers may write parameters of this drive object, bit 3: parameter channels (PKW); whoever may not can write p0927 itself all the same"},
    Row{964, 7, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::device_identification>, Output::No, "Device identification", "[0] manufacturer, [1] device type, [2] firmware, [3] year, [4] day and month, [5] number of drive objects, [6] firmware patch"},
    Row{965, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::profile_number>, Output::No, "PROFIdrive profile number", "profile 3, version 41"},
    Row{980, 300, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::existing<0>>, Output::No, "List of existing parameters 1", "ascending, 0 = end; [299] the list that goes on"},
    Row{981, 300, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::existing<1>>, Output::No, "List of existing parameters 2", "goes on from r0980"},
    Row{982, 300, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::existing<2>>, Output::No, "List of existing parameters 3", "goes on from r0981"},
    Row{990, 300, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::modified<0>>, Output::No, "List of modified parameters 1", "what is saved and is other than in a new unit, ascending, 0 = end; [299] the list that goes on"},
    Row{991, 100, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<profile_value::modified<1>>, Output::No, "List of modified parameters 2", "goes on from r0990"},
};
// clang-format on

}  // namespace drive::rows
