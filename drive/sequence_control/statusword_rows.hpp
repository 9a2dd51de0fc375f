#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/sequence_control/statusword.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<FreeStatusBits> = std::array{
    Row{8784, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::statusword>, Output::Both, "CAN status word (CO)", ""},
    Row{8785, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&FreeStatusBits::Inputs::bit_8>, Output::No, "CAN status word bit 8 source (BI)", "bit 8 of 6041h"},
    Row{8786, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&FreeStatusBits::Inputs::bit_14>, Output::No, "CAN status word bit 14 source (BI)", "bit 14 of 6041h"},
    Row{8787, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&FreeStatusBits::Inputs::bit_15>, Output::No, "CAN status word bit 15 source (BI)", "bit 15 of 6041h"},
};
// clang-format on

}  // namespace drive::rows
