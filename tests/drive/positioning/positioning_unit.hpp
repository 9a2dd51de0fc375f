#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "drive/drive_unit.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {

/// A unit of one servo axis with the basic positioner, in process-data cycles of 1 ms, without a bus: the test
/// puts constants to the inputs. Its motor has an encoder of 2048 pulses and no load.
struct PositioningUnit {
  static constexpr std::uint8_t kAxis = 2;
  static constexpr double kMillisecond = 1e-3;

  DriveUnit unit;

  static AxisConfiguration axis_configuration() {
    AxisConfiguration axis{};
    axis.positioner = true;
    return axis;
  }
  explicit PositioningUnit(const AxisConfiguration& axis = axis_configuration())
      : unit{UnitConfiguration{.axes = {axis}, .node_id = 5}} {
    set(2640, 1.0);
    set(2641, 1.0);
    set(2534, 100.0);
    run(2);
  }

  Axis& axis() { return unit.axes()[0]; }
  Positioner& positioner() { return axis().block<Positioner>(); }
  double read(std::uint16_t number, std::size_t index = 0) const {
    return decode(unit.read(kAxis, number, index).value());
  }
  bool bit(std::uint16_t number, unsigned place) const {
    return (static_cast<std::uint32_t>(read(number)) >> place & 1U) != 0;
  }
  /// Writes a parameter of the axis; a refusal fails the test.
  void set(std::uint16_t number, double value, std::size_t index = 0) {
    const DataType type = find_parameter(ObjectKind::Servo, number)->row->type;
    const auto written = unit.write(kAxis, number, index, encode(type, value));
    EXPECT_TRUE(written.has_value()) << "p" << number;
  }
  /// Connects an input of the axis.
  void wire(std::uint16_t number, const BicoSource& source, std::size_t index = 0) {
    set(number, static_cast<double>(pack(source)), index);
  }
  /// A binector input becomes 1, and 0 again after @p cycles.
  void pulse(std::uint16_t input, int cycles = 5) {
    set(input, 1.0);
    run(cycles);
    set(input, 0.0);
    run(1);
  }
  /// Lets @p milliseconds pass, each a process-data cycle.
  void run(int milliseconds = 1) {
    constexpr std::array kAwake{true};
    for (int i = 0; i < milliseconds; ++i) unit.cycle(kAwake, kMillisecond);
  }
  /// The same until @p holds; false if it does not within @p limit ms.
  template <class Condition>
  bool run_until(const Condition& holds, int limit = 20000) {
    for (int i = 0; i < limit; ++i) {
      if (holds()) return true;
      run(1);
    }
    return holds();
  }
  void control(std::uint16_t word) {
    axis().process_data().received[0] = word;
    run(2);
  }
  /// Operation enabled.
  void enable() {
    for (const int word : {0x0006, 0x0007, 0x000F}) control(static_cast<std::uint16_t>(word));
    EXPECT_TRUE(run_until([&] { return bit(2526, 3); }, 1000)) << "r2526.3";
  }
  void disable() { control(0x0006); }
  void acknowledge() {
    control(0x0080);
    control(0x0006);
  }
  /// The reference is set here, at @p coordinate.
  void set_reference(double coordinate = 0.0) {
    set(2599, coordinate);
    pulse(2596, 2);
    EXPECT_TRUE(bit(2684, 11));
  }
  /// Numbers of the active faults and alarms.
  std::vector<int> messages() {
    std::vector<int> numbers;
    for (const auto& entry : axis().messages().faults()) numbers.push_back(entry.row->number);
    for (const auto& entry : axis().messages().alarms()) numbers.push_back(entry.row->number);
    return numbers;
  }
  bool has(int message) { return std::ranges::count(messages(), message) > 0; }
  /// Value of an active message, -1 if it is not active.
  std::int64_t value_of(int message) {
    for (const auto list : {axis().messages().faults(), axis().messages().alarms()})
      for (const FaultEntry& entry : list)
        if (entry.row->number == message) return entry.value;
    return -1;
  }
  /// MDI with a transfer by edge: to @p position with @p velocity (1000 LU/min).
  void move(double position, double velocity = 6000.0, bool absolute = true) {
    set(2690, position);
    set(2691, velocity);
    set(2648, absolute ? 1.0 : 0.0);
    set(2647, 1.0);
    pulse(2650, 2);
  }
  /// Writes entry @p entry of the table of blocks.
  struct Block {
    int number = 0;
    int task = 1;
    double position = 0.0;
    double velocity = 6000.0;
    double parameter = 0.0;
    int mode = 0;
    double acceleration = 100.0;
    double deceleration = 100.0;
  };
  void block(std::size_t entry, const Block& block) {
    set(2616, block.number, entry);
    set(2617, block.position, entry);
    set(2618, block.velocity, entry);
    set(2619, block.acceleration, entry);
    set(2620, block.deceleration, entry);
    set(2621, block.task, entry);
    set(2622, block.parameter, entry);
    set(2623, block.mode, entry);
  }
  /// Starts block @p number.
  void start_block(int number, int cycles = 2) {
    for (unsigned bit = 0; bit < 6; ++bit)
      set(static_cast<std::uint16_t>(2625 + bit), (number >> bit & 1) != 0 ? 1.0 : 0.0);
    pulse(2631, cycles);
  }
  /// The setpoint stands and the target is reached.
  bool is_done() { return bit(2684, 10) && !bit(2684, 15); }
};

}  // namespace drive
