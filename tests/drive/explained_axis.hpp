#pragma once

#include <string>

#include "drive/explain/explain.hpp"
#include "tests/drive/wired_axis.hpp"

namespace drive {

/// The reasons as lines.
inline std::string told(const Axis& axis) {
  std::string lines;
  for (const std::string& sentence : explain(axis)) lines += sentence + "\n";
  return lines;
}

/// An axis in Operation enabled with a setpoint of 100 rpm and a ramp that takes no time.
struct Enabled : WiredAxis {
  explicit Enabled(double rpm = 100.0, const AxisConfiguration& configuration = {}) : WiredAxis{configuration} {
    inputs.on = true;
    inputs.main_setpoint = rpm * kRpm;
  }
  std::string told_after(int count = 5) {
    cycles(count);
    EXPECT_EQ(state(), State::OperationEnabled);
    return told(axis);
  }
};

}  // namespace drive
