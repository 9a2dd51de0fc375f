#include "drive/values/axis_values.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "drive/axis/axis.hpp"

namespace drive::axis_value {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;  // rad
constexpr double kKilowatt = 1e3;
constexpr double kWattHour = 3600.0;  // J
constexpr double kKilowattHour = 1e3 * kWattHour;
constexpr std::size_t kMotorEncoder = 0;

double rpm(double speed) noexcept {
  return speed / kRpm;
}

/// [0] balance, [1] drawn, [2] fed back, in units of @p unit (J).
double energy_in(double unit, const Axis& axis, std::size_t index) noexcept {
  const auto& power_unit = axis.block<PowerUnit>();
  const double drawn = power_unit.energy_drawn();
  const double fed_back = power_unit.energy_fed_back();
  const std::array values{drawn - fed_back, drawn, fed_back};
  return values[index] / unit;
}

}  // namespace

double no_value(const Axis&, std::size_t) noexcept {
  return 0.0;
}
double speed(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.actual().speed);
}
double encoder_speed(const Axis& axis, std::size_t index) noexcept {
  return index == kMotorEncoder ? rpm(axis.actual().speed) : 0.0;
}
double speed_demand(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.actual().speed_demand);
}
double speed_deviation(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.actual().speed_demand - axis.actual().speed);
}
double torque(const Axis& axis, std::size_t) noexcept {
  return axis.actual().torque;
}
double torque_demand(const Axis& axis, std::size_t) noexcept {
  return axis.actual().torque_demand;
}
double torque_utilisation(const Axis& axis, std::size_t) noexcept {
  const motor::TorqueLimits limits = axis.effective_torque_limits();
  const double torque = axis.actual().torque;
  const double limit = std::abs(torque < 0.0 ? limits.lower : limits.upper);
  return limit > 0.0 ? std::abs(torque) / limit / row_of(Unit::Percent).si : 0.0;
}
double upper_torque_limit(const Axis& axis, std::size_t) noexcept {
  return axis.effective_torque_limits().upper;
}
double lower_torque_limit(const Axis& axis, std::size_t) noexcept {
  return axis.effective_torque_limits().lower;
}
double active_power(const Axis& axis, std::size_t) noexcept {
  return axis.signals().power / kKilowatt;
}
double energy(const Axis& axis, std::size_t index) noexcept {
  return energy_in(kKilowattHour, axis, index);
}
double process_energy(const Axis& axis, std::size_t index) noexcept {
  return energy_in(kWattHour, axis, index);
}
double ramp_input(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.block<SetpointChannel>().input());
}
double ramp_output(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.block<SetpointChannel>().output());
}
double fixed_setpoint(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.block<SetpointChannel>().fixed_setpoint());
}
double setpoint_sum(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.block<SetpointChannel>().sum());
}
double directed_setpoint(const Axis& axis, std::size_t) noexcept {
  return rpm(axis.block<SetpointChannel>().directed());
}
double ramp_acceleration(const Axis& axis, std::size_t) noexcept {
  return axis.block<SetpointChannel>().mean_acceleration() / kRevolution;
}
double reference_power(const Axis& axis, std::size_t) noexcept {
  return axis.references().speed * axis.references().torque / kKilowatt;
}
double starting_time(const Axis& axis, std::size_t) noexcept {
  const double torque = axis.effective_torque_limits().upper;
  return torque > 0.0 ? axis.block<MotorModel>().total_inertia() * axis.references().maximum_speed / torque : 0.0;
}
double pole_pairs(const Axis& axis, std::size_t) noexcept {
  return axis.block<MotorModel>().pole_pairs();
}
double function_modules(const Axis& axis, std::size_t) noexcept {
  return axis.function_modules();
}
double mode(const Axis& axis, std::size_t) noexcept {
  return axis.actual().mode;
}
double encoder_position(const Axis& axis, std::size_t index) noexcept {
  return index == kMotorEncoder ? static_cast<double>(static_cast<std::uint32_t>(axis.actual().encoder_position))
                                : 0.0;
}
void compute_parameters(Axis& axis, std::size_t, double value) noexcept {
  axis.compute_parameters(static_cast<int>(value));
}

void reset_parameters(Axis& axis, std::size_t, double value) noexcept {
  constexpr int kReset = 1;
  if (static_cast<int>(value) != kReset) return;
  axis.restore_parameters();
  axis.leave_commissioning();
}

}  // namespace drive::axis_value
