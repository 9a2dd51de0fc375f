// Intermediate stop, reject, and what else ends or holds a task of the basic positioner: p2640, p2641, p2646,
// p2647.
#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

struct StopUnit : PositioningUnit {
  StopUnit() {
    enable();
    set_reference();
    block(0, {.number = 1, .position = 100000.0, .velocity = 600.0, .mode = 0x10, .deceleration = 50.0});
    block(1, {.number = 2, .position = 20000.0, .velocity = 600.0});
    set(2693, 50.0);
    run(1);
  }
  void start(bool mdi) {
    if (mdi)
      move(100000.0, 600.0);
    else
      start_block(1);
    run(300);
  }
};

TEST(PositionerStop, IntermediateStopKeepsTheTask) {
  for (const bool mdi : {false, true}) {
    StopUnit unit;
    unit.start(mdi);
    const double place = unit.positioner().position();
    unit.set(2640, 0.0);
    unit.run(199);
    EXPECT_GT(unit.positioner().velocity(), 0.0) << "half of p2573";
    unit.run(1);
    EXPECT_EQ(unit.positioner().velocity(), 0.0);
    EXPECT_NEAR(unit.positioner().position() - place, 1000.0, 1e-6);
    unit.run(100);
    EXPECT_EQ(unit.read(2669), mdi ? 8.0 : 4.0);
    EXPECT_EQ(unit.read(2675), mdi ? 0.0 : 1.0);
    EXPECT_EQ(unit.read(2671), 100000.0);
    EXPECT_TRUE(unit.bit(2684, 15));
    EXPECT_FALSE(unit.bit(2683, 3));
    unit.set(2640, 1.0);
    unit.run(300);
    EXPECT_EQ(unit.read(2666), 600.0);
    EXPECT_EQ(unit.read(2671), 100000.0);
    EXPECT_TRUE(unit.messages().empty());
  }
}

TEST(PositionerStop, RejectLosesTheTask) {
  for (const bool mdi : {false, true}) {
    StopUnit unit;
    unit.start(mdi);
    const double place = unit.positioner().position();
    unit.set(2641, 0.0);
    unit.run(50);
    EXPECT_TRUE(unit.bit(2684, 15)) << "still moves";
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 60));
    EXPECT_NEAR(unit.positioner().position() - place, 500.0, 1e-6) << "p2573 in full";
    EXPECT_FALSE(unit.bit(2684, 15));
    EXPECT_FALSE(unit.bit(2683, 3));
    EXPECT_TRUE(unit.bit(2683, 2));
    EXPECT_EQ(unit.read(2675), 0.0);
    unit.set(2641, 1.0);
    unit.run(100);
    EXPECT_EQ(unit.read(2669), 0.0) << "no start without an edge";
    unit.start(mdi);
    EXPECT_EQ(unit.read(2669), mdi ? 8.0 : 4.0);
    EXPECT_EQ(unit.read(2666), 600.0);
    EXPECT_TRUE(unit.messages().empty());
  }
}

TEST(PositionerStop, RejectInAnIntermediateStopEndsTheTaskAtOnce) {
  for (const bool mdi : {false, true}) {
    StopUnit unit;
    unit.start(mdi);
    unit.set(2640, 0.0);
    unit.run(300);
    unit.set(2641, 0.0);
    unit.run(2);
    EXPECT_EQ(unit.read(2669), 0.0);
    EXPECT_FALSE(unit.bit(2684, 15));
    unit.set(2640, 1.0);
    unit.set(2641, 1.0);
    unit.run(50);
    EXPECT_EQ(unit.read(2666), 0.0);
  }
}

TEST(PositionerStop, StartsNeedBothSignals) {
  for (const bool mdi : {false, true}) {
    for (const std::uint16_t signal : std::initializer_list<std::uint16_t>{2640, 2641}) {
      StopUnit unit;
      const int alarm = signal == 2640 ? 7486 : 7487;
      const std::uint16_t edge = mdi ? 2650 : 2631;
      unit.set(2647, mdi ? 1.0 : 0.0);
      unit.set(2648, 1.0);
      unit.set(2625, 1.0);
      unit.set(signal, 0.0);
      unit.run(2);
      unit.set(edge, 1.0);
      unit.run(5);
      EXPECT_TRUE(unit.has(alarm)) << mdi << ' ' << signal;
      EXPECT_EQ(unit.read(2669), 0.0);
      EXPECT_FALSE(unit.bit(2684, 12));
      unit.set(edge, 0.0);
      unit.run(2);
      EXPECT_FALSE(unit.has(alarm)) << mdi << ' ' << signal;
    }
  }
}

TEST(PositionerStop, AtRestTheSignalsEndOrHoldNothing) {
  StopUnit unit;
  unit.move(1000.0, 600.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.set(2640, 0.0);
  unit.run(5);
  EXPECT_TRUE(unit.bit(2683, 2));
  EXPECT_TRUE(unit.bit(2684, 10));
  EXPECT_FALSE(unit.bit(2684, 15));
  EXPECT_EQ(unit.read(2669), 8.0);
  unit.set(2650, 1.0);
  unit.run(3);
  EXPECT_TRUE(unit.has(7486)) << "no task begins";
  unit.set(2650, 0.0);
  unit.set(2640, 1.0);
  unit.set(2641, 0.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_TRUE(unit.bit(2683, 2));
}

TEST(PositionerStop, MdiTakesNewDataInAnIntermediateStop) {
  StopUnit unit;
  unit.start(true);
  unit.set(2640, 0.0);
  unit.run(300);
  unit.set(2690, 5000.0);
  unit.set(2691, 1200.0);
  unit.pulse(2650, 2);
  EXPECT_FALSE(unit.has(7486));
  EXPECT_EQ(unit.read(2671), 5000.0);
  EXPECT_EQ(unit.read(2666), 0.0);
  unit.set(2640, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 5000.0);
}

TEST(PositionerStop, MdiDeselectedInMotionBrakesWithP2573) {
  StopUnit unit;
  unit.start(true);
  const double place = unit.positioner().position();
  unit.set(2647, 0.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), 8.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 60));
  EXPECT_NEAR(unit.positioner().position() - place, 500.0, 1e-6);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerStop, OverrideZeroHoldsTheTask) {
  for (const bool mdi : {false, true}) {
    StopUnit unit;
    unit.start(mdi);
    unit.set(2646, 0.0);
    unit.run(1000);
    EXPECT_EQ(unit.read(2666), 0.0);
    EXPECT_EQ(unit.read(2681), 0.0);
    EXPECT_TRUE(unit.bit(2684, 15));
    EXPECT_FALSE(unit.bit(2683, 2));
    EXPECT_FALSE(unit.bit(2684, 10));
    unit.set(2646, 1.0);
    unit.run(300);
    EXPECT_EQ(unit.read(2666), 600.0);
    EXPECT_TRUE(unit.messages().empty()) << "F07450 and F07451 are not for a task that is held";
  }
}

TEST(PositionerStop, WaitingStandsStillForTheNextTaskOnly) {
  StopUnit unit;
  unit.block(2, {.number = 3, .task = 5, .parameter = 100.0, .mode = 0x10});
  unit.block(3, {.number = 4, .position = 20000.0, .velocity = 600.0});
  unit.start_block(3);
  unit.set(2640, 0.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2670), 3.0);
  EXPECT_EQ(unit.read(2666), 0.0);
  unit.set(2640, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2670), 4.0) << "its time has run";
}

}  // namespace
}  // namespace drive
