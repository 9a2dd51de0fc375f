#include <cmath>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "drive/axis/axis.hpp"

namespace bench {
namespace {

constexpr double kCycle = 4e-3;        // s
constexpr double kRunUp = 5.0;         // s, more than any ramp of a new axis takes
constexpr std::uint16_t kOff1 = 0x06;  // controlwords in the order of switching on
constexpr std::uint16_t kReady = 0x07;
constexpr std::uint16_t kRun = 0x0F;

/// One process-data cycle of an axis in a steady state.
struct AxisCycle {
  explicit AxisCycle(const drive::Setpoints& held) : setpoints{held} {
    drive::Setpoints off = held;
    for (const std::uint16_t word : {std::uint16_t{0}, kOff1, kReady}) {
      off.controlword = word;
      if (word > held.controlword) break;
      for (int i = 0; i < 3; ++i) axis.cycle(off, kCycle);
    }
    for (double t = 0.0; t < kRunUp; t += kCycle) axis.cycle(setpoints, kCycle);
  }
  void step() { axis.cycle(setpoints, kCycle); }

  drive::Axis axis{{}};
  drive::Setpoints setpoints;
};

struct Turning : AxisCycle {
  static constexpr double kSpeed = 100.0;  // rad/s
  Turning() : AxisCycle{{.controlword = kRun, .speed = kSpeed}} {
    check(std::abs(axis.actual().speed - kSpeed) < 1.0, "speed of a turning axis");
  }
};

struct Holding : AxisCycle {
  Holding() : AxisCycle{{.controlword = kRun}} {
    check(axis.actual().pulses_enabled && std::abs(axis.actual().speed) < 0.01, "an axis that holds speed 0");
  }
};

struct Off : AxisCycle {
  Off() : AxisCycle{{.controlword = kOff1}} { check(axis.is_quiescent(), "an axis with its pulses off"); }
};

}  // namespace

std::vector<OperationRow> axis_operations() {
  return {
      {"axis/turning", "4 ms of one axis at speed", make<Turning>},
      {"axis/holding", "4 ms of one axis that holds speed 0", make<Holding>},
      {"axis/off", "4 ms of one axis with its pulses off", make<Off>},
  };
}

}  // namespace bench
