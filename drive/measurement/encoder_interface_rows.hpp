#pragma once

#include <array>

#include "drive/measurement/encoder_interface.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<EncoderInterface> = std::array{
    Row{480, 3, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&EncoderInterface::Inputs::control_words>(Quantity::Word), Output::No, "CI: encoder control word Gn_STW source", "r0481 and r0483 of the motor encoder; other encoders do not answer"},
    Row{481, 3, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_status>, Output::Connector, "Encoder status word Gn_ZSW", "[0] of the motor encoder: bits 0 to 3 functions that are active, 4 to 7 values that were read, 11 acknowledgement, 13 absolute value, 14 parked, 15 fault; other encoders 0"},
};
// clang-format on

}  // namespace drive::rows
