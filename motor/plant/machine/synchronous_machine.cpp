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
/// Least share of L_q that saturation leaves.
constexpr double kLeastInductance = 0.25;

}  // namespace

SynchronousMachine::SynchronousMachine(const MachineData& machine) noexcept
    : inductance_{machine.synchronous.d_inductance, machine.synchronous.q_inductance},
      inverse_inductance_{1.0 / inductance_},
      magnets_{machine.synchronous.magnet_flux, 0.0},
      pole_pairs_{static_cast<double>(machine.pole_pairs)},
      torque_factor_{1.5 * pole_pairs_},
      cold_resistance_{machine.stator_resistance},
      cold_magnet_flux_{machine.synchronous.magnet_flux},
      temperature_coefficient_{machine.synchronous.magnet_temperature_coefficient},
      resistance_{both(cold_resistance_)},
      saturation_start_{std::numeric_limits<double>::infinity()},
      saturation_knee_{saturation_start_},
      saturation_end_{saturation_start_} {
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

SynchronousMachine::Saturation SynchronousMachine::saturation(double i_q) const noexcept {
  const double square = i_q * i_q;
  if (square <= saturation_start_) return {};
  // Share of the flux over i_q²: a parabola through the bend, a line, and a parabola that ends level, because no
  // more can be lost than all.
  const double width = saturation_knee_ - saturation_start_;
  const double line = 0.5 * (saturation_start_ + saturation_knee_);
  double share = square - line;
  double slope = 1.0;
  double curvature = 0.0;
  if (square < saturation_knee_) {
    const double into = square - saturation_start_;
    share = 0.5 * into * into / width;
    slope = into / width;
    curvature = 1.0 / width;
  } else if (square > saturation_end_) {
    const double tail = saturation_end_ - line;
    const double beyond = std::min(square - saturation_end_, tail);
    share = tail + beyond - 0.5 * beyond * beyond / tail;
    slope = 1.0 - beyond / tail;
    curvature = beyond < tail ? -1.0 / tail : 0.0;
  }
  const double gain = saturation_gain_ * magnets_[0];
  return {gain * share, 2.0 * gain * slope * i_q, gain * (4.0 * curvature * square + 2.0 * slope)};
}

SynchronousMachine::Rate SynchronousMachine::saturated_rate(const CircuitState& y, Pair u,
                                                            double w) const noexcept {
  const Pair i = y.current;
  const Saturation s = saturation(i[1]);
  const Pair psi = inductance_ * i + magnets_ - Pair{s.loss, s.slope * i[0]};
  const Pair rest = u - resistance_ * i + both(w) * signed_pole_pairs_ * swapped(psi);
  const double l_d = inductance_[0];
  const double l_q = std::max(inductance_[1] - s.curvature * i[0], kLeastInductance * inductance_[1]);
  const double scale = 1.0 / (l_d * l_q - s.slope * s.slope);
  return {scale * Pair{l_q * rest[0] + s.slope * rest[1], s.slope * rest[0] + l_d * rest[1]}, u * i, i * i,
          torque_factor_ * cross(psi, i)};
}

}  // namespace motor
