#pragma once

#include <algorithm>
#include <cmath>

#include "tests/motor/reference/controlled_machines.hpp"

namespace motor {

inline constexpr double kDcVoltage = 540.0;  // V

/// A train under way, and what was seen of it since the last order.
class Trial {
 public:
  Trial(const MachineData& machine, ControlMode mode, const Load& load = {})
      : train{make_train(machine, mode, load)}, command{.pulses_enabled = true} {
    command.limits = {2.0 * machine.maximum_torque, -2.0 * machine.maximum_torque};
  }
  /// Lets @p seconds pass.
  void go(double seconds) {
    highest = -1e9;
    lowest = 1e9;
    current = 0.0;
    energy = 0.0;
    const int steps = static_cast<int>(std::lround(seconds / kControlPeriod));
    for (int i = 0; i < steps; ++i) step();
  }
  /// The same with a speed setpoint that jumps.
  void go_to(double speed, double seconds) {
    command.speed_setpoint = speed;
    go(seconds);
  }
  /// The same with a setpoint that changes by @p slope (rad/s²) until it is @p speed.
  void ramp_to(double speed, double slope, double seconds) {
    const double change = slope * kControlPeriod;
    const int steps = static_cast<int>(std::lround(seconds / kControlPeriod));
    go(0.0);
    for (int i = 0; i < steps; ++i) {
      const double way = std::clamp(speed - command.speed_setpoint, -change, change);
      command.speed_setpoint += way;
      command.acceleration_setpoint = way / kControlPeriod;
      step();
    }
  }

  DriveTrain train;
  DriveCommand command;
  double highest = 0.0;  // true speed (rad/s)
  double lowest = 0.0;   // true speed (rad/s)
  double current = 0.0;  // highest (A peak)
  double energy = 0.0;   // drawn from the DC link (J)

 private:
  void step() {
    energy += train.step(kDcVoltage, command);
    highest = std::max(highest, train.signals().true_speed);
    lowest = std::min(lowest, train.signals().true_speed);
    current = std::max(current, train.signals().current);
  }
};

}  // namespace motor
