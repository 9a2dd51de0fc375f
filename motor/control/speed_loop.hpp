#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/signals.hpp"
#include "motor/control/speed_controller.hpp"
#include "motor/control/torque_limiter.hpp"

namespace motor {

/// From a command to the torque setpoint: smoothing of the measured speed, precontrol, speed controller or torque
/// control, and all limits.
class SpeedLoop {
 public:
  /// @p gains of the control mode in force; the torque comes @p delay (s) late.
  void configure(const ControlSettings& settings, const SpeedControllerGains& gains, double delay) noexcept {
    controller_.configure(gains, settings.inertia, kControlPeriod, delay);
    limiter_.configure(settings);
    precontrol_ = settings.acceleration_precontrol * settings.inertia;
    smoothing_ = kControlPeriod / (kControlPeriod + settings.speed_smoothing);
  }
  /// Starts at @p speed (rad/s) with @p torque (N·m).
  void reset(double speed, double torque = 0.0) noexcept {
    smoothed_ = speed;
    controller_.reset(speed, torque);
    limiter_.follow(speed);
  }
  /// Torque setpoint (N·m) for @p command at the measured @p speed (rad/s); @p reachable is what current and
  /// voltage allow (N·m). Fills limits and their status in @p signals.
  [[gnu::always_inline]] double step(const DriveCommand& command, double speed, double reachable,
                                     double dc_voltage, Signals& signals) noexcept {
    smoothed_ += smoothing_ * (speed - smoothed_);
    signals.torque_limits = limiter_.limits(command.limits, reachable, speed, dc_voltage);
    if (command.torque_control) return by_torque(command, signals);
    const TorqueForward forward{precontrol_ * command.acceleration_setpoint, command.additional_torque};
    signals.torque_setpoint = controller_.step(command.speed_setpoint, smoothed_, signals.torque_limits, forward);
    signals.torque_limit_reached = controller_.limited();
    return signals.torque_setpoint;
  }
  /// Power limits follow the speed; often enough every millisecond.
  void follow() noexcept { limiter_.follow(smoothed_); }

 private:
  double by_torque(const DriveCommand& command, Signals& signals) noexcept {
    const double wanted = command.torque_setpoint + command.additional_torque;
    const double torque = signals.torque_limits.bound(wanted);
    signals.torque_setpoint = torque;
    signals.torque_limit_reached = torque < wanted || torque > wanted;
    controller_.reset(smoothed_, torque - command.additional_torque);
    return torque;
  }

  SpeedController controller_;
  TorqueLimiter limiter_;
  double precontrol_ = 0.0;  // kg·m²
  double smoothing_ = 1.0;
  double smoothed_ = 0.0;  // rad/s
};

}  // namespace motor
