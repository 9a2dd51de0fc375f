#pragma once

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "drive/axis/axis.hpp"
#include "drive/base/units.hpp"

namespace drive {

/// An axis with the master's side of it: a controlword and a speed setpoint that are sent every 4 ms.
struct TestAxis {
  static constexpr double kCycle = 0.004;  // s

  Axis axis;
  Setpoints setpoints{};

  explicit TestAxis(const AxisConfiguration& configuration = {}) : axis{configuration} {}

  /// Sends @p controlword for one cycle and returns the statusword.
  std::uint16_t send(std::uint16_t controlword) {
    setpoints.controlword = controlword;
    axis.cycle(setpoints, kCycle);
    return axis.actual().statusword;
  }
  /// Goes on with the same setpoints for @p seconds.
  void run(double seconds) {
    const auto cycles = std::lround(seconds / kCycle);
    for (long i = 0; i < cycles; ++i) axis.cycle(setpoints, kCycle);
  }
  /// Cycles until @p done(axis) or @p limit (s); returns the time it took.
  template <class Condition>
  double run_until(Condition done, double limit) {
    double time = 0.0;
    while (!done(axis) && time < limit) {
      axis.cycle(setpoints, kCycle);
      time += kCycle;
    }
    return time;
  }
  /// Switches on and waits in Operation enabled with @p rpm as the setpoint.
  void enable(double rpm = 0.0) {
    setpoints.speed = rpm * kRpm;
    for (const int controlword : {0x0006, 0x0006, 0x0007, 0x000F}) send(static_cast<std::uint16_t>(controlword));
  }
  /// Turns steadily at @p rpm: ramps of no time, then a second to settle.
  void turn_at(double rpm) {
    const double up = axis.read(1120).value();
    EXPECT_TRUE(axis.write(1120, 0.0));
    enable(rpm);
    run(1.0);
    EXPECT_TRUE(axis.write(1120, up));
  }
  /// Speed actual value (rpm).
  double rpm() const { return axis.actual().speed / kRpm; }
  /// Speed setpoint behind the ramp (rpm).
  double demand_rpm() const { return axis.actual().speed_demand / kRpm; }
  State state() const { return axis.actual().state; }
  std::uint16_t status() const { return axis.actual().statusword; }
};

}  // namespace drive
