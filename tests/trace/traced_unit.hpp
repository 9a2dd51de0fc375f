#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "drive/signal_source.hpp"
#include "tests/unit/shelf.hpp"
#include "trace/tracer.hpp"
#include "unit/runner.hpp"

namespace trace {

using namespace std::chrono_literals;

/// A unit of two servo axes without a bus, switched on and at rest, with a trace: the test puts words where the
/// bus would and moves the clock.
struct TracedUnit : testing::Test {
  static constexpr unit::TimePoint kStart{1h};
  static constexpr unit::Duration kCycle = 4ms;
  static constexpr std::uint8_t kX = 2, kY = 3;

  TracedUnit() {
    runner.start(kStart);
    passes(20ms);
  }

  /// Begins a trace; false if it cannot be.
  bool traces(const Settings& settings) {
    const auto started = tracer.start(settings, runner.clock().period());
    if (!started) return false;
    runner.observe(&tracer);
    return true;
  }
  /// The time goes on in steps of a cycle.
  void passes(unit::Duration time) {
    for (const unit::TimePoint end = runner.now() + time; runner.now() < end;) {
      runner.set_now(std::min(end, std::max(runner.now(), std::min(end, runner.next_deadline()))));
      runner.run_due();
    }
  }
  /// Time passes without anybody telling it; then it is told.
  void sleeps(unit::Duration time) {
    runner.set_now(runner.now() + time);
    runner.run_due();
  }
  /// The next cycle takes @p controlword on drive object @p object.
  void commands(std::uint8_t object, std::uint16_t controlword) {
    runner.unit().object(object)->process_data().received[0] = controlword;
    runner.wake();
    passes(2 * kCycle);
  }
  void switch_on(std::uint8_t object) {
    for (const int word : {0x0006, 0x0007, 0x000F}) commands(object, static_cast<std::uint16_t>(word));
    ASSERT_EQ(axis(object).actual().state, drive::State::OperationEnabled);
  }
  /// The speed setpoint of a new axis (rpm).
  void asks_for(std::uint8_t object, double rpm) {
    const double reference = axis(object).read(2000).value();
    const auto word = static_cast<std::int32_t>(std::lround(rpm / reference * 0x40000000));
    drive::ProcessDataImage::set_double_word(runner.unit().object(object)->process_data().received, 1,
                                             static_cast<std::uint32_t>(word));
    runner.wake();
  }
  /// Fault or alarm @p number comes on @p axis.
  void raises(std::size_t axis, std::uint16_t number) {
    ASSERT_TRUE(runner.raise(axis, number, 0, runner.now())) << number;
  }
  void write(std::uint8_t object, std::uint16_t number, double value) {
    ASSERT_TRUE(runner.unit().object(object)->write(number, value)) << "p" << number;
  }
  const drive::Axis& axis(std::uint8_t object) const { return runner.unit().axes()[object - kX]; }

  /// Seconds since power-on.
  static double seconds(unit::TimePoint time) { return std::chrono::duration<double>{time - kStart}.count(); }
  /// The times of all samples of result @p number (s).
  std::vector<double> times(std::uint64_t number = 1) const {
    std::vector<double> list;
    const Recording& result = *tracer.result(number);
    for (std::size_t i = 0; i < result.size(); ++i) list.push_back(seconds(result.time(i)));
    return list;
  }
  /// The values of signal @p signal (0 = the first).
  std::vector<double> values(std::size_t signal = 0, std::uint64_t number = 1) const {
    std::vector<double> list;
    const Recording& result = *tracer.result(number);
    for (std::size_t i = 0; i < result.size(); ++i) list.push_back(result.values(i)[signal]);
    return list;
  }
  double trigger_time(std::uint64_t number = 1) const { return seconds(*tracer.result(number)->trigger_time()); }

  unit::Shelf shelf;
  unit::Runner runner{{.drive = {.axes = {{}, {}}, .node_id = 5}}, shelf};
  Tracer tracer{std::as_const(runner).unit()};
};

}  // namespace trace
