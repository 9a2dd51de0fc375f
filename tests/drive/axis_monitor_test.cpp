// The faults that the axis raises by itself, and those that it must not.
#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

bool has_fault(const TestAxis& drive, std::uint16_t number) {
  for (const FaultEntry& entry : drive.axis.messages().faults())
    if (entry.row->number == number) return true;
  return false;
}

TEST(AxisMonitoring, AMotorThatCannotTurnTripsAfterTheBlockedTime) {
  TestAxis held{{.load = {.coulomb_friction = 50.0}}};
  ASSERT_TRUE(held.axis.write(1120, 0.0));
  held.enable(500.0);

  const double time = held.run_until([&](const Axis& a) { return !a.actual().pulses_enabled; }, 5.0);

  EXPECT_TRUE(has_fault(held, 7900));
  EXPECT_NEAR(time, 1.0, 0.1);
  EXPECT_EQ(held.state(), State::Fault);
  held.send(0x0000);
  held.send(0x0080);
  EXPECT_EQ(held.state(), State::SwitchOnDisabled);
}

TEST(AxisMonitoring, HardBrakingAndReversingOfALargeMassIsNoBlockedMotor) {
  TestAxis drive{{.load = {.inertia = 0.3}}};
  ASSERT_TRUE(drive.axis.write(1120, 0.0));
  ASSERT_TRUE(drive.axis.write(1121, 0.0));
  drive.enable(1000.0);
  drive.run(3.0);
  EXPECT_NEAR(drive.rpm(), 1000.0, 1.0);

  drive.setpoints.speed = -1000.0 * kRpm;
  drive.run(3.0);
  drive.setpoints.speed = 0.0;
  drive.run(3.0);

  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_EQ(drive.axis.actual().speed, 0.0);
}

TEST(AxisMonitoring, ATorqueLimitAtTheSetpointZeroIsNoBlockedMotor) {
  TestAxis drive;
  drive.enable(0.0);
  ASSERT_TRUE(drive.axis.write(1520, 0.0));
  ASSERT_TRUE(drive.axis.write(1521, 0.0));
  drive.axis.set_load_torque(0.12);

  drive.run(5.0);

  EXPECT_FALSE(has_fault(drive, 7900));
}

TEST(AxisMonitoring, ALoadThatDrivesTheMotorBeyondTheLimitTripsOverspeed) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1082, 1000.0));
  ASSERT_TRUE(drive.axis.write(2162, 100.0));
  ASSERT_TRUE(drive.axis.write(1120, 0.0));
  ASSERT_TRUE(drive.axis.write(1521, -1.0));
  drive.enable(900.0);
  drive.run(0.5);
  ASSERT_TRUE(drive.axis.actual().pulses_enabled);
  drive.axis.set_load_torque(-3.0);

  drive.run_until([](const Axis& a) { return !a.actual().pulses_enabled; }, 5.0);

  EXPECT_TRUE(has_fault(drive, 7901));
  EXPECT_GT(drive.rpm(), 1100.0);
  EXPECT_LT(drive.rpm(), 1300.0);
  EXPECT_FALSE(drive.axis.acknowledge()) << "it still turns too fast";
  drive.axis.set_load_torque(0.0);
  drive.run(5.0);
  EXPECT_TRUE(drive.axis.acknowledge());
}

TEST(AxisMonitoring, FullSpeedInBothDirectionsIsNoOverspeed) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1120, 0.0));
  ASSERT_TRUE(drive.axis.write(1121, 0.0));
  drive.enable(7200.0);
  drive.run(1.0);
  EXPECT_NEAR(drive.rpm(), 7200.0, 1.0);

  drive.setpoints.speed = -7200.0 * kRpm;
  drive.run(1.0);

  EXPECT_NEAR(drive.rpm(), -7200.0, 1.0);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

TEST(AxisMonitoring, CrossedTorqueLimitsAreAFaultUntilTheyAreCorrected) {
  TestAxis drive;
  drive.send(0x0000);
  ASSERT_TRUE(drive.axis.write(1520, -10.0));
  ASSERT_TRUE(drive.axis.write(1521, -5.0));

  drive.send(0x0000);
  EXPECT_TRUE(has_fault(drive, 7090));
  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::Fault);
  ASSERT_TRUE(drive.axis.write(1520, 10.0));
  drive.send(0x0000);
  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
}

}  // namespace
}  // namespace drive
