#include "tests/motor/reference/reference_control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference {
namespace {

using motor::SpaceVector;

SpaceVector at_angle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Shortens @p voltage to @p limit; whether it had to.
bool limit_length(SpaceVector& voltage, double limit) {
  const double amplitude = motor::length(voltage);
  if (amplitude <= limit) return false;
  voltage = limit / amplitude * voltage;
  return true;
}

}  // namespace

SpeedPi::SpeedPi(double gain, double integral_time, double torque_limit, double period) noexcept
    : gain_{gain}, integral_gain_{gain / integral_time * period}, limit_{torque_limit} {}

SpeedPi::SpeedPi(const File& file)
    : SpeedPi{file.number("/controller/Kp_n"), file.number("/controller/Tn_n"), file.number("/controller/T_max"),
              file.number("/controller/T_s")} {}

double SpeedPi::step(double setpoint, double speed) noexcept {
  const double error = setpoint - speed;
  const double wanted = gain_ * error + integral_;
  const double torque = std::clamp(wanted, -limit_, limit_);
  const double cut = wanted - torque;
  if (cut * error <= 0.0) integral_ += integral_gain_ * error;
  return torque;
}

SynchronousControl::SynchronousControl(const File& file)
    : speed_{file},
      period_{file.number("/controller/T_s")},
      pole_pairs_{file.number("/plant/n_p")},
      l_d_{file.number("/plant/L_d")},
      l_q_{file.number("/plant/L_q")},
      magnet_flux_{file.number("/plant/psi_f")},
      current_limit_{file.number("/controller/I_max")},
      voltage_limit_{file.number("/controller/k_u") * file.number("/plant/u_dc") / std::numbers::sqrt3},
      kp_d_{file.number("/controller/Kp_d")},
      kp_q_{file.number("/controller/Kp_q")},
      ki_d_{file.number("/controller/Ki_d")},
      ki_q_{file.number("/controller/Ki_q")} {}

SpaceVector SynchronousControl::step(double speed_setpoint, const Measured& measured) {
  const SpaceVector i = measured.current * conjugate(at_angle(measured.angle));
  const double w_e = pole_pairs_ * measured.speed;
  torque_ = speed_.step(speed_setpoint, measured.speed);
  i_q_setpoint_ = std::clamp(torque_ / (1.5 * pole_pairs_ * magnet_flux_), -current_limit_, current_limit_);
  const SpaceVector error{-i.re, i_q_setpoint_ - i.im};
  SpaceVector voltage{kp_d_ * error.re + integral_.re - w_e * l_q_ * i.im,
                      kp_q_ * error.im + integral_.im + w_e * (l_d_ * i.re + magnet_flux_)};
  if (!limit_length(voltage, voltage_limit_))
    integral_ = integral_ + period_ * SpaceVector{ki_d_ * error.re, ki_q_ * error.im};
  return voltage * at_angle(measured.angle + 1.5 * w_e * period_);
}

InductionControl::InductionControl(const File& file)
    : speed_{file},
      period_{file.number("/controller/T_s")},
      pole_pairs_{file.number("/plant/n_p")},
      rotor_resistance_{file.number("/plant/R_R")},
      leakage_{file.number("/plant/L_sgm")},
      magnetising_{file.number("/plant/L_M")},
      flux_setpoint_{file.number("/controller/psi_R_ref")},
      current_limit_{file.number("/controller/I_max")},
      voltage_limit_{file.number("/controller/k_u") * file.number("/plant/u_dc") / std::numbers::sqrt3},
      kp_{file.number("/controller/Kp_i")},
      ki_{file.number("/controller/Ki_i")} {}

SpaceVector InductionControl::step(bool magnetising, double speed_setpoint, const Measured& measured) {
  direction_ = at_angle(angle_);
  const SpaceVector i = measured.current * conjugate(direction_);
  torque_ = magnetising ? 0.0 : speed_.step(speed_setpoint, measured.speed);
  const double flux = std::max(flux_, 0.1 * flux_setpoint_);
  const double i_d_setpoint = flux_setpoint_ / magnetising_;
  const double most = std::sqrt(current_limit_ * current_limit_ - i_d_setpoint * i_d_setpoint);
  i_q_setpoint_ = std::clamp(torque_ / (1.5 * pole_pairs_ * flux), -most, most);
  const double w = pole_pairs_ * measured.speed;
  const double w_s = w + rotor_resistance_ * i.im / flux;
  const double rate = rotor_resistance_ / magnetising_;
  const SpaceVector error{i_d_setpoint - i.re, i_q_setpoint_ - i.im};
  SpaceVector voltage =
      kp_ * error + integral_ + w_s * leakage_ * SpaceVector{-i.im, i.re} + flux_ * SpaceVector{-rate, w};
  if (!limit_length(voltage, voltage_limit_)) integral_ = integral_ + ki_ * period_ * error;
  const SpaceVector applied = voltage * at_angle(angle_ + 1.5 * w_s * period_);
  flux_ += period_ * (rotor_resistance_ * i.re - rate * flux_);
  angle_ += period_ * w_s;
  return applied;
}

FrequencyControl::FrequencyControl(const File& file)
    : period_{file.number("/controller/T_s")},
      rated_voltage_{file.number("/controller/U_rated")},
      rated_frequency_{file.number("/controller/f_rated")},
      set_frequency_{file.number("/controller/f_set")},
      boost_{file.number("/controller/U_boost")},
      on_{file.number("/controller/t_on")},
      start_{file.number("/controller/t_start")},
      ramp_{file.number("/controller/t_ramp")},
      voltage_limit_{file.number("/plant/u_dc") / std::numbers::sqrt3} {}

SpaceVector FrequencyControl::step(double time) {
  frequency_ = set_frequency_ * std::clamp((time - start_) / ramp_, 0.0, 1.0);
  const double share = frequency_ / rated_frequency_;
  const double lines = rated_voltage_ * std::min(share, 1.0) + boost_ * std::max(0.0, 1.0 - share);
  const double amplitude = time < on_ ? 0.0 : std::min(std::sqrt(2.0 / 3.0) * lines, voltage_limit_);
  const double w_s = 2.0 * std::numbers::pi * frequency_;
  const SpaceVector voltage = amplitude * at_angle(angle_ + 0.5 * w_s * period_);
  angle_ += w_s * period_;
  return voltage;
}

}  // namespace reference
