#pragma once

#include <array>

#include "drive/operator_panel/operator_panel.hpp"
#include "drive/parameter/row.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<OperatorPanel> = std::array{
    Row{806, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&OperatorPanel::Inputs::is_inhibited>, Output::No, "BI: inhibit master control", "1: no operator panel takes the control; one that has it keeps it"},
    Row{807, 1, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, output<&OperatorPanel::is_active>, Output::Both, "BO: master control active", "0 automatic, 1 by hand: an operator panel leads"},
};
// clang-format on

}  // namespace drive::rows
