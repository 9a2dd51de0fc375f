// Jog of the basic positioner: p2585 to p2591.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr int kIllegalSignals = 7457;

struct JogUnit : PositioningUnit {
  JogUnit() {
    enable();
    set(2585, -600.0);
    set(2586, 600.0);
  }
  void release() {
    set(2589, 0.0);
    set(2590, 0.0);
    EXPECT_TRUE(run_until([&] { return read(2669) == 0.0; }, 5000));
    run(2);
  }
};

TEST(PositionerJog, RunsEndlessInTheDirectionOfItsVelocity) {
  JogUnit unit;
  unit.set(2589, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2669), 1.0);
  EXPECT_EQ(unit.read(2666), -600.0);
  EXPECT_EQ(unit.read(2671), 0.0) << "no target";
  EXPECT_EQ(unit.read(2672), 600.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_TRUE(unit.bit(2683, 5));
  EXPECT_FALSE(unit.bit(2683, 2));
  EXPECT_FALSE(unit.bit(2684, 11)) << "without a reference";
  unit.release();
  EXPECT_TRUE(unit.bit(2683, 2));
  EXPECT_FALSE(unit.bit(2684, 15));
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerJog, BrakesWithP2573) {
  JogUnit unit;
  unit.set(2573, 50.0);
  unit.set(2590, 1.0);
  unit.run(500);
  const double place = unit.positioner().position();
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 1000));
  EXPECT_NEAR(unit.positioner().position() - place, 10000.0 * 10000.0 / (2.0 * 50000.0), 1e-6);
}

TEST(PositionerJog, OfBothBitsTheFirstLeads) {
  JogUnit unit;
  unit.set(2589, 1.0);
  unit.set(2590, 1.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), 0.0) << "both from rest";
  EXPECT_EQ(unit.value_of(kIllegalSignals), 0);
  unit.set(2589, 0.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), 0.0) << "the other one was not the running one";
  EXPECT_FALSE(unit.has(kIllegalSignals));
  unit.release();

  unit.set(2589, 1.0);
  unit.run(200);
  unit.set(2590, 1.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2666), -600.0) << "the first keeps its velocity";
  EXPECT_EQ(unit.value_of(kIllegalSignals), 0);
  unit.set(2590, 0.0);
  unit.run(5);
  EXPECT_EQ(unit.read(2666), -600.0);
  EXPECT_FALSE(unit.has(kIllegalSignals));
  unit.set(2590, 1.0);
  unit.run(5);
  unit.set(2589, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 1000)) << "the running one is gone";
  unit.run(50);
  EXPECT_EQ(unit.read(2666), 0.0);
}

TEST(PositionerJog, IncrementTravelsItsDistance) {
  JogUnit unit;
  unit.set(2591, 1.0);
  unit.set(2587, 3000.0);
  unit.set(2588, 2000.0);
  unit.set(2590, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2671), 2000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 2000));
  EXPECT_EQ(unit.read(2665), 2000.0);
  EXPECT_TRUE(unit.bit(2683, 3));
  unit.run(50);
  EXPECT_EQ(unit.read(2665), 2000.0) << "one increment an edge";
  unit.set(2590, 0.0);
  unit.run(2);
  unit.pulse(2589, 1000);
  EXPECT_EQ(unit.read(2665), -1000.0);
}

TEST(PositionerJog, ReleaseInterruptsAnIncrement) {
  JogUnit unit;
  unit.set(2591, 1.0);
  unit.set(2588, 20000.0);
  unit.set(2590, 1.0);
  unit.run(500);
  unit.release();
  const double place = unit.read(2665);
  EXPECT_LT(place, 10000.0);
  EXPECT_FALSE(unit.bit(2683, 3));
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2684, 15) && unit.read(2671) > 0.0; }, 10));
  EXPECT_EQ(unit.read(2671), std::round(place) + 20000.0) << "a whole increment again";
}

TEST(PositionerJog, OfBothIncrementsOnlyTheFirstRuns) {
  JogUnit unit;
  unit.set(2591, 1.0);
  unit.set(2589, 1.0);
  unit.set(2590, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2671), -1000.0) << "together: jog 1";
  EXPECT_FALSE(unit.has(kIllegalSignals));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 1000));
  unit.release();
  unit.set(2590, 1.0);
  unit.run(10);
  unit.set(2589, 1.0);
  unit.run(10);
  EXPECT_EQ(unit.read(2671), 0.0) << "a later one is ignored: back from -1000 by 1000";
  EXPECT_EQ(unit.read(2666) > 0.0, true);
}

TEST(PositionerJog, KindIsTakenAtTheStart) {
  JogUnit unit;
  unit.set(2590, 1.0);
  unit.run(200);
  unit.set(2591, 1.0);
  unit.run(1000);
  EXPECT_EQ(unit.read(2666), 600.0);
}

TEST(PositionerJog, FollowsVelocitySignAndOverrideAtOnce) {
  JogUnit unit;
  unit.set(2590, 1.0);
  unit.run(300);
  unit.set(2586, 1200.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 1200.0);
  unit.set(2586, -300.0);
  unit.run(500);
  EXPECT_EQ(unit.read(2666), -300.0);
  EXPECT_EQ(unit.read(2669), 1.0);
  unit.set(2646, 0.0);
  unit.run(200);
  EXPECT_EQ(unit.read(2666), 0.0) << "override 0";
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_FALSE(unit.bit(2683, 2));
  EXPECT_EQ(unit.read(2681), 0.0);
  unit.set(2646, 1.0);
  unit.run(200);
  EXPECT_EQ(unit.read(2666), -300.0);
  EXPECT_EQ(unit.read(2681), 100.0);
}

TEST(PositionerJog, AtALimitOnlyTheWayBackStarts) {
  JogUnit unit;
  unit.set_reference();
  unit.set(2581, 5000.0);
  unit.set(2582, 1.0);
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7480); }, 3000));
  EXPECT_EQ(unit.read(2665), 5000.0);
  unit.release();
  EXPECT_TRUE(unit.has(7480));
  unit.set(2590, 1.0);
  unit.run(20);
  EXPECT_EQ(unit.read(2665), 5000.0);
  EXPECT_TRUE(unit.has(7480)) << "a start outwards is ignored";
  unit.release();
  unit.set(2589, 1.0);
  unit.run(50);
  EXPECT_LT(unit.read(2665), 5000.0);
  EXPECT_FALSE(unit.has(7480));
  EXPECT_FALSE(unit.bit(2683, 7));
}

TEST(PositionerJog, NeitherStopNorRejectConcernIt) {
  JogUnit unit;
  unit.set(2640, 0.0);
  unit.set(2641, 0.0);
  unit.set(2590, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 600.0);
  EXPECT_TRUE(unit.messages().empty());
}

}  // namespace
}  // namespace drive
