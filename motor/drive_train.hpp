#pragma once

#include <cstdint>

#include "motor/control_period.hpp"
#include "motor/current_loop.hpp"
#include "motor/encoder.hpp"
#include "motor/load.hpp"
#include "motor/machine_data.hpp"
#include "motor/mechanics.hpp"
#include "motor/speed_controller.hpp"

namespace motor {

/// What a drive train is told for one step.
struct Command {
  bool pulses_enabled = false;  ///< off: no torque, the controllers are emptied, the shaft coasts
  double speed_setpoint = 0.0;  ///< rad/s
  TorqueLimits limits{};
};

/// What can be seen of a drive train after a step.
struct Signals {
  double measured_speed = 0.0;        ///< from the encoder, what the controller sees (rad/s)
  double true_speed = 0.0;            ///< of the shaft (rad/s)
  double torque_setpoint = 0.0;       ///< r0079 (N·m)
  double torque = 0.0;                ///< r0080, mean of the period (N·m)
  std::int64_t encoder_counts = 0;    ///< increments since power-on
  bool torque_limit_reached = false;  ///< r1407.7
};

/// Speed controller gains for @p machine with @p load, from the inertia and the sum of the loop's delays.
SpeedControllerGains default_gains(const MachineData& machine, const Load& load) noexcept;

/// One speed-controlled machine: speed controller, current loop, shaft and encoder in a closed loop.
class DriveTrain {
 public:
  DriveTrain(const MachineData& machine, const Load& load) noexcept;

  /// Changes the gains of the speed controller; what it has integrated stays.
  void tune(const SpeedControllerGains& gains) noexcept;
  /// Advances by @p dt (s), normally kControlPeriod, with @p command held.
  void step(double dt, const Command& command) noexcept;
  /// Replaces the constant load torque (N·m, positive against positive rotation).
  void set_load_torque(double torque) noexcept { mechanics_.set_load_torque(torque); }
  /// The state after the last step.
  const Signals& signals() const noexcept { return signals_; }
  /// Whether nothing changes any more while the pulses are off.
  bool rests() const noexcept;

 private:
  void configure(double period) noexcept;
  double torque_setpoint(const Command& command) noexcept;

  double current_loop_time_constant_;
  SpeedControllerGains gains_;
  double period_ = kControlPeriod;
  SpeedController speed_controller_;
  CurrentLoop current_loop_;
  Mechanics mechanics_;
  Encoder encoder_;
  Signals signals_;
};

}  // namespace motor
