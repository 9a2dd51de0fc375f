// Setpoint channel, halt and the speed that results.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "drive/base/scaling.hpp"
#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

TEST(AxisMotion, ReachesTheMaximumSpeedAfterTheRampUpTimeWithinACycle) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1082, 3000.0));
  ASSERT_TRUE(drive.axis.write(1120, 2.0));
  drive.enable(3000.0);  // the last of its cycles is the first of the ramp

  const double time = TestAxis::kCycle +
                      drive.run_until([](const Axis& a) { return a.actual().speed_demand >= 3000.0 * kRpm; }, 5.0);

  EXPECT_NEAR(time, 2.0, TestAxis::kCycle);
  drive.run(0.1);
  EXPECT_NEAR(drive.rpm(), 3000.0, 0.5);
}

TEST(AxisMotion, FollowsTheRampClosely) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1120, 7.2));
  drive.enable(2000.0);

  drive.run(1.0 - TestAxis::kCycle);

  EXPECT_NEAR(drive.demand_rpm(), 1000.0, 0.2);
  EXPECT_NEAR(drive.rpm(), 1000.0, 8.0);
}

TEST(AxisMotion, ReversesThroughZeroDownAndUpOnItsTwoRampTimes) {
  TestAxis drive;
  drive.turn_at(500.0);
  ASSERT_TRUE(drive.axis.write(1121, 3.6));  // 2000 rpm/s
  ASSERT_TRUE(drive.axis.write(1120, 7.2));  // 1000 rpm/s
  drive.setpoints.speed = -500.0 * kRpm;

  drive.run(0.24);
  EXPECT_NEAR(drive.demand_rpm(), 20.0, 1.0);
  drive.run(0.26);
  EXPECT_NEAR(drive.demand_rpm(), -250.0, 5.0);
  drive.run(0.30);
  EXPECT_NEAR(drive.rpm(), -500.0, 0.5);
}

TEST(AxisMotion, LimitsTheSetpointToTheMaximumSpeed) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1082, 600.0));
  ASSERT_TRUE(drive.axis.write(1120, 0.1));

  drive.enable(-5000.0);
  drive.run(1.0);

  EXPECT_NEAR(drive.rpm(), -600.0, 0.5);
  EXPECT_EQ(drive.status(), 0x0637);
}

TEST(AxisMotion, ObeysTheTorqueLimitsAndShowsThatOneIsReached) {
  TestAxis drive{{.load = {.inertia = 0.01}}};
  ASSERT_TRUE(drive.axis.write(1520, 4.0));
  ASSERT_TRUE(drive.axis.write(1521, -2.0));
  ASSERT_TRUE(drive.axis.write(1120, 0.0));
  ASSERT_TRUE(drive.axis.write(1121, 0.0));
  drive.enable(3000.0);

  drive.run(0.2);
  EXPECT_DOUBLE_EQ(drive.axis.actual().torque_demand, 4.0);
  EXPECT_NE(drive.status() & 0x0800, 0);
  EXPECT_EQ(drive.status() & 0x0400, 0);
  drive.run(2.0);
  EXPECT_EQ(drive.status(), 0x0637);
  drive.setpoints.speed = 0.0;
  drive.run(0.2);
  EXPECT_NEAR(drive.axis.actual().torque, -2.0, 0.01);
}

TEST(AxisMotion, NeverGivesMoreTorqueThanTheMotorHas) {
  TestAxis drive{{.load = {.inertia = 0.1}}};
  ASSERT_TRUE(drive.axis.write(1520, 1000.0));
  ASSERT_TRUE(drive.axis.write(1120, 0.0));

  drive.enable(3000.0);
  drive.run(0.1);

  // The data sheet's 35 N·m are those of the warm machine at its maximum current.
  EXPECT_NEAR(drive.axis.signals().current, 28.0 * std::numbers::sqrt2, 0.5);
  EXPECT_NEAR(drive.axis.actual().torque, 35.0, 3.5);
}

TEST(AxisMotion, KeepsTargetReachedForTheOffDelayAfterANewSetpoint) {
  TestAxis drive;
  drive.enable(0.0);
  drive.setpoints.speed = 1000.0 * kRpm;

  drive.run(0.196);
  EXPECT_NE(drive.status() & 0x0400, 0);
  drive.run(0.004);
  EXPECT_EQ(drive.status() & 0x0400, 0);
}

TEST(AxisMotion, MeasuresThePositionThatItHasTurned) {
  TestAxis drive;
  drive.turn_at(3000.0);
  const std::int64_t start = drive.axis.actual().encoder_counts;

  drive.run(20.0);

  const double turned = static_cast<double>(drive.axis.actual().encoder_counts - start) / 4194304.0;
  EXPECT_NEAR(turned, 1000.0, 0.001);
  EXPECT_EQ(drive.axis.actual().encoder_position,
            static_cast<std::int32_t>(static_cast<std::uint32_t>(drive.axis.actual().encoder_counts)));
  EXPECT_GT(drive.axis.actual().encoder_counts, std::int64_t{INT32_MAX});
  const BusScaling scaling{drive.axis.references()};
  EXPECT_NEAR(scaling.speed_to_bus(drive.axis.actual().speed), 209715200, 5000);
}

struct HaltCase {
  int option;
  double braking_time;  ///< from 1000 rpm to zero (s)
};
/// How GoogleTest names a case.
void PrintTo(const HaltCase& c, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << "option " << c.option;
}

class Halt : public testing::TestWithParam<HaltCase> {};

TEST_P(Halt, StopsOnItsRampStaysEnabledAndGoesOn) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1120, 0.72));
  ASSERT_TRUE(drive.axis.write(1121, 7.2));  // 1 s
  ASSERT_TRUE(drive.axis.write(1135, 3.6));  // 0.5 s
  ASSERT_TRUE(drive.axis.write(8791, GetParam().option));

  drive.send(0x010F);
  const double time =
      TestAxis::kCycle + drive.run_until([](const Axis& a) { return a.actual().speed < 5.0 * kRpm; }, 5.0);
  EXPECT_NEAR(time, GetParam().braking_time, 0.03);
  drive.run(1.0);
  EXPECT_EQ(drive.status(), 0x1637);
  EXPECT_EQ(drive.axis.actual().speed, 0.0);
  drive.run(10.0);
  EXPECT_TRUE(drive.axis.actual().pulses_enabled);

  drive.send(0x000F);
  drive.run(0.5);
  EXPECT_NEAR(drive.rpm(), 1000.0, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Options, Halt, testing::Values(HaltCase{1, 1.0}, HaltCase{2, 0.5}, HaltCase{3, 0.008}));

TEST(AxisMotion, IgnoresHaltInTheFactoryState) {
  TestAxis drive;
  drive.turn_at(1000.0);

  drive.send(0x010F);
  drive.run(0.5);

  EXPECT_EQ(drive.status(), 0x0637);
  EXPECT_NEAR(drive.rpm(), 1000.0, 0.5);
}

TEST(AxisMotion, HaltByOptionZeroSwitchesThePulsesOffAsLongAsItIsSet) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(8791, 0));

  EXPECT_EQ(drive.send(0x010F) & 0x006F, 0x0023);
  drive.run(0.1);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_GT(drive.rpm(), 800.0);

  EXPECT_EQ(drive.send(0x000F) & 0x006F, 0x0027);
  EXPECT_TRUE(drive.axis.actual().pulses_enabled);
}

TEST(AxisMotion, BrakesFromTheActualSpeedWhenTheMotorIsFarBehindItsSetpoint) {
  TestAxis drive{{.load = {.inertia = 0.5}}};
  ASSERT_TRUE(drive.axis.write(1120, 0.0));
  ASSERT_TRUE(drive.axis.write(1121, 20.0));
  drive.enable(3000.0);
  drive.run(0.5);
  const double behind = drive.rpm();
  ASSERT_LT(behind, 1000.0);

  drive.send(0x0006);
  drive.run(0.1);

  EXPECT_LT(drive.rpm(), behind + 5.0);
}

TEST(AxisParametersAccess, RefusesWhileThePulsesAreOnWhatNeedsThemOff) {
  TestAxis drive;
  drive.enable();

  EXPECT_EQ(drive.axis.write(1082, 3000.0).error().reason, Refusal::PulsesEnabled);
  EXPECT_TRUE(drive.axis.write(1120, 3.0));
  drive.send(0x0007);
  EXPECT_TRUE(drive.axis.write(1082, 3000.0));
  EXPECT_EQ(drive.axis.read(1082).value(), 3000.0);
}

TEST(AxisParametersAccess, RestoresTheCommissionedValues) {
  TestAxis drive;
  const auto parameters = [&] {
    std::vector<double> values;
    for (const PlacedRow& placed : parameters_of(drive.axis.kind()))
      if (is_saved(*placed.row))
        for (std::size_t i = 0; i < placed.row->count; ++i) values.push_back(drive.axis.value(placed, i));
    return values;
  };
  const std::vector<double> delivered = parameters();
  ASSERT_TRUE(drive.axis.write(1082, 3000.0));
  ASSERT_TRUE(drive.axis.write(1520, 1.0));
  EXPECT_NE(parameters(), delivered);

  drive.axis.restore_parameters();

  EXPECT_EQ(parameters(), delivered);
}

}  // namespace
}  // namespace drive
