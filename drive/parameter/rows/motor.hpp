#pragma once

#include <array>

#include "drive/parameter/axis_values.hpp"
#include "drive/parameter/factory_values.hpp"
#include "drive/parameter/row.hpp"

namespace drive::rows {

/// Motor, encoder, power unit.
// clang-format off
inline constexpr std::array kMotorRows{
    Row{300, 1, kAxes, I16, Unit::None, {0.0, 10100.0}, 2.0, When::QuickOrMotor, Stored{}, Output::No, "Motor type", ""},
    Row{301, 1, kAxes, U16, Unit::None, {0.0, 65535.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Motor code number", ""},
    Row{304, 1, kAxes, F32, Unit::VoltsRms, {0.0, 20000.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Rated motor voltage", ""},
    Row{305, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Rated motor current", ""},
    Row{307, 1, kAxes, F32, Unit::Kilowatts, {0.0, 100000.0}, factory::rated_power, When::QuickOrMotor, Stored{}, Output::No, "Rated motor power", ""},
    Row{308, 1, kAxes, F32, Unit::None, {0.0, 1.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Rated power factor", ""},
    Row{310, 1, kAxes, F32, Unit::Hertz, {0.0, 650.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Rated motor frequency", ""},
    Row{311, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::rated_speed, When::QuickOrMotor, Stored{}, Output::No, "Rated motor speed", ""},
    Row{312, 1, kAxes, F32, Unit::NewtonMetre, {0.0, 1000000.0}, factory::rated_torque, When::QuickOrMotor, Stored{}, Output::No, "Rated motor torque (synchronous)", ""},
    Row{313, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::pole_pairs), Output::No, "Effective pole pairs", "p0314"},
    Row{314, 1, kAxes, U16, Unit::None, {0.0, 255.0}, 0.0, When::QuickOrMotor, Slot{}, Output::No, "Motor pole pair number", "r0313"},
    Row{316, 1, kAxes, F32, Unit::NewtonMetrePerAmpere, {0.0, 4000.0}, 0.0, When::QuickOrMotorAlways, Stored{}, Output::No, "Motor torque constant", ""},
    Row{320, 1, kAxes, F32, Unit::AmperesRms, {0.0, 5000.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Rated magnetising current", ""},
    Row{322, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::motor_maximum_speed, When::QuickOrMotor, Member{&P::motor_maximum_speed}, Output::No, "Maximum motor speed", "limits the speed together with p1082"},
    Row{323, 1, kAxes, F32, Unit::AmperesRms, {0.0, 20000.0}, 0.0, When::QuickOrMotor, Stored{}, Output::No, "Maximum motor current", ""},
    Row{331, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "Magnetising current effective", ""},
    Row{333, 1, kAxes, F32, Unit::NewtonMetre, kWhole, factory::rated_torque, When::ReadOnly, Member{&P::rated_torque}, Output::No, "Rated motor torque", "reference of 6071h, 6074h and 6077h"},
    Row{338, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, 0.0, When::QuickOrMotorAlways, Stored{}, Output::No, "Motor limit current", ""},
    Row{340, 1, kAxes, I16, Unit::None, {0.0, 5.0}, 0.0, When::QuickOrMotorReady, axis(axis_value::no_value, axis_value::compute_parameters), Output::No, "Automatic calculation motor/control parameters", "1 everything, 3 and 4 controllers, 5 limits; reads 0", Keep::No},
    Row{341, 1, kAxes, F32, Unit::KilogramSquareMetre, {0.0, 100000.0}, factory::motor_inertia, When::MotorAlways, Stored{}, Output::No, "Motor moment of inertia", ""},
    Row{342, 1, kAxes, F32, Unit::None, {1.0, 10000.0}, factory::inertia_ratio, When::MotorAlways, Slot{}, Output::No, "Total / motor inertia ratio", "r0345"},
    Row{345, 1, kAxes, F32, Unit::Seconds, kWhole, 0.0, When::ReadOnly, axis(axis_value::starting_time), Output::No, "Nominal starting time", "motor inertia, p1082 and torque limit"},
    Row{350, 1, kAxes, F32, Unit::Ohms, {0.0, 2000.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Stator resistance cold", ""},
    Row{354, 1, kAxes, F32, Unit::Ohms, {0.0, 300.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Rotor resistance cold", ""},
    Row{356, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Stator leakage inductance", ""},
    Row{358, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Rotor leakage inductance", ""},
    Row{360, 1, kAxes, F32, Unit::Millihenries, {0.0, 10000.0}, 0.0, When::MotorAlways, Stored{}, Output::No, "Magnetising inductance", ""},
    Row{362, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 60.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic flux 1", ""},
    Row{363, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 85.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic flux 2", ""},
    Row{364, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 115.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic flux 3", ""},
    Row{365, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 125.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic flux 4", ""},
    Row{366, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, 50.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic current 1", ""},
    Row{367, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, 85.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic current 2", ""},
    Row{368, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, 125.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic current 3", ""},
    Row{369, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, 210.0, When::MotorAlways, Stored{}, Output::No, "Magnetising characteristic current 4", ""},
    Row{400, 3, kAxes, I16, Unit::None, {0.0, 10100.0}, 0.0, When::Encoder, Stored{}, Output::No, "Encoder type", ""},
    Row{404, 3, kAxes, U32, Unit::None, kWhole, 0.0, When::Encoder, Stored{}, Output::No, "Encoder configuration", ""},
    Row{408, 3, kAxes, U32, Unit::None, {1.0, 16777215.0}, factory::encoder_pulses, When::Encoder, Stored{}, Output::No, "Rotary encoder pulse number", ""},
    Row{418, 3, kAxes, U8, Unit::Bits, {2.0, 18.0}, factory::encoder_fine_bits, When::Encoder, Stored{}, Output::No, "Fine resolution Gx_XIST1", ""},
    Row{419, 3, kAxes, U8, Unit::Bits, {2.0, 18.0}, 9.0, When::Encoder, Stored{}, Output::No, "Fine resolution Gx_XIST2", ""},
    Row{421, 3, kAxes, U32, Unit::None, {0.0, 65535.0}, 4096.0, When::Encoder, Stored{}, Output::No, "Absolute encoder multiturn resolution", ""},
    Row{482, 3, kAxes, U32, Unit::Increments, kWhole, 0.0, When::ReadOnly, axis(axis_value::encoder_position), Output::Connector, "Encoder position actual value Gn_XIST1", "[0] of the motor encoder; other encoders 0"},
    Row{483, 3, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0}, Output::Connector, "Encoder position actual value Gn_XIST2", ""},
    Row{491, 1, kAxes, I16, Unit::None, {0.0, 6.0}, 0.0, When::Always, Stored{}, Output::No, "Motor encoder fault response ENCODER", ""},
    Row{604, 1, kAxes, F32, Unit::Celsius, {0.0, 200.0}, 120.0, When::Always, Stored{}, Output::No, "Motor temperature alarm threshold", ""},
    Row{605, 1, kAxes, F32, Unit::Celsius, {0.0, 200.0}, 145.0, When::Always, Stored{}, Output::No, "Motor temperature fault threshold", ""},
    Row{640, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, 0.0, When::QuickOrMotorAlways, Stored{}, Output::No, "Current limit", ""},
};
// clang-format on

}  // namespace drive::rows
