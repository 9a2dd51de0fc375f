// Requests that come while something brakes, waits or is missing.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kSettingUp = 16.0;  // r2669

struct RequestUnit : PositioningUnit {
  RequestUnit() {
    enable();
    set_reference();
    block(0, {.number = 1, .position = 100000.0, .velocity = 600.0});
    block(1, {.number = 2, .position = 20000.0, .velocity = 600.0});
    set(2691, 600.0);
    set(2605, 300.0);
    run(1);
  }
  /// MDI setting-up in positive direction with continuous transfer.
  void select_setting_up() {
    set(2653, 1.0);
    set(2651, 1.0);
    set(2649, 1.0);
    set(2647, 1.0);
    run(2);
  }
};

TEST(PositionerRequests, ABlockMayStartWhileARejectedOneBrakes) {
  RequestUnit unit;
  unit.start_block(1);
  unit.run(300);
  unit.set(2641, 0.0);
  unit.run(20);
  unit.set(2641, 1.0);
  unit.set(2625, 0.0);
  unit.start_block(2);
  EXPECT_EQ(unit.read(2670), 2.0);
  EXPECT_GT(unit.read(2666), 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
  EXPECT_EQ(unit.read(2665), 20000.0);
}

TEST(PositionerRequests, MdiMayStartAgainWhileItBrakes) {
  for (const bool continuous : {false, true}) {
    RequestUnit unit;
    unit.set(2649, continuous ? 1.0 : 0.0);
    unit.move(50000.0, 600.0);
    unit.run(300);
    unit.set(2647, 0.0);
    unit.run(20);
    unit.set(2690, 20000.0);
    unit.set(2647, 1.0);
    unit.pulse(2650, 2);
    EXPECT_EQ(unit.read(2669), 8.0);
    EXPECT_EQ(unit.read(2671), 20000.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
    EXPECT_EQ(unit.read(2665), 20000.0);
  }
}

TEST(PositionerRequests, RejectedContinuousMdiNeedsToBeSelectedAgain) {
  RequestUnit unit;
  unit.move(50000.0, 600.0);
  unit.set(2649, 1.0);  // in its motion
  unit.run(300);
  unit.set(2641, 0.0);
  unit.run(20);
  unit.set(2641, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 200));
  unit.run(100);
  EXPECT_EQ(unit.read(2666), 0.0);
  unit.set(2647, 0.0);
  unit.run(2);
  unit.set(2647, 1.0);
  unit.run(20);
  EXPECT_EQ(unit.read(2669), 8.0);
  EXPECT_GT(unit.read(2666), 0.0);
}

TEST(PositionerRequests, JogMayStartAgainWhileItBrakes) {
  RequestUnit unit;
  unit.set(2590, 1.0);
  unit.run(300);
  unit.set(2590, 0.0);
  unit.run(20);
  unit.set(2589, 1.0);
  unit.run(200);
  EXPECT_EQ(unit.read(2666), -300.0);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerRequests, ABlockIsNotChangedInAnIntermediateStop) {
  RequestUnit unit;
  unit.start_block(1);
  unit.run(300);
  unit.set(2640, 0.0);
  unit.run(200);
  unit.set(2625, 0.0);
  unit.set(2626, 1.0);
  unit.set(2631, 1.0);
  unit.run(3);
  EXPECT_TRUE(unit.has(7486));
  EXPECT_EQ(unit.read(2670), 1.0);
  unit.set(2631, 0.0);
  unit.set(2640, 1.0);
  unit.run(100);
  EXPECT_FALSE(unit.has(7486));
  EXPECT_EQ(unit.read(2671), 100000.0);
  EXPECT_GT(unit.read(2666), 0.0);
}

TEST(PositionerRequests, ContinuousMdiStartsWhenWhatCameWithItIsGone) {
  RequestUnit unit;
  unit.set(2653, 1.0);
  unit.set(2651, 1.0);
  unit.set(2649, 1.0);
  unit.set(2647, 1.0);
  unit.set(2589, 1.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), 0.0) << "none of both starts";
  EXPECT_EQ(unit.value_of(7457), 1);
  unit.set(2589, 0.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  EXPECT_FALSE(unit.has(7457));
}

TEST(PositionerRequests, ContinuousMdiThatLacksItsReferenceLetsTheSearchStart) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2648, 1.0);
  unit.set(2649, 1.0);
  unit.set(2690, 3000.0);
  unit.set(2647, 1.0);
  unit.run(5);
  EXPECT_TRUE(unit.has(7461));
  unit.set(2607, 0.0);
  unit.set(2595, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), 2.0);
  EXPECT_FALSE(unit.has(7461));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 8.0; }, 10000)) << "starts by itself then";
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 3000.0);
}

TEST(PositionerRequests, SettingUpThatMayNotBecomePositioningEnds) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2691, 600.0);
  unit.set(2648, 1.0);
  unit.set(2653, 1.0);
  unit.set(2651, 1.0);
  unit.set(2649, 1.0);
  unit.set(2647, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 600.0);
  unit.set(2653, 0.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7461));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 200));
  EXPECT_TRUE(unit.has(7461)) << "as long as MDI is selected";
  unit.set(2647, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7461));
}

TEST(PositionerRequests, AContinuousTargetIsReachedAgainAfterEveryStop) {
  RequestUnit unit;
  unit.select_setting_up();
  unit.run(200);
  unit.set(2640, 0.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 0.0);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  unit.set(2640, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 600.0);
}

TEST(PositionerRequests, ASignalByAProbeThatIsNowhereIsAnAlarm) {
  RequestUnit unit;
  unit.block(0, {.number = 1, .task = 3, .velocity = 600.0, .mode = 0x40});
  unit.start_block(1);
  unit.run(50);
  EXPECT_EQ(unit.value_of(7498), 6);
  EXPECT_EQ(unit.read(2666) > 0.0, true);
  unit.set(2641, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 200));
  unit.run(5);
  EXPECT_FALSE(unit.has(7498));
}

TEST(PositionerRequests, SettingTheReferenceFarFromItsCoordinateIsBeyondNoLimit) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2580, -1000.0);
  unit.set(2581, 1000.0);
  unit.set(2582, 1.0);
  unit.move(5000.0, 600.0, false);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.set(2647, 0.0);
  unit.run(2);
  unit.set_reference(200.0);
  unit.run(5);
  EXPECT_EQ(unit.read(2665), 200.0);
  EXPECT_NEAR(unit.read(2521), 200.0, 2.0);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerRequests, AreTakenOnceWhateverTheProcessDataCycle) {
  constexpr std::array kAwake{true};
  constexpr double kCycle = 4e-3;
  RequestUnit unit;
  unit.set(2690, 3000.0);
  unit.set(2647, 1.0);
  unit.set(2650, 1.0);
  for (int i = 0; i < 10; ++i) unit.unit.cycle(kAwake, kCycle);
  EXPECT_EQ(unit.read(2671), 3000.0) << "one edge, in the first of four slices";
  unit.set(2650, 0.0);
  unit.unit.cycle(kAwake, kCycle);
  unit.set(2650, 1.0);
  unit.unit.cycle(kAwake, kCycle);
  EXPECT_EQ(unit.read(2671), 6000.0);
}

}  // namespace
}  // namespace drive
