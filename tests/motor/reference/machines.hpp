#pragma once

#include <array>
#include <string_view>

#include "motor/data/machine_data.hpp"

namespace machines {

/// A machine that the tests run through.
struct Named {
  std::string_view name;
  motor::MachineData data;
};

/// Servos and induction machines between 0.8 and 12 kW, and academic ones with published data; values as in the
/// presets.
inline const std::array<Named, 8>& all() {
  using motor::kRpm;
  using motor::MachineType;
  static const std::array<Named, 8> kAll{{
      {"servo 1FT7044",
       {.pole_pairs = 3,
        .rated_current = 2.5,
        .rated_speed = 6000 * kRpm,
        .maximum_speed = 9000 * kRpm,
        .stall_current = 5.7,
        .maximum_current = 30.0,
        .stator_resistance = 0.61,
        .synchronous =
            {.d_inductance = 4.2e-3, .q_inductance = 4.2e-3, .magnet_flux = 0.14814, .torque_saturation = 0.126},
        .inertia = 5.43e-4,
        .coulomb_friction = 0.04,
        .viscous_friction = 5e-5,
        .hysteresis_torque = 0.03,
        .eddy_current_drag = 6e-5}},
      {"servo 1FK7042",
       {.pole_pairs = 4,
        .rated_current = 1.95,
        .rated_speed = 3000 * kRpm,
        .maximum_speed = 9000 * kRpm,
        .stall_current = 2.2,
        .maximum_current = 8.3,
        .stator_resistance = 3.9,
        .synchronous = {.d_inductance = 17.5e-3,
                        .q_inductance = 17.5e-3,
                        .magnet_flux = 0.17153,
                        .torque_saturation = 0.0723},
        .inertia = 2.9e-4,
        .coulomb_friction = 0.03,
        .viscous_friction = 5e-5}},
      {"servo 1FK7063", {}},
      {"induction 2.2 kW",
       {.type = MachineType::Induction,
        .pole_pairs = 2,
        .rated_current = 4.55,
        .rated_speed = 1455 * kRpm,
        .maximum_speed = 4200 * kRpm,
        .stator_resistance = 2.14,
        .induction = {.saturation_flux = 1.2},
        .inertia = 0.014,
        .coulomb_friction = 0.05,
        .viscous_friction = 3e-4,
        .hysteresis_torque = 0.3,
        .eddy_current_drag = 2e-3}},
      {"induction 12 kW",
       {.type = MachineType::Induction,
        .pole_pairs = 2,
        .rated_current = 24.5,
        .rated_speed = 1500 * kRpm,
        .maximum_speed = 8000 * kRpm,
        .stator_resistance = 0.376,
        .induction = {.rotor_resistance = 0.2813,
                      .stator_leakage = 1.72e-3,
                      .rotor_leakage = 1.72e-3,
                      .magnetising_inductance = 51.46e-3,
                      .magnetising_current = 13.4},
        .inertia = 0.109,
        .coulomb_friction = 0.3,
        .viscous_friction = 1e-3,
        .hysteresis_torque = 1.0,
        .eddy_current_drag = 5e-3}},
      {"salient 2.2 kW",
       {.pole_pairs = 3,
        .rated_current = 4.3,
        .rated_speed = 1500 * kRpm,
        .maximum_speed = 3000 * kRpm,
        .stall_current = 4.3,
        .maximum_current = 8.6,
        .stator_resistance = 3.6,
        .synchronous =
            {.d_inductance = 36e-3, .q_inductance = 51e-3, .magnet_flux = 0.545, .torque_saturation = 0.05},
        .inertia = 0.015}},
      {"academic induction 2.2 kW",
       {.type = MachineType::Induction,
        .pole_pairs = 2,
        .rated_speed = 1430 * kRpm,
        .maximum_speed = 3000 * kRpm,
        .stator_resistance = 3.7,
        .induction = {.rotor_resistance = 2.296875,
                      .stator_leakage = 10.7352e-3,
                      .rotor_leakage = 10.7352e-3,
                      .magnetising_inductance = 234.2648e-3},
        .inertia = 0.015}},
      {"academic induction 4 kW",
       {.type = MachineType::Induction,
        .pole_pairs = 2,
        .rated_speed = 1430 * kRpm,
        .maximum_speed = 3000 * kRpm,
        .stator_resistance = 2.9338,
        .induction = {.rotor_resistance = 1.355,
                      .stator_leakage = 5.87e-3,
                      .rotor_leakage = 5.87e-3,
                      .magnetising_inductance = 143.75e-3},
        .inertia = 0.0011}},
  }};
  return kAll;
}

}  // namespace machines
