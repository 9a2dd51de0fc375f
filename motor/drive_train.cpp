#include "motor/drive_train.hpp"

#include <cmath>

namespace motor {
namespace {

constexpr double kCurrentLoopTimeConstant = 400e-6;  // s

}  // namespace

SpeedControllerGains default_gains(const MachineData& machine, const Load& load) noexcept {
  Encoder encoder{machine};
  encoder.configure(kControlPeriod);
  // Calculation (one period), output hold and difference quotient (half a period each), torque response, speed
  // filter.
  const double delay = 2.0 * kControlPeriod + kCurrentLoopTimeConstant + encoder.filter_time();
  return {.proportional = (machine.inertia + load.inertia) / (3.0 * delay), .integral_time = 10.0 * delay};
}

DriveTrain::DriveTrain(const MachineData& machine, const Load& load) noexcept
    : current_loop_time_constant_{kCurrentLoopTimeConstant},
      gains_{default_gains(machine, load)},
      mechanics_{machine, load},
      encoder_{machine} {
  configure(kControlPeriod);
}

void DriveTrain::tune(const SpeedControllerGains& gains) noexcept {
  gains_ = gains;
  speed_controller_.configure(gains_, mechanics_.inertia(), period_);
}

void DriveTrain::configure(double period) noexcept {
  period_ = period;
  current_loop_.configure(current_loop_time_constant_, period);
  encoder_.configure(period);
  tune(gains_);
}

double DriveTrain::torque_setpoint(const Command& command) noexcept {
  if (command.pulses_enabled)
    return speed_controller_.step(command.speed_setpoint, signals_.measured_speed, command.limits);
  speed_controller_.reset(signals_.measured_speed);
  current_loop_.inhibit();
  return 0.0;
}

void DriveTrain::step(double dt, const Command& command) noexcept {
  if (dt < period_ || dt > period_) configure(dt);
  const double speed_before = mechanics_.speed();
  const double held = signals_.torque_setpoint;  // what is calculated in this period acts in the next
  signals_.torque_setpoint = torque_setpoint(command);
  signals_.torque = command.pulses_enabled ? current_loop_.step(held) : 0.0;
  mechanics_.step(dt, signals_.torque);
  signals_.true_speed = mechanics_.speed();
  encoder_.turn(0.5 * (speed_before + signals_.true_speed) * dt);
  signals_.measured_speed = encoder_.speed();
  signals_.encoder_counts = encoder_.counts();
  signals_.torque_limit_reached = speed_controller_.limited();
}

bool DriveTrain::rests() const noexcept {
  return mechanics_.rests() && std::abs(signals_.measured_speed) <= 0.0 && std::abs(signals_.torque) <= 0.0;
}

}  // namespace motor
