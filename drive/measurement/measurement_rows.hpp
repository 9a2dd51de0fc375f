#pragma once

#include <array>

#include "drive/measurement/measurement.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<Measurement> = std::array{
    Row{21, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed>, Output::Connector, "Speed actual value smoothed", ""},
    Row{31, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque>, Output::Connector, "Torque actual value smoothed", ""},
    Row{61, 2, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_speed>, Output::Connector, "Speed actual value unsmoothed (encoder)", "[0] of the motor encoder; other encoders 0"},
    Row{63, 3, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed>, Output::Connector, "Speed actual value", "mean of a cycle, every index"},
    Row{79, 2, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_demand>, Output::Connector, "Total torque setpoint", "both indices"},
    Row{80, 2, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque>, Output::Connector, "Torque actual value [0] unsmoothed [1] smoothed", "mean of a cycle, both indices"},
    Row{400, 3, kAxes, I16, Unit::None, {0.0, 10100.0}, factory::encoder_type, When::Encoder, Stored{until::kEncoder}, Output::No, "Encoder type", "delivered: 0 none, 2002 incremental and 2051 absolute sin/cos encoder with 2048 pulses, 9999 another one"},
    Row{404, 3, kAxes, U32, Unit::None, kWhole, 0.0, When::Encoder, Stored{until::kEncoder}, Output::No, "Encoder configuration", ""},
    Row{408, 3, kAxes, U32, Unit::None, {1.0, 16777215.0}, factory::encoder_pulses, When::Encoder, Stored{until::kEncoder}, Output::No, "Rotary encoder pulse number", ""},
    Row{418, 3, kAxes, U8, Unit::Bits, {2.0, 18.0}, factory::encoder_fine_bits, When::Encoder, Stored{"the encoder interface of PROFIdrive (Gx_XIST1)"}, Output::No, "Fine resolution Gx_XIST1", ""},
    Row{419, 3, kAxes, U8, Unit::Bits, {2.0, 18.0}, 9.0, When::Encoder, Stored{"the encoder interface of PROFIdrive (Gx_XIST2)"}, Output::No, "Fine resolution Gx_XIST2", ""},
    Row{421, 3, kAxes, U32, Unit::None, {0.0, 65535.0}, 4096.0, When::Encoder, Stored{until::kEncoder}, Output::No, "Absolute encoder multiturn resolution", ""},
    Row{482, 3, kAxes, U32, Unit::Increments, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_position>, Output::Connector, "Encoder position actual value Gn_XIST1", "[0] of the motor encoder; other encoders 0"},
    Row{483, 3, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::absolute_position>, Output::Connector, "Encoder position actual value Gn_XIST2", "[0] of an absolute motor encoder, or what p0480 asks for; other encoders 0"},
    Row{491, 1, kAxes, I16, Unit::None, {0.0, 6.0}, 0.0, When::Always, Stored{"encoder faults with a reaction of their own; they have that of the list of messages"}, Output::No, "Motor encoder fault response ENCODER", ""},
};
// clang-format on

}  // namespace drive::rows
