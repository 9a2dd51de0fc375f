#pragma once

#include <array>
#include <string_view>

#include "drive/parameter/row.hpp"

namespace drive::rows {

namespace until {
inline constexpr std::string_view kCommandDataSets = "command data sets, of which there is one";
inline constexpr std::string_view kDriveDataSets = "drive data sets, of which there is one";
inline constexpr std::string_view kParking = "an axis that is parked";
}  // namespace until

/// Data sets and parking: an axis has one data set of each kind.
// clang-format off
inline constexpr std::array kDataSetRows{
    Row{810, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kCommandDataSets}, Output::No, "BI: command data set selection CDS bit 0", ""},
    Row{811, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kCommandDataSets}, Output::No, "BI: command data set selection CDS bit 1", ""},
    Row{820, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: drive data set selection DDS bit 0", ""},
    Row{821, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: drive data set selection DDS bit 1", ""},
    Row{822, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: drive data set selection DDS bit 2", ""},
    Row{823, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: drive data set selection DDS bit 3", ""},
    Row{824, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: drive data set selection DDS bit 4", ""},
    Row{828, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kDriveDataSets}, Output::No, "BI: motor changeover feedback", ""},
    Row{835, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kDriveDataSets}, Output::Both, "CO/BO: data set changeover status word", ""},
    Row{836, 1, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kCommandDataSets}, Output::Both, "CO/BO: command data set selected", ""},
    Row{896, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kParking}, Output::Both, "CO/BO: parking axis status word", ""},
    Row{897, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kParking}, Output::No, "BI: parking axis selection", ""},
};
// clang-format on

}  // namespace drive::rows
