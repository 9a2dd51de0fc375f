#pragma once

#include "motor/data/machine_data.hpp"

namespace motor {

/// By what factors a real machine differs from its data sheet; all are positive.
struct PlantDeviation {
  double stator_resistance = 1.0;
  double d_inductance = 1.0;  ///< of a synchronous machine, as the next two
  double q_inductance = 1.0;
  double magnet_flux = 1.0;
  double rotor_resistance = 1.0;  ///< of an induction machine, as the next four
  double stator_leakage = 1.0;
  double rotor_leakage = 1.0;
  double magnetising_inductance = 1.0;
  double saturation_flux = 1.0;
  double inertia = 1.0;   ///< of the rotor
  double friction = 1.0;  ///< of bearings and seals

  friend bool operator==(const PlantDeviation&, const PlantDeviation&) = default;
};

/// What turns where the data sheet says @p machine.
constexpr MachineData real_machine(const MachineData& machine, const PlantDeviation& deviation) noexcept {
  MachineData real = machine;
  real.stator_resistance *= deviation.stator_resistance;
  real.synchronous.d_inductance *= deviation.d_inductance;
  real.synchronous.q_inductance *= deviation.q_inductance;
  real.synchronous.magnet_flux *= deviation.magnet_flux;
  real.induction.rotor_resistance *= deviation.rotor_resistance;
  real.induction.stator_leakage *= deviation.stator_leakage;
  real.induction.rotor_leakage *= deviation.rotor_leakage;
  real.induction.magnetising_inductance *= deviation.magnetising_inductance;
  real.induction.saturation_flux *= deviation.saturation_flux;
  real.inertia *= deviation.inertia;
  real.coulomb_friction *= deviation.friction;
  real.viscous_friction *= deviation.friction;
  return real;
}

}  // namespace motor
