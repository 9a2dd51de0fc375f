#pragma once

#include <array>

#include "drive/motor_model/motor_model.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<MotorModel> = std::array{
    Row{300, 1, kAxes, I16, Unit::None, {0.0, 10100.0}, factory::motor_type, When::QuickOrMotor, setting<&MotorData::motor_type>, Output::No, "Motor type", "1 induction, 2 synchronous; of the list 10 to 19 and 90 to 199 induction, 200 to 299 synchronous, from 10000 as its own plate says; another one than the machine is raises F07950"},
    Row{301, 1, kAxes, U16, Unit::None, {0.0, 65535.0}, 0.0, When::QuickOrMotor, setting<&MotorData::motor_code>, Output::No, "Motor code number", "not 0: a motor of the list, whose data p0340 leaves"},
    Row{304, 1, kAxes, F32, Unit::VoltsRms, {0.0, 20000.0}, factory::machine_value<&motor::MachineData::rated_voltage, Unit::VoltsRms>, When::QuickOrMotor, setting<&MotorData::rated_voltage>, Output::No, "Rated motor voltage", "V/f characteristic and p0340"},
    Row{305, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, factory::machine_value<&motor::MachineData::rated_current, Unit::AmperesRms>, When::QuickOrMotor, setting<&MotorData::rated_current>, Output::No, "Rated motor current", "p0340"},
    Row{307, 1, kAxes, F32, Unit::Kilowatts, {0.0, 100000.0}, factory::rated_power, When::QuickOrMotor, setting<&MotorData::rated_power>, Output::No, "Rated motor power", "p0340"},
    Row{308, 1, kAxes, F32, Unit::None, {0.0, 1.0}, factory::machine_value<&motor::MachineData::power_factor, Unit::None>, When::QuickOrMotor, setting<&MotorData::power_factor>, Output::No, "Rated power factor", "p0340"},
    Row{310, 1, kAxes, F32, Unit::Hertz, {0.0, 650.0}, factory::machine_value<&motor::MachineData::rated_frequency, Unit::Hertz>, When::QuickOrMotor, setting<&MotorData::rated_frequency>, Output::No, "Rated motor frequency", "V/f characteristic and p0340"},
    Row{311, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::rated_speed, When::QuickOrMotor, setting<&MotorData::rated_speed>, Output::No, "Rated motor speed", "p0340"},
    Row{312, 1, kAxes, F32, Unit::NewtonMetre, {0.0, 1000000.0}, factory::rated_torque, When::QuickOrMotor, Stored{"a machine model that takes it; it is computed from the other motor data"}, Output::No, "Rated motor torque (synchronous)", ""},
    Row{313, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::pole_pairs>, Output::No, "Effective pole pairs", "p0314"},
    Row{314, 1, kAxes, U16, Unit::None, {0.0, 255.0}, factory::pole_pairs, When::QuickOrMotor, setting<&MotorData::pole_pairs>, Output::No, "Motor pole pair number", "r0313"},
    Row{316, 1, kAxes, F32, Unit::NewtonMetrePerAmpere, {0.0, 4000.0}, factory::machine_value<&motor::MachineData::torque_constant, Unit::NewtonMetrePerAmpere>, When::QuickOrMotorAlways, setting<&MotorData::torque_constant>, Output::No, "Motor torque constant", "torque of a current, of a synchronous machine"},
    Row{320, 1, kAxes, F32, Unit::AmperesRms, {0.0, 5000.0}, factory::magnetising_current, When::MotorAlways, setting<&MotorData::magnetising_current>, Output::No, "Rated magnetising current", "p0340"},
    Row{322, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::motor_maximum_speed, When::QuickOrMotor, setting<&MotorData::motor_maximum_speed>, Output::No, "Maximum motor speed", "limits the speed together with p1082"},
    Row{323, 1, kAxes, F32, Unit::AmperesRms, {0.0, 20000.0}, factory::machine_value<&motor::MachineData::maximum_current, Unit::AmperesRms>, When::QuickOrMotor, setting<&MotorData::motor_maximum_current>, Output::No, "Maximum motor current", "p0340"},
    Row{331, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::magnetising_current>, Output::Connector, "Magnetising current effective", ""},
    Row{333, 1, kAxes, F32, Unit::NewtonMetre, kWhole, factory::rated_torque, When::ReadOnly, setting<&MotorData::rated_torque>, Output::No, "Rated motor torque", "reference of 6071h, 6074h and 6077h"},
    Row{338, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, factory::machine_value<&motor::MachineData::maximum_current, Unit::AmperesRms>, When::QuickOrMotorAlways, setting<&MotorData::motor_limit_current>, Output::No, "Motor limit current", "limits the current besides p0640, 0 = not"},
    Row{340, 1, kAxes, I16, Unit::None, {0.0, 5.0}, 0.0, When::QuickOrMotorReady, shown<axis_value::no_value, axis_value::compute_parameters>, Output::No, "Automatic calculation motor/control parameters", "2 equivalent circuit of a motor that is not of the list, from its plate: of an induction motor with a straight magnetising characteristic, of a synchronous one p0350, p0356, p0357; 4 controllers (p1460, p1462, p1470, p1472); 5 limits (p0640, p1082, p1520, p1521, p1530, p1531, p2162); 3 as 4 and 5; 1 everything and p0341; reads 0", Keep::No},
    Row{341, 1, kAxes, F32, Unit::KilogramSquareMetre, {0.0, 100000.0}, factory::motor_inertia, When::MotorAlways, setting<&MotorData::motor_inertia>, Output::No, "Motor moment of inertia", "acceleration precontrol, p0340"},
    Row{342, 1, kAxes, F32, Unit::None, {1.0, 10000.0}, factory::inertia_ratio, When::MotorAlways, setting<&MotorData::inertia_ratio>, Output::No, "Total / motor inertia ratio", "r0345"},
    Row{344, 1, kAxes, F32, Unit::Kilograms, {0.0, 50000.0}, 0.0, When::MotorAlways, Stored{"a thermal model that is computed from the weight"}, Output::No, "Motor weight", ""},
    Row{345, 1, kAxes, F32, Unit::Seconds, kWhole, 0.0, When::ReadOnly, shown<axis_value::starting_time>, Output::No, "Nominal starting time", "motor inertia, p1082 and torque limit"},
    Row{350, 1, kAxes, F32, Unit::Ohms, {0.0, 2000.0}, factory::machine_value<&motor::MachineData::stator_resistance, Unit::Ohms>, When::MotorAlways, setting<&MotorData::stator_resistance>, Output::No, "Stator resistance cold", "current controller"},
    Row{353, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000000.0}, 0.0, When::MotorAlways, setting<&MotorData::series_inductance>, Output::No, "Motor series inductance", "added to p0356 and p0357 in what the control sees; p1910 takes it off what it measures"},
    Row{354, 1, kAxes, F32, Unit::Ohms, {0.0, 300.0}, factory::rotor_resistance, When::MotorAlways, setting<&MotorData::rotor_resistance>, Output::No, "Rotor resistance cold", "flux and slip of an induction machine"},
    Row{356, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000.0}, factory::stator_leakage, When::MotorAlways, setting<&MotorData::stator_leakage>, Output::No, "Stator leakage inductance", "current controller; of a synchronous machine its inductance across the magnets"},
    Row{357, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000.0}, factory::direct_inductance, When::MotorAlways, setting<&MotorData::direct_inductance>, Output::No, "Stator inductance d axis", "current controller of a synchronous machine"},
    Row{358, 1, kAxes, F32, Unit::Millihenries, {0.0, 1000.0}, factory::rotor_leakage, When::MotorAlways, setting<&MotorData::rotor_leakage>, Output::No, "Rotor leakage inductance", "current controller of an induction machine"},
    Row{360, 1, kAxes, F32, Unit::Millihenries, {0.0, 10000.0}, factory::main_inductance, When::MotorAlways, setting<&MotorData::main_inductance>, Output::No, "Magnetising inductance", "flux of an induction machine, without saturation"},
    Row{362, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 60.0, When::MotorAlways, setting<&MotorData::characteristic_flux_1>, Output::No, "Magnetising characteristic flux 1", "saturation of an induction machine: rotor flux, of the one at p0320"},
    Row{363, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 85.0, When::MotorAlways, setting<&MotorData::characteristic_flux_2>, Output::No, "Magnetising characteristic flux 2", "saturation of an induction machine: rotor flux, of the one at p0320"},
    Row{364, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 115.0, When::MotorAlways, setting<&MotorData::characteristic_flux_3>, Output::No, "Magnetising characteristic flux 3", "saturation of an induction machine: rotor flux, of the one at p0320"},
    Row{365, 1, kAxes, F32, Unit::Percent, {10.0, 300.0}, 125.0, When::MotorAlways, setting<&MotorData::characteristic_flux_4>, Output::No, "Magnetising characteristic flux 4", "saturation of an induction machine: rotor flux, of the one at p0320"},
    Row{366, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, factory::characteristic_current<0>, When::MotorAlways, setting<&MotorData::characteristic_current_1>, Output::No, "Magnetising characteristic current 1", "the current that it takes, of p0320"},
    Row{367, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, factory::characteristic_current<1>, When::MotorAlways, setting<&MotorData::characteristic_current_2>, Output::No, "Magnetising characteristic current 2", "the current that it takes, of p0320"},
    Row{368, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, factory::characteristic_current<2>, When::MotorAlways, setting<&MotorData::characteristic_current_3>, Output::No, "Magnetising characteristic current 3", "the current that it takes, of p0320"},
    Row{369, 1, kAxes, F32, Unit::Percent, {5.0, 800.0}, factory::characteristic_current<3>, When::MotorAlways, setting<&MotorData::characteristic_current_4>, Output::No, "Magnetising characteristic current 4", "the current that it takes, of p0320"},
};
// clang-format on

}  // namespace drive::rows
