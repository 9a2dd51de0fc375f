// Chains of traversing blocks in motion: targets, block changes by signals, new starts.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr unsigned kTerminal = 2;         // DI 2
constexpr double kProbeAtTerminal = 3.0;  // p0488: input 2

struct ChainUnit : PositioningUnit {
  ChainUnit() {
    enable();
    set_reference();
    set(2632, 1.0);
    run(1);
  }
  bool ends() {
    return run_until([&] { return read(2669) == 0.0; }, 20000);
  }
  bool reaches(double number) {
    return run_until([&] { return read(2670) == number; }, 5000);
  }
};

TEST(PositionerChain, RelativeTargetsCountFromTheTargetBefore) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 3000.0, .mode = 0x120});
  unit.block(1, {.number = 2, .task = 7, .parameter = 1.0, .mode = 0x10});
  unit.block(2, {.number = 5, .position = 2000.0, .mode = 0x110});
  unit.block(3, {.number = 6, .position = -500.0, .mode = 0x100});
  unit.start_block(1);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 4500.0);
  unit.start_block(6);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 4000.0) << "from the setpoint at the start";
}

TEST(PositionerChain, BlocksFollowByTheirNumbers) {
  ChainUnit unit;
  unit.block(0, {.number = 9, .position = 3000.0});
  unit.block(1, {.number = 4, .position = 1000.0, .mode = 0x11});  // hidden
  unit.block(2, {.number = 2, .position = 2000.0, .mode = 0x10});
  unit.start_block(2);
  ASSERT_TRUE(unit.reaches(9.0));
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 3000.0);
  unit.start_block(4, 1);
  unit.set(2631, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7462), 4) << "hidden";
  unit.set(2631, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7462));
  EXPECT_EQ(unit.read(2669), 0.0);
}

TEST(PositionerChain, SortingPutsTheEntriesInTheOrderOfTheirNumbers) {
  ChainUnit unit;
  unit.block(0, {.number = 9, .position = 3000.0});
  unit.block(1, {.number = 2, .position = 2000.0, .mode = 0x10});
  unit.set(2624, 1.0);
  unit.run(1);
  EXPECT_EQ(unit.read(2624), 0.0);
  EXPECT_EQ(unit.read(2616, 0), 2.0);
  EXPECT_EQ(unit.read(2617, 0), 2000.0);
  EXPECT_EQ(unit.read(2623, 0), 16.0);
  EXPECT_EQ(unit.read(2616, 1), 9.0);
  EXPECT_EQ(unit.read(2616, 2), -1.0);
}

TEST(PositionerChain, ASignalChangesTheBlockWhereTheAxisIs) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .task = 3, .velocity = 600.0, .mode = 0x30});
  unit.block(1, {.number = 2, .position = 5000.0, .velocity = 600.0, .mode = 0x100});
  unit.start_block(1);
  unit.run(500);
  const double place = unit.read(2521);
  unit.pulse(2633, 1);
  EXPECT_EQ(unit.read(2670), 2.0);
  EXPECT_NEAR(unit.read(2678), place, 15.0);
  const double base = unit.read(2678);
  EXPECT_EQ(unit.read(2671), base + 5000.0) << "relative to where the signal came";
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), base + 5000.0);
}

TEST(PositionerChain, AProbeChangesTheBlock) {
  ChainUnit unit;
  unit.set(2632, 0.0);
  unit.set(488, kProbeAtTerminal);
  unit.block(0, {.number = 1, .task = 3, .velocity = 600.0, .mode = 0x40});
  unit.block(1, {.number = 2, .position = 5000.0, .velocity = 600.0, .mode = 0x100});
  unit.start_block(1);
  unit.run(500);
  EXPECT_TRUE(unit.bit(2526, 1)) << "the probe is awaited";
  EXPECT_EQ(unit.read(2670), 1.0);
  const double place = unit.read(2521);
  unit.unit.control_unit().terminals().apply(kTerminal, true);
  unit.run(4);
  EXPECT_EQ(unit.read(2670), 2.0);
  EXPECT_NEAR(unit.read(2678), place, 30.0);
  EXPECT_EQ(unit.read(2671), unit.read(2678) + 5000.0);
  ASSERT_TRUE(unit.ends());
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerChain, ASignalInAnIntermediateStopActsAfterIt) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .task = 3, .velocity = 600.0, .mode = 0x40});
  unit.block(1, {.number = 2, .position = 5000.0, .velocity = 600.0});
  unit.start_block(1);
  unit.run(200);
  unit.set(2640, 0.0);
  unit.run(200);
  unit.pulse(2633, 2);
  EXPECT_EQ(unit.read(2670), 1.0);
  unit.set(2640, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2670), 2.0);
}

TEST(PositionerChain, ANewStartTakesTheMotionOver) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 90000.0, .velocity = 600.0});
  unit.block(1, {.number = 2, .position = 5000.0, .velocity = 1200.0, .mode = 0x100});
  unit.start_block(1);
  unit.run(500);
  const double place = unit.read(2521);
  unit.set(2625, 0.0);
  unit.start_block(2, 1);
  EXPECT_EQ(unit.read(2670), 2.0);
  EXPECT_GE(unit.read(2666), 599.0) << "without a stop";
  EXPECT_NEAR(unit.read(2678), place, 15.0);
  ASSERT_TRUE(unit.ends());
  EXPECT_NEAR(unit.read(2665), place + 5000.0, 15.0);
}

TEST(PositionerChain, ANewStartAfterAnIntermediateStop) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 90000.0, .velocity = 600.0});
  unit.block(1, {.number = 2, .position = 1000.0, .velocity = 1200.0});
  unit.start_block(1);
  unit.run(500);
  unit.set(2640, 0.0);
  unit.run(300);
  unit.set(2640, 1.0);
  unit.start_block(2);
  EXPECT_EQ(unit.read(2670), 2.0);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 1000.0);
}

TEST(PositionerChain, AnImpossibleStartInMotionDisturbsNothing) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 20000.0, .velocity = 600.0});
  unit.start_block(1);
  unit.run(300);
  unit.set(2626, 1.0);
  unit.set(2631, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7462), 3);
  EXPECT_EQ(unit.read(2670), 1.0);
  unit.set(2631, 0.0);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 20000.0);
}

TEST(PositionerChain, ChangesOfABlockThatRunsActAtItsNextStart) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 10000.0, .velocity = 600.0});
  unit.start_block(1);
  unit.run(200);
  unit.set(2617, 30000.0, 0);
  unit.set(2618, 1200.0, 0);
  unit.run(200);
  EXPECT_EQ(unit.read(2671), 10000.0);
  EXPECT_EQ(unit.read(2666), 600.0);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 10000.0);
  unit.start_block(1);
  EXPECT_EQ(unit.read(2671), 30000.0);
}

TEST(PositionerChain, AFlyingBlockThatReversesStopsWithoutReachingItsTarget) {
  ChainUnit unit;
  unit.block(0, {.number = 1, .position = 10000.0, .velocity = 600.0, .mode = 0x20});
  unit.block(1, {.number = 2, .position = 0.0, .velocity = 600.0});
  unit.start_block(1);
  bool reached = false;
  double highest = 0.0;
  ASSERT_TRUE(unit.run_until(
      [&] {
        reached = reached || unit.bit(2683, 3);
        highest = std::max(highest, unit.positioner().position());
        return unit.read(2670) == 2.0;
      },
      3000));
  EXPECT_FALSE(reached);
  EXPECT_NEAR(highest, 10000.0, 1e-6);
  ASSERT_TRUE(unit.ends());
  EXPECT_EQ(unit.read(2665), 0.0);
}

TEST(PositionerChain, WithoutAReferenceNoBlockStarts) {
  PositioningUnit unit;
  unit.enable();
  unit.block(0, {.number = 1, .position = 10000.0});
  unit.set(2625, 1.0);
  unit.set(2631, 1.0);
  unit.run(5);
  EXPECT_TRUE(unit.has(7461));
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_FALSE(unit.bit(2684, 12));
  unit.set(2631, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7461));
}

TEST(PositionerChain, EntriesFromP2615OnDoNotCount) {
  ChainUnit unit;
  unit.disable();
  unit.run(10);
  unit.set(2615, 1.0);
  unit.enable();
  unit.block(0, {.number = 1, .position = 1000.0});
  unit.block(1, {.number = 2, .position = 2000.0});
  unit.set(2626, 1.0);
  unit.set(2631, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7462), 2);
}

}  // namespace
}  // namespace drive
