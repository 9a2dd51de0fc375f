#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/messages.hpp"
#include "tests/drive/test_axis.hpp"

namespace drive {

/// An axis whose inputs are set one by one; it starts in Ready to switch on with everything enabled but ON.
struct WiredAxis {
  static constexpr double kCycle = TestAxis::kCycle;

  Axis axis;
  AxisInputs inputs{};

  explicit WiredAxis(const AxisConfiguration& configuration = {}) : axis{configuration} {
    EXPECT_TRUE(axis.write(1120, 0.0));
    cycles(2);
    EXPECT_EQ(state(), State::ReadyToSwitchOn);
  }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) cycle(axis, inputs, kCycle);
  }
  void run(double seconds) { cycles(static_cast<int>(std::lround(seconds / kCycle))); }
  void turn_at(double rpm) {
    inputs.on = true;
    inputs.main_setpoint = rpm * kRpm;
    run(1.0);
    EXPECT_NEAR(axis.actual().speed / kRpm, rpm, 1.0);
  }
  State state() const { return axis.actual().state; }
  double rpm() const { return axis.actual().speed / kRpm; }
  unsigned word(std::uint16_t number) const { return static_cast<unsigned>(axis.read(number).value()); }
  bool has(std::uint16_t number) const { return has_message(axis, number); }
  bool acknowledge() {
    inputs.acknowledge_1 = true;
    cycles(1);
    inputs.acknowledge_1 = false;
    cycles(1);
    return axis.messages().faults().empty();
  }
};

}  // namespace drive
