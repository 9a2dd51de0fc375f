#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/signals.hpp"
#include "motor/control/speed_controller.hpp"
#include "motor/control/torque_limiter.hpp"

namespace motor {

/// From a command to the torque setpoint: smoothing of the measured speed, precontrol, speed controller or torque
/// control, and all limits.
template <class Number>
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
  void reset(const Number& speed, const Number& torque = 0.0) noexcept {
    smoothed_ = speed;
    controller_.reset(speed, torque);
    limiter_.follow(speed, Condition<Number>{true});
  }
  /// Torque setpoint (N·m) for @p command at the measured @p speed (rad/s); @p reachable is what current and
  /// voltage allow (N·m). Fills limits and their status in @p signals.
  [[gnu::always_inline]] Number step(const DriveCommandOf<Number>& command, const Number& speed,
                                     const Number& reachable, const Number& dc_voltage,
                                     SignalsOf<Number>& signals) noexcept {
    smoothed_ += smoothing_ * (speed - smoothed_);
    signals.torque_limits = limiter_.limits(command.limits, reachable, speed, dc_voltage);
    if (!any(command.torque_control)) [[likely]]
      by_speed(command, signals);
    else if (all(command.torque_control))
      by_torque(command, signals);
    else
      by_either(command, signals);
    return signals.torque_setpoint;
  }
  /// Power limits follow the speed, where @p due; often enough every millisecond.
  void follow(const Condition<Number>& due) noexcept { limiter_.follow(smoothed_, due); }

 private:
  [[gnu::always_inline]] void by_speed(const DriveCommandOf<Number>& command,
                                       SignalsOf<Number>& signals) noexcept {
    const TorqueForward<Number> forward{precontrol_ * command.acceleration_setpoint, command.additional_torque};
    signals.torque_setpoint = controller_.step(command.speed_setpoint, smoothed_, signals.torque_limits, forward);
    signals.torque_limit_reached = controller_.limited();
  }
  void by_torque(const DriveCommandOf<Number>& command, SignalsOf<Number>& signals) noexcept {
    const Number wanted = command.torque_setpoint + command.additional_torque;
    const Number torque = signals.torque_limits.bound(wanted);
    signals.torque_setpoint = torque;
    signals.torque_limit_reached = torque < wanted || torque > wanted;
    controller_.reset(smoothed_, torque - command.additional_torque);
  }
  /// Some of the lanes have torque control.
  void by_either(const DriveCommandOf<Number>& command, SignalsOf<Number>& signals) noexcept {
    const SpeedController<Number> before = controller_;
    by_speed(command, signals);
    const SpeedController<Number> controller = controller_;
    const Number torque = signals.torque_setpoint;
    const Condition<Number> limited = signals.torque_limit_reached;
    controller_ = before;
    by_torque(command, signals);
    keep<Number>(command.torque_control, controller_, controller);
    signals.torque_setpoint = select<Number>(command.torque_control, signals.torque_setpoint, torque);
    signals.torque_limit_reached = select_condition(command.torque_control, signals.torque_limit_reached, limited);
  }

  SpeedController<Number> controller_;
  TorqueLimiter<Number> limiter_;
  Number precontrol_ = 0.0;  // kg·m²
  Number smoothing_ = 1.0;
  Number smoothed_ = 0.0;  // rad/s
};

}  // namespace motor
