// Frames that come faster than they are handled.
#include <algorithm>

#include <gtest/gtest.h>

#include "service/clock.hpp"
#include "tests/daemon/loop/event_loop_fixture.hpp"

namespace axisd {
namespace {

/// Frames that come while a burst is on are out of the port before what they lead to is done.
TEST_F(EventLoopTest, ReadsAheadWhatComesFasterThanItIsHandled) {
  arrive(100);
  station.deadline = canopen::TimePoint{};
  loop.turn();  // late: all of them, and a burst is on
  station.events.clear();
  arrive(1000);

  loop.turn();

  EXPECT_TRUE(port.arrived.empty());
  EXPECT_LT(station.events.size(), 100U);
  port.polled = -1;  // the port itself wakes nobody
  while (std::ranges::count(station.events, "frame") < 1000) loop.turn();
  EXPECT_EQ(std::ranges::count(station.events, "frame"), 1000);
}

TEST_F(EventLoopTest, ReadsAheadAlsoWithinATurnThatTakesLong) {
  arrive(100);
  station.deadline = canopen::TimePoint{};
  loop.turn();  // a flood is on
  station.told_time = [&] {
    arrive(500);
    bus.read_ahead();
    EXPECT_TRUE(port.arrived.empty());
  };
  station.deadline = read_clock();
  station.events.clear();

  while (std::ranges::count(station.events, "frame") < 500) loop.turn();

  EXPECT_EQ(std::ranges::count(station.events, "time"), 1);
}

TEST_F(EventLoopTest, HandsOverNothingThatWasReadAheadWhenTheBusIsClosed) {
  arrive(100);
  station.deadline = canopen::TimePoint{};
  loop.turn();
  arrive(1000);
  loop.turn();
  port.polled = -1;

  bus.close();
  station.deadline = canopen::TimePoint{};
  loop.turn();
  const auto frames = std::ranges::count(station.events, "frame");
  ASSERT_TRUE(bus.open());
  station.deadline = canopen::TimePoint{};
  loop.turn();

  EXPECT_EQ(std::ranges::count(station.events, "frame"), frames);
  EXPECT_LT(frames, 1100);
}

}  // namespace
}  // namespace axisd
