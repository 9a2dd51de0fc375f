#include "motor/drive_train.hpp"

#include <cmath>

namespace motor {

DriveTrain::DriveTrain(const MachineData& machine, const Load& load, const InverterData& inverter) noexcept
    : machine_{machine},
      settings_{computed_settings(machine, inverter, machine.inertia + load.inertia)},
      mechanics_{machine, load},
      encoder_{machine} {
  current_loop_.configure(1.0 / kCurrentBandwidth, kControlPeriod);
  encoder_.configure(kControlPeriod);
  tune(settings_);
}

void DriveTrain::tune(const ControlSettings& settings) noexcept {
  settings_ = settings;
  speed_controller_.configure(settings_.speed, settings_.inertia, kControlPeriod);
}

void DriveTrain::tune(const SpeedControllerGains& gains) noexcept {
  settings_.speed = gains;
  tune(settings_);
}

void DriveTrain::set_machine(const MachineData& machine) noexcept {
  machine_ = machine;
}

double DriveTrain::torque_setpoint(const Command& command) noexcept {
  if (command.pulses_enabled && command.torque_control) {
    speed_controller_.reset(signals_.measured_speed);
    return command.limits.bound(command.torque_setpoint);
  }
  if (command.pulses_enabled)
    return speed_controller_.step(command.speed_setpoint, signals_.measured_speed, command.limits);
  speed_controller_.reset(signals_.measured_speed);
  current_loop_.inhibit();
  return 0.0;
}

double DriveTrain::step(double /*dc_voltage*/, const Command& command) noexcept {
  const double speed_before = mechanics_.speed();
  const double held = signals_.torque_setpoint;  // what is calculated in this period acts in the next
  signals_.torque_setpoint = torque_setpoint(command);
  signals_.torque = command.pulses_enabled ? current_loop_.step(held) : 0.0;
  signals_.true_torque = signals_.torque;
  mechanics_.step(kControlPeriod, signals_.torque);
  signals_.true_speed = mechanics_.speed();
  encoder_.turn(0.5 * (speed_before + signals_.true_speed) * kControlPeriod);
  signals_.measured_speed = encoder_.speed();
  signals_.encoder_counts = encoder_.counts();
  signals_.torque_limits = command.limits;
  signals_.torque_limit_reached = speed_controller_.limited();
  signals_.power = 0.5 * signals_.torque * (speed_before + signals_.true_speed);
  energies_ = {.electrical = signals_.power * kControlPeriod};
  return energies_.electrical;
}

void DriveTrain::rest(double /*duration*/) noexcept {}

StoredEnergy DriveTrain::stored() const noexcept {
  return {.kinetic = 0.5 * mechanics_.inertia() * mechanics_.speed() * mechanics_.speed()};
}

bool DriveTrain::rests() const noexcept {
  return mechanics_.rests() && std::abs(signals_.measured_speed) <= 0.0 && std::abs(signals_.torque) <= 0.0;
}

}  // namespace motor
