// The position controller and its monitors over a whole unit.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kVelocity = 6000.0;  // 1000 LU/min, 100000 LU/s or 600 rpm

/// Runs to @p position with 600 rpm, without precontrol but for @p precontrol (%).
struct ControlledUnit : PositioningUnit {
  explicit ControlledUnit(double precontrol = 0.0) {
    set(2534, precontrol);
    enable();
    set_reference();
  }
  void cruise(double position = 500000.0) {
    move(position, kVelocity);
    run(2500);
    EXPECT_EQ(read(2666), kVelocity);
  }
  bool stands() { return bit(2683, 2); }
};

TEST(PositionController, HasTheLagOfItsGain) {
  ControlledUnit unit;
  unit.cruise();
  EXPECT_NEAR(unit.read(2565), 6000.0, 1.0);
  EXPECT_NEAR(unit.read(2557), 6000.0, 1.0);
  EXPECT_NEAR(unit.read(2558), 600.0, 0.1);
  EXPECT_NEAR(unit.read(2562), 600.0, 0.1);
  EXPECT_NEAR(unit.read(2563), 0.0, 2.0);
  EXPECT_EQ(unit.read(2561), 0.0);
  EXPECT_TRUE(unit.bit(2684, 8));
  unit.set(2538, 3.0);
  unit.run(500);
  EXPECT_NEAR(unit.read(2565), 2000.0, 1.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(PositionController, NeedsNoLagWithPrecontrol) {
  ControlledUnit unit{100.0};
  unit.cruise();
  EXPECT_NEAR(unit.read(2565), 0.0, 2.0);
  EXPECT_NEAR(unit.read(2561), 600.0, 0.1);
  EXPECT_NEAR(unit.read(2560), 0.0, 0.5);
  EXPECT_NEAR(unit.read(2562), 600.0, 0.5);
  EXPECT_NEAR(unit.read(2563), 0.0, 2.0);
  EXPECT_NEAR(unit.read(2566), 600.0, 0.1);
  unit.set(2534, 50.0);
  unit.run(500);
  EXPECT_NEAR(unit.read(2565), 3000.0, 2.0);
  EXPECT_NEAR(unit.read(2561), 300.0, 0.1);
}

TEST(PositionController, ReachesTheTargetWhenTheLagIsGone) {
  ControlledUnit unit;
  unit.cruise(300000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.stands(); }));
  EXPECT_FALSE(unit.bit(2684, 10));
  int waited = 0;
  EXPECT_TRUE(unit.run_until([&] { return ++waited, unit.bit(2684, 10); }, 500));
  EXPECT_NEAR(waited, 132, 15) << "60 ms ln(360/40) without the lag of the speed control";
  unit.run(2000);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionController, SmoothesTheSetpoint) {
  ControlledUnit unit;
  unit.set(2533, 20.0);
  unit.cruise();
  EXPECT_NEAR(unit.read(2665) - unit.read(2556), 2000.0, 60.0) << "100000 LU/s for 20 ms";
  EXPECT_NEAR(unit.read(2565), 6000.0, 2.0);
}

TEST(PositionController, BalancesItsPrecontrol) {
  ControlledUnit unit{100.0};
  unit.cruise();
  EXPECT_NEAR(unit.read(2665) - unit.read(2556), 200.0, 1.0) << "2 ms";
  unit.set(2535, 1.5);
  unit.run(200);
  EXPECT_NEAR(unit.read(2665) - unit.read(2556), 350.0, 1.0) << "3.5 ms";
  unit.set(2535, 0.0);
  unit.set(2536, 10.0);
  unit.run(300);
  EXPECT_NEAR(unit.read(2665) - unit.read(2556), 1200.0, 60.0) << "2 ms and 10 ms";
}

TEST(PositionController, TakesTheLagAwayWithItsIntegral) {
  ControlledUnit unit;
  unit.set(2546, 0.0);
  unit.set(2539, 500.0);
  unit.cruise();
  EXPECT_LT(std::abs(unit.read(2565)), 600.0);
  EXPECT_GT(unit.read(2559), 500.0);
}

TEST(PositionController, IsLimited) {
  ControlledUnit unit;
  unit.set(2546, 0.0);
  unit.set(2540, 200.0);
  unit.move(300000.0, kVelocity);
  unit.run(1500);
  EXPECT_TRUE(unit.bit(2526, 6));
  EXPECT_NEAR(unit.read(2560), 200.0, 0.01);
  EXPECT_NEAR(unit.read(2522), 2000.0, 20.0);
  unit.set(2540, 210000.0);
  unit.run(1500);
  EXPECT_FALSE(unit.bit(2526, 6));
}

TEST(PositionController, HasTheShareOfItsGain) {
  ControlledUnit unit;
  unit.set(2900, 50.0);
  unit.wire(2537, {2900, kOwnObject, 0});
  unit.cruise();
  EXPECT_NEAR(unit.read(2565), 12000.0, 60.0);
}

TEST(PositionController, IsOnWithItsEnables) {
  PositioningUnit unit;
  EXPECT_FALSE(unit.bit(2526, 3));
  EXPECT_TRUE(unit.bit(2526, 0));
  unit.enable();
  unit.set(2550, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.bit(2526, 3));
  unit.set(2550, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.bit(2526, 3));
  unit.control(0x0007);
  EXPECT_FALSE(unit.bit(2526, 3));
}

TEST(PositionController, ShowsItsCams) {
  ControlledUnit unit{100.0};
  unit.set(2547, 999.0);
  unit.set(2548, -1.0);
  unit.run(2);
  EXPECT_TRUE(unit.bit(2683, 8));
  EXPECT_FALSE(unit.bit(2683, 9));
  unit.move(1000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.run(300);
  EXPECT_FALSE(unit.bit(2683, 8));
  unit.move(-1000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.run(300);
  EXPECT_TRUE(unit.bit(2683, 8));
  EXPECT_TRUE(unit.bit(2683, 9));
}

/// An axis that a weight moves as soon as the torque is too small.
struct WeakUnit : PositioningUnit {
  static AxisConfiguration configuration() {
    AxisConfiguration axis = axis_configuration();
    axis.load.constant_torque = 2.0;
    return axis;
  }
  WeakUnit() : PositioningUnit{configuration()} {
    enable();
    set_reference();
    run(500);
    EXPECT_TRUE(messages().empty());
  }
  void fall() {
    set(1520, 0.5);
    set(1521, -0.5);
  }
};

TEST(PositionMonitoring, WatchesTheFollowingError) {
  for (const double tolerance : {1000.0, 0.0}) {
    WeakUnit unit;
    unit.set(2546, tolerance);
    unit.set(2542, 0.0);
    unit.fall();
    unit.run(600);
    EXPECT_EQ(unit.has(7452), tolerance > 0.0);
    EXPECT_EQ(unit.has(7450), false);
  }
}

TEST(PositionMonitoring, WatchesTheStandstill) {
  for (const double window : {200.0, 0.0}) {
    WeakUnit unit;
    unit.set(2546, 0.0);
    unit.set(2542, window);
    unit.fall();
    unit.run(600);
    EXPECT_EQ(unit.has(7450), window > 0.0);
  }
}

TEST(PositionMonitoring, WaitsForTheStandstill) {
  ControlledUnit unit;
  unit.set(2542, 1.0);  // LU: the lag is larger for 60 ms ln(360) after the setpoint stands
  unit.set(2544, 1.0);
  unit.set(2543, 500.0);
  unit.move(50000.0, kVelocity);
  ASSERT_TRUE(unit.run_until([&] { return unit.stands(); }));
  unit.run(1500);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
  unit.set(2543, 200.0);
  unit.move(0.0, kVelocity);
  ASSERT_TRUE(unit.run_until([&] { return unit.stands(); }));
  unit.run(300);
  EXPECT_EQ(unit.messages(), std::vector{7450});
}

TEST(PositionMonitoring, WatchesThePositioningOnce) {
  for (const double time : {200.0, 600.0}) {
    ControlledUnit unit;
    unit.set(2542, 0.0);
    unit.set(2544, 1.0);
    unit.set(2545, time);
    unit.move(50000.0, kVelocity);
    ASSERT_TRUE(unit.run_until([&] { return unit.stands(); }));
    unit.run(1500);
    EXPECT_EQ(unit.has(7451), time < 500.0);
  }
}

TEST(PositionMonitoring, LetsATaskWait) {
  ControlledUnit unit;
  unit.set(2542, 1.0);
  unit.set(2544, 1.0);
  unit.set(2543, 100.0);
  unit.set(2545, 100.0);
  unit.block(0, {.number = 1, .position = 30000.0, .mode = 0x40});  // waits for a signal
  unit.block(1, {.number = 2});
  unit.set(2632, 1.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.run_until([&] { return unit.stands(); }));
  unit.run(1000);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

}  // namespace
}  // namespace drive
