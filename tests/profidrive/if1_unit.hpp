#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "profidrive/interface/interface.hpp"
#include "tests/unit/shelf.hpp"
#include "unit/runner.hpp"

namespace profidrive {

using namespace std::chrono_literals;
using Words = std::vector<std::uint16_t>;

/// A running unit with IF1 and no bus: drive object 1 is the control unit, 2 and following the axes.
struct If1Unit {
  static constexpr std::uint8_t kControlUnit = 1, kAxis = 2, kSecondAxis = 3;

  explicit If1Unit(unit::Configuration configuration = servo()) : runner{configuration, shelf}, if1{runner} {
    runner.attach(if1);
    runner.start(unit::TimePoint{1h});
    passes(20ms);
  }
  static unit::Configuration of(drive::AxisConfiguration axis) {
    return {.drive = {.axes = {axis, axis}, .node_id = 5}};
  }
  static unit::Configuration servo() { return of({}); }
  static unit::Configuration servo_without_channel() {
    drive::AxisConfiguration axis{};
    axis.setpoint_channel = false;
    return of(axis);
  }
  static unit::Configuration vector() {
    drive::AxisConfiguration axis{};
    axis.kind = drive::ObjectKind::Vector;
    return of(axis);
  }
  static unit::Configuration positioner() {
    drive::AxisConfiguration axis{};
    axis.positioner = true;
    return of(axis);
  }

  /// The time goes on in steps of a cycle.
  void passes(unit::Duration time) {
    for (const unit::TimePoint end = runner.now() + time; runner.now() < end;) {
      runner.set_now(std::min(end, std::max(runner.now(), runner.next_deadline())));
      runner.run_due();
    }
  }
  /// A controller that exchanges @p words with @p object every 4 ms.
  Words exchange(const Words& words, unit::Duration time, std::uint8_t object = kAxis) {
    for (const unit::TimePoint end = runner.now() + time; runner.now() < end;) {
      if1.receive(object, words);
      passes(4ms);
    }
    return sent(words.size(), object);
  }
  Words sent(std::size_t count, std::uint8_t object = kAxis) const {
    const auto words = if1.sent(object).first(count);
    return {words.begin(), words.end()};
  }
  double read(std::uint16_t number, std::size_t index = 0, std::uint8_t object = kAxis) const {
    const auto value = runner.unit().object(object)->read(number, index);
    EXPECT_TRUE(value.has_value()) << "r" << number;
    return value.value_or(0.0);
  }
  tl::expected<void, drive::ParameterError> write(std::uint16_t number, double value, std::size_t index = 0,
                                                  std::uint8_t object = kAxis) {
    return runner.write_parameter(object, number, index, value, runner.now());
  }
  /// The same; a refusal fails the test.
  void set(std::uint16_t number, double value, std::size_t index = 0, std::uint8_t object = kAxis) {
    const auto written = write(number, value, index, object);
    EXPECT_TRUE(written.has_value()) << (written ? "" : drive::message(written.error()));
  }
  /// Why a write is refused; NoParameter stands for none too, which a test never asks for.
  drive::RefusalReason refusal(std::uint16_t number, double value, std::size_t index = 0,
                               std::uint8_t object = kAxis) {
    const auto written = write(number, value, index, object);
    return written ? drive::RefusalReason::NoParameter : written.error().reason.why;
  }
  bool has_fault(std::uint16_t number, std::uint8_t object = kAxis) const {
    return has(runner.unit().object(object)->messages().faults(), number);
  }
  bool has_alarm(std::uint16_t number, std::uint8_t object = kAxis) const {
    return has(runner.unit().object(object)->messages().alarms(), number);
  }

  unit::Shelf shelf;
  unit::Runner runner;
  Interface if1;

 private:
  static bool has(std::span<const drive::FaultEntry> messages, std::uint16_t number) {
    for (const drive::FaultEntry& entry : messages)
      if (entry.row->number == number) return true;
    return false;
  }
};

/// A BICO source of the own drive object.
inline double own(std::uint16_t number, std::uint16_t position = 0) {
  return drive::own_source(number, position);
}

}  // namespace profidrive
