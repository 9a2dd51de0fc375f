// Travel to a fixed stop over a whole unit.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;
constexpr double kWall = 20000.0;  // LU

/// A wall at 20000 LU; the axis goes there with 60 rpm.
struct StopUnit : PositioningUnit {
  static AxisConfiguration configuration() {
    AxisConfiguration axis = axis_configuration();
    axis.load.end_stops.upper = kWall / 10000.0 * kRevolution;
    axis.load.end_stops.stiffness = 2000.0;
    return axis;
  }
  StopUnit() : PositioningUnit{configuration()} {
    enable();
    set_reference();
  }
  /// Entry @p entry: FIXED STOP with @p torque (N·m), by @p mode.
  void stop(std::size_t entry, int number, double torque, int mode = 0, double position = 40000.0) {
    block(entry, {.number = number,
                  .task = 2,
                  .position = position,
                  .velocity = 600.0,
                  .parameter = torque * 100.0,
                  .mode = mode});
  }
  bool clamps() {
    return run_until([&] { return bit(2683, 12) && bit(2683, 13); }, 8000);
  }
  double torque() { return read(80); }
};

TEST(FixedStop, IsHeldWithTheClampingTorque) {
  StopUnit unit;
  unit.stop(0, 1, 3.0);
  unit.start_block(1);
  EXPECT_TRUE(unit.bit(2683, 14));
  EXPECT_NEAR(unit.read(2686) * unit.read(2003) / 100.0, 3.0, 0.01);
  EXPECT_NEAR(unit.read(2686, 1) * unit.read(2003) / 100.0, -3.0, 0.01);
  ASSERT_TRUE(unit.clamps());
  unit.run(500);
  EXPECT_EQ(unit.read(2669), 0.0) << "END";
  EXPECT_FALSE(unit.bit(2684, 15));
  EXPECT_TRUE(unit.bit(2526, 4));
  EXPECT_TRUE(unit.bit(2526, 8));
  EXPECT_TRUE(unit.bit(2683, 14));
  EXPECT_NEAR(unit.torque(), 3.0, 0.05);
  EXPECT_NEAR(unit.read(2687) * unit.read(2003) / 100.0, 3.0, 0.05);
  EXPECT_NEAR(unit.read(2521), kWall, 60.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FixedStop, IsLeftByAJog) {
  StopUnit unit;
  unit.stop(0, 1, 3.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.clamps());
  unit.run(100);
  unit.set(2589, 1.0);
  unit.run(2);
  EXPECT_NEAR(unit.read(2665), kWall, 100.0) << "the setpoint starts at the actual value";
  EXPECT_FALSE(unit.bit(2683, 14));
  unit.run(1000);
  EXPECT_LT(unit.read(2521), kWall - 3000.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FixedStop, ChangesItsTorque) {
  StopUnit unit;
  unit.stop(0, 1, 3.0, 0x10);
  unit.stop(1, 2, 5.0);
  unit.stop(2, 3, 2.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2670) == 2.0; }, 8000)) << "at once when clamped";
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
  unit.run(300);
  EXPECT_NEAR(unit.torque(), 5.0, 0.05);
  unit.start_block(3);
  unit.run(300);
  EXPECT_TRUE(unit.bit(2683, 12));
  EXPECT_NEAR(unit.torque(), 2.0, 0.05);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FixedStop, ChangesToTheNextBlockBySignal) {
  StopUnit unit;
  unit.stop(0, 1, 3.0, 0x40);
  unit.block(1, {.number = 2, .position = 5000.0});
  unit.set(2632, 1.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.clamps());
  unit.run(1500);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_EQ(unit.read(2670), 1.0);
  unit.pulse(2633);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2665) == 5000.0; }));
  EXPECT_FALSE(unit.bit(2683, 14));
}

TEST(FixedStop, MustBeThere) {
  StopUnit unit;
  unit.stop(0, 1, 3.0, 0, 15000.0);
  unit.start_block(1);
  EXPECT_TRUE(unit.run_until([&] { return unit.has(7485); }));
  unit.run(500);
  EXPECT_LT(unit.read(2521), kWall);
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_FALSE(unit.bit(2683, 14));
}

TEST(FixedStop, MustNotBeLeft) {
  StopUnit unit;
  unit.stop(0, 1, 3.0, 0x40);
  unit.block(1, {.number = 2});
  unit.start_block(1);
  ASSERT_TRUE(unit.clamps());
  unit.unit.axes()[0].set_load_torque(8.0, motor::LoadTorqueType::Constant);
  EXPECT_TRUE(unit.run_until([&] { return unit.has(7484); }, 2000));
}

TEST(FixedStop, TellsOfATorqueThatIsNotReached) {
  StopUnit unit;
  unit.set(1520, 2.0);
  unit.set(2639, 0.0);
  unit.set(2545, 300.0);
  unit.stop(0, 1, 3.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2683, 12); }, 8000));
  EXPECT_FALSE(unit.has(7483));
  unit.run(400);
  EXPECT_TRUE(unit.has(7483));
  EXPECT_FALSE(unit.bit(2683, 13));
}

TEST(FixedStop, HoldsThroughAnIntermediateStopAndEndsWithAReject) {
  StopUnit unit;
  unit.stop(0, 1, 3.0, 0x40);
  unit.block(1, {.number = 2});
  unit.start_block(1);
  ASSERT_TRUE(unit.clamps());
  unit.set(2640, 0.0);
  unit.run(300);
  EXPECT_TRUE(unit.bit(2683, 12));
  EXPECT_NEAR(unit.torque(), 3.0, 0.05);
  unit.set(2641, 0.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_FALSE(unit.bit(2683, 12));
  EXPECT_FALSE(unit.bit(2683, 14));
  EXPECT_NEAR(unit.read(2665), kWall, 60.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FixedStop, KeepsItsTorqueWhenTheReferenceIsSet) {
  StopUnit unit;
  unit.stop(0, 1, 3.0);
  unit.start_block(1);
  ASSERT_TRUE(unit.clamps());
  unit.run(300);
  unit.set(2599, 100.0);
  unit.pulse(2596);
  EXPECT_NEAR(unit.read(2521), 100.0, 2.0);
  unit.run(500);
  EXPECT_NEAR(unit.torque(), 3.0, 0.05);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FixedStop, NeedsControlWithAnEncoder) {
  StopUnit unit;
  unit.disable();
  unit.run(1000);
  unit.set(1300, 20.0);
  unit.set(2656, 1.0);
  unit.stop(0, 4, 3.0);
  unit.set(2631, 0.0);
  unit.run(2);
  unit.start_block(4, 2);
  EXPECT_EQ(unit.read(2669), 0.0);
  unit.set(2631, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7505));
  EXPECT_EQ(unit.value_of(7505), 4);
}

}  // namespace
}  // namespace drive
