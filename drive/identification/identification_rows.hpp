#pragma once

#include <array>

#include "drive/identification/identification.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/identification_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<Identification> = std::array{
    Row{47, 1, kAxes, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<identification_value::progress>, Output::Connector, "Identification status", "0 none; selected: 300 p1910, 200 p1960; what runs: 270 stator resistance, 290 dead time, 250 both axes, 220 leakage, 230 rotor time constant, 260 circuit; 190 pole position, encoder test, 170 flux or saturation, 150 inertia, 140 speed controller"},
    Row{1900, 1, kAxes, I16, Unit::None, {0.0, 2.0}, 0.0, When::QuickReady, shown<identification_value::both, identification_value::select_both>, Output::No, "MotID and rotating measurement", "1 sets p1910 = 1 and, with p1300 from 20 on, p1960 = 1; 2 p1910 = 1 only; 0 takes them back; 0 when all is done", Keep::No},
    Row{1910, 1, kAxes, I16, Unit::None, {-3.0, 28.0}, 0.0, When::Ready, shown<identification_value::standstill, identification_value::select_standstill>, Output::No, "Motor data identification at standstill", "at the next ON: 1 measures and takes over, -1 (vector also 2) measures for r19xx only; 3 the saturation characteristic of an induction machine, p0362 to p0369 with p0360; -3 takes over what was found last; other values are refused; reads 0 when done", Keep::No, check::standstill_selection},
    Row{1912, 1, kAxes, F32, Unit::Ohms, kWhole, 0.0, When::ReadOnly, shown<identification_value::stator_resistance>, Output::No, "Stator resistance identified", "at 20 °C"},
    Row{1913, 1, kAxes, F32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, shown<identification_value::rotor_time_constant>, Output::No, "Rotor time constant identified", "of an induction machine, r1936 by r1927"},
    Row{1914, 1, kAxes, F32, Unit::Millihenries, kWhole, 0.0, When::ReadOnly, shown<identification_value::leakage>, Output::No, "Total leakage inductance identified", "of an induction machine"},
    Row{1925, 1, kAxes, F32, Unit::Volts, kWhole, 0.0, When::ReadOnly, shown<identification_value::threshold_voltage>, Output::No, "Threshold voltage identified", "what each phase loses to dead time and valves"},
    Row{1927, 1, kAxes, F32, Unit::Ohms, kWhole, 0.0, When::ReadOnly, shown<identification_value::rotor_resistance>, Output::No, "Rotor resistance identified", "at 20 °C, of the circuit whose leakage is on the stator's side"},
    Row{1932, 1, kAxes, F32, Unit::Millihenries, kWhole, 0.0, When::ReadOnly, shown<identification_value::d_inductance>, Output::No, "d inductance identified", "of a synchronous machine"},
    Row{1934, 1, kAxes, F32, Unit::Millihenries, kWhole, 0.0, When::ReadOnly, shown<identification_value::q_inductance>, Output::No, "q inductance identified", "of a synchronous machine"},
    Row{1936, 1, kAxes, F32, Unit::Millihenries, kWhole, 0.0, When::ReadOnly, shown<identification_value::magnetising_inductance>, Output::No, "Magnetising inductance identified", "without saturation, of the circuit of r1927"},
    Row{1937, 1, kAxes, F32, Unit::NewtonMetrePerAmpere, kWhole, 0.0, When::ReadOnly, shown<identification_value::torque_constant>, Output::No, "Torque constant identified", "of a synchronous machine"},
    Row{1958, 5, kAxes, F32, Unit::Seconds, {-1.0, 999999.0}, -1.0, When::Ready, Slot{}, Output::No, "Rotating measurement ramp/time", "p1960: [0] ramp from 0 to p1082, -1 = as fast as the torque gives well; others on nothing"},
    Row{1959, 1, kAxes, U16, Unit::None, kWhole, 15.0, When::Ready, Slot{}, Output::No, "Rotating measurement configuration", "p1960: bits 1 flux of the magnets or saturation characteristic, 2 moment of inertia, 3 p0340 = 4 with what was found and p1967, 14 and 15 lock the positive and the negative direction; 0 the encoder test, which is made anyway"},
    Row{1960, 1, kAxes, I16, Unit::None, {-3.0, 4.0}, 0.0, When::Ready, shown<identification_value::rotating, identification_value::select_rotating>, Output::No, "Rotating measurement selection", "at the next ON, with p1300 from 20 on: 1 without load, on a vector axis with encoder, 2 without load and encoder, 3 and 4 the same with load, which leaves the flux out; a servo has 1 for both; -1 measures for r19xx only; -3 takes over what r19xx has; other values are refused; reads 0 when done", Keep::No, check::rotating_selection},
    Row{1967, 1, kAxes, F32, Unit::Percent, {1.0, 400.0}, 100.0, When::Ready, setting<&Identification::Settings::speed_dynamics>, Output::No, "Rotating measurement speed controller dynamic factor", "p1960: gains of the speed controller that it computes go with it, integral times against it"},
    Row{1969, 1, kAxes, F32, Unit::KilogramSquareMetre, kWhole, 0.0, When::ReadOnly, shown<identification_value::inertia>, Output::No, "Moment of inertia identified", "of all that turns"},
    Row{1984, 1, kAxes, F32, Unit::Degrees, kWhole, 0.0, When::ReadOnly, shown<identification_value::pole_position>, Output::No, "Pole position identification angular difference", "electrical, of a synchronous machine past where the encoder has it"},
};
// clang-format on

}  // namespace drive::rows
