#include "motor/synchronous_machine.hpp"

#include <cmath>
#include <limits>

#include "motor/temperature.hpp"

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
    : pole_pairs_{static_cast<double>(machine.pole_pairs)},
      torque_factor_{1.5 * pole_pairs_},
      l_d_{machine.synchronous.d_inductance},
      l_q_{machine.synchronous.q_inductance},
      inverse_l_d_{1.0 / l_d_},
      inverse_l_q_{1.0 / l_q_},
      cold_resistance_{machine.stator_resistance},
      cold_magnet_flux_{machine.synchronous.magnet_flux},
      temperature_coefficient_{machine.synchronous.magnet_temperature_coefficient},
      resistance_{cold_resistance_},
      magnet_flux_{cold_magnet_flux_},
      saturation_start_{std::numeric_limits<double>::infinity()},
      saturation_knee_{saturation_start_},
      saturation_end_{saturation_start_} {
  const double stall = 2.0 * machine.stall_current * machine.stall_current;
  const double most = 2.0 * machine.maximum_current * machine.maximum_current;
  if (machine.synchronous.torque_saturation <= 0.0 || stall <= 0.0 || most <= (1.0 + kBend) * stall) return;
  saturation_start_ = (1.0 - kBend) * stall;
  saturation_knee_ = (1.0 + kBend) * stall;
  saturation_end_ = most;
  saturation_gain_ = std::min(machine.synchronous.torque_saturation / (most - stall),
                              kLargestCoupling * std::sqrt(l_d_ * l_q_ / (4.0 * most)) / cold_magnet_flux_);
}

void SynchronousMachine::set_temperatures(double winding, double rotor) noexcept {
  resistance_ = cold_resistance_ * resistance_factor(winding);
  magnet_flux_ = cold_magnet_flux_ * (1.0 + temperature_coefficient_ * (rotor - kDataTemperature));
}

SynchronousMachine::Saturation SynchronousMachine::saturation(double i_q) const noexcept {
  const double square = i_q * i_q;
  if (!(square > saturation_start_)) return {};
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
  const double gain = saturation_gain_ * magnet_flux_;
  return {gain * share, 2.0 * gain * slope * i_q, gain * (4.0 * curvature * square + 2.0 * slope)};
}

SynchronousMachine::Rate SynchronousMachine::saturated_rate(const State& y, SpaceVector u,
                                                            double w_e) const noexcept {
  const Saturation s = saturation(y.i_q);
  const SpaceVector psi{l_d_ * y.i_d + magnet_flux_ - s.loss, l_q_ * y.i_q - s.slope * y.i_d};
  const double e_d = u.re - resistance_ * y.i_d + w_e * psi.im;
  const double e_q = u.im - resistance_ * y.i_q - w_e * psi.re;
  const double l_qq = std::max(l_q_ - s.curvature * y.i_d, kLeastInductance * l_q_);
  const double scale = 1.0 / (l_d_ * l_qq - s.slope * s.slope);
  return {(l_qq * e_d + s.slope * e_q) * scale, (s.slope * e_d + l_d_ * e_q) * scale,
          torque_factor_ * cross(psi, {y.i_d, y.i_q}), u.re * y.i_d + u.im * y.i_q, y.i_d * y.i_d + y.i_q * y.i_q};
}

}  // namespace motor
