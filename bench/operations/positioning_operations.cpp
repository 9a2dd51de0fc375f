#include <array>
#include <cmath>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "drive/drive_unit.hpp"

namespace bench {
namespace {

constexpr double kCycle = 4e-3;  // s
constexpr double kRunUp = 2.0;   // s
constexpr std::uint8_t kAxis = drive::kFirstAxisNumber;

/// One process-data cycle of a unit of one axis that is switched on, with its wiring.
struct UnitCycle {
  explicit UnitCycle(bool positioner) : unit{configuration(positioner)} {}

  static drive::UnitConfiguration configuration(bool positioner) {
    drive::AxisConfiguration axis{};
    axis.positioner = positioner;
    return {.axes = {axis}, .node_id = 5};
  }
  void set(std::uint16_t number, double value) {
    const drive::DataType type = drive::find_parameter(drive::ObjectKind::Servo, number)->row->type;
    check(unit.write(kAxis, number, 0, drive::encode(type, value)).has_value(), "a parameter of the axis");
  }
  void command(std::uint16_t controlword) {
    unit.axes()[0].process_data().received[0] = controlword;
    for (int i = 0; i < 3; ++i) step();
  }
  void switch_on() {
    for (const int word : {0x06, 0x07, 0x0F}) command(static_cast<std::uint16_t>(word));
    for (double t = 0.0; t < kRunUp; t += kCycle) step();
  }
  void step() {
    constexpr std::array kAwake{true};
    unit.cycle(kAwake, kCycle);
  }

  drive::DriveUnit unit;
};

constexpr double kVelocity = 6000.0;   // 1000 LU/min
constexpr double kSpeed = 62.8318531;  // rad/s, of that

struct SpeedControlled : UnitCycle {
  SpeedControlled() : UnitCycle{false} {
    constexpr double kShare = 0x4000;
    switch_on();
    const double reference = unit.axes()[0].references().speed;
    drive::ProcessDataImage& image = unit.axes()[0].process_data();
    image.received[1] = static_cast<std::uint16_t>(kSpeed / reference * kShare);
    for (double t = 0.0; t < kRunUp; t += kCycle) step();
    check(std::abs(unit.axes()[0].actual().speed - kSpeed) < 1.0, "speed of an axis that turns");
  }
};

/// Jogs a modulo axis without end.
struct Travelling : UnitCycle {
  Travelling() : UnitCycle{true} {
    set(2577, 1.0);
    set(2586, kVelocity);
    switch_on();
    set(2590, 1.0);
    for (double t = 0.0; t < kRunUp; t += kCycle) step();
    check(std::abs(unit.axes()[0].actual().speed - kSpeed) < 1.0, "speed of an axis that travels");
  }
};

struct Positioned : UnitCycle {
  Positioned() : UnitCycle{true} {
    switch_on();
    check(unit.axes()[0].block<drive::PositionControl>().is_enabled(), "position control");
  }
};

}  // namespace

std::vector<OperationRow> positioning_operations() {
  return {
      {"positioning/speed", "4 ms of a unit with an axis at speed, without positioner", make<SpeedControlled>},
      {"positioning/travelling", "4 ms of the same with positioner, jogging at the same speed", make<Travelling>},
      {"positioning/positioned", "4 ms of the same that holds its position", make<Positioned>},
  };
}

}  // namespace bench
