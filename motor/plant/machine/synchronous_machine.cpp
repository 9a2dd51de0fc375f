#include "motor/plant/machine/synchronous_machine.hpp"

#include <cmath>
#include <limits>

#include "motor/plant/machine/temperature.hpp"

namespace motor {
namespace {

/// Half the width of the bend at the stall current, as a share of its square.
constexpr double kBend = 0.5;
/// Largest coupling of both axes by saturation, as a share of sqrt(L_d L_q): beyond, the machine were unstable.
constexpr double kLargestCoupling = 0.4;

}  // namespace

SynchronousMachine::SynchronousMachine(const MachineData& machine) noexcept
    : cold_resistance_{machine.stator_resistance},
      cold_magnet_flux_{machine.synchronous.magnet_flux},
      temperature_coefficient_{machine.synchronous.magnet_temperature_coefficient} {
  inductance_ = Pair{machine.synchronous.d_inductance, machine.synchronous.q_inductance};
  inverse_inductance_ = 1.0 / inductance_;
  magnets_ = Pair{machine.synchronous.magnet_flux, 0.0};
  pole_pairs_ = static_cast<double>(machine.pole_pairs);
  torque_factor_ = 1.5 * pole_pairs_;
  resistance_ = both(cold_resistance_);
  saturation_start_ = saturation_knee_ = saturation_end_ = std::numeric_limits<double>::infinity();
  signed_pole_pairs_ = Pair{pole_pairs_, -pole_pairs_};
  set_factors();
  const double stall = 2.0 * machine.stall_current * machine.stall_current;
  const double most = 2.0 * machine.maximum_current * machine.maximum_current;
  if (machine.synchronous.torque_saturation <= 0.0 || stall <= 0.0 || most <= (1.0 + kBend) * stall) return;
  saturation_start_ = (1.0 - kBend) * stall;
  saturation_knee_ = (1.0 + kBend) * stall;
  saturation_end_ = most;
  saturation_gain_ =
      std::min(machine.synchronous.torque_saturation / (most - stall),
               kLargestCoupling * std::sqrt(inductance_[0] * inductance_[1] / (4.0 * most)) / cold_magnet_flux_);
}

void SynchronousMachine::set_temperatures(double winding, double rotor) noexcept {
  resistance_ = both(cold_resistance_ * resistance_factor(winding));
  magnets_[0] = cold_magnet_flux_ * (1.0 + temperature_coefficient_ * (rotor - kDataTemperature));
  set_factors();
}

void SynchronousMachine::set_factors() noexcept {
  damping_ = resistance_ * inverse_inductance_;
  exchange_ = signed_pole_pairs_ * inverse_inductance_ * swapped(inductance_);
  induction_ = signed_pole_pairs_ * inverse_inductance_ * swapped(magnets_);
  magnet_torque_ = torque_factor_ * magnets_[0];
  reluctance_torque_ = torque_factor_ * difference(inductance_);
}

}  // namespace motor
