// The sequence control as a master sees it: controlwords in, statuswords and motion out.
#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

TEST(AxisStates, ShowsTheTypicalStatuswordsFromPowerOnToOperation) {
  TestAxis drive;
  EXPECT_EQ(drive.status(), 0x0000);

  EXPECT_EQ(drive.send(0x0000), 0x1640);
  EXPECT_EQ(drive.send(0x0006), 0x1631);
  EXPECT_EQ(drive.send(0x0007), 0x1633);
  EXPECT_EQ(drive.send(0x000F), 0x1637);
  drive.run(1.0);
  EXPECT_EQ(drive.status(), 0x1637);
}

TEST(AxisStates, ShowsTargetReachedAndNoZeroSpeedWhileItTurnsAtItsSetpoint) {
  TestAxis drive;

  drive.turn_at(1000.0);

  EXPECT_EQ(drive.status(), 0x0637);
  EXPECT_NEAR(drive.rpm(), 1000.0, 0.5);
}

TEST(AxisStates, StaysInSwitchOnDisabledWhenEverythingIsSetInOneStep) {
  TestAxis drive;
  drive.send(0x0000);

  EXPECT_EQ(drive.send(0x000F), 0x1670);
  drive.run(1.0);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_EQ(drive.send(0x0006), 0x1631);
}

TEST(AxisStates, PassesSwitchedOnWhenItIsEnabledFromReady) {
  TestAxis drive;
  drive.send(0x0000);
  drive.send(0x0006);

  EXPECT_EQ(drive.send(0x000F), 0x1633);
  EXPECT_EQ(drive.send(0x000F), 0x1637);
}

TEST(AxisStates, Off1BrakesOnItsRampInOperationEnabledAndThenIsReady) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1121, 7.2));  // 1000 rpm a second

  EXPECT_EQ(drive.send(0x0006) & 0x006F, 0x0027);
  drive.run(0.5 - TestAxis::kCycle);
  EXPECT_NEAR(drive.demand_rpm(), 500.0, 5.0);
  EXPECT_NEAR(drive.rpm(), 500.0, 8.0);
  EXPECT_EQ(drive.status() & 0x006F, 0x0027);
  const double rest = drive.run_until([](const Axis& a) { return a.actual().state != State::Off1Braking; }, 10.0);

  EXPECT_NEAR(rest, 0.5 - 0.02 + 0.01, 0.012);  // to 20 rpm, then the pulse suppression delay
  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  drive.run(1.0);
  EXPECT_EQ(drive.status(), 0x1631);
}

TEST(AxisStates, Off1IsCancelledByEnablingAgain) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1121, 7.2));
  ASSERT_TRUE(drive.axis.write(1120, 7.2));
  drive.send(0x0006);
  drive.run(0.3);

  EXPECT_EQ(drive.send(0x000F) & 0x006F, 0x0027);
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_NEAR(drive.rpm(), 700.0, 12.0);
  drive.run(0.4);
  EXPECT_NEAR(drive.rpm(), 1000.0, 5.0);
}

TEST(AxisStates, DisablingOperationInMotionDropsThePulsesAtOnceAndTheMotorCoasts) {
  TestAxis drive;
  drive.turn_at(1000.0);
  const double before = drive.rpm();

  EXPECT_EQ(drive.send(0x0007) & 0x006F, 0x0023);

  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_EQ(drive.axis.actual().torque, 0.0);
  EXPECT_NEAR(drive.rpm(), before, 5.0);
  drive.run(0.5);
  EXPECT_GT(drive.rpm(), 400.0);
}

TEST(AxisStates, EnablingAMotorThatTurnsStartsTheRampAtItsSpeed) {
  TestAxis drive;
  drive.turn_at(1000.0);
  drive.send(0x0007);
  drive.run(0.2);
  const double coasting = drive.rpm();
  ASSERT_GT(coasting, 500.0);

  drive.send(0x000F);

  EXPECT_NEAR(drive.demand_rpm(), coasting, 10.0);
  EXPECT_LT(std::abs(drive.axis.actual().torque), 5.0);
}

TEST(AxisStates, Off3BrakesAsFastAsTheTorqueLimitAllowsAndCannotBeCancelled) {
  TestAxis drive;
  drive.turn_at(3000.0);

  EXPECT_EQ(drive.send(0x000B) & 0x006F, 0x0007);
  drive.send(0x000F);
  EXPECT_EQ(drive.status() & 0x006F, 0x0007);
  EXPECT_NE(drive.status() & 0x0800, 0);
  const double time =
      drive.run_until([](const Axis& a) { return a.actual().state != State::QuickStopActive; }, 10.0);

  // 314 rad/s at 35 N·m and 0.00151 kg·m² are 13.5 ms; then the loop settles, then the pulse suppression delay.
  EXPECT_GT(time, 0.015);
  EXPECT_LT(time, 0.05);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  drive.run(0.5);
  EXPECT_EQ(drive.status(), 0x1670);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

TEST(AxisStates, Off3BrakesOnItsOwnRampTime) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1135, 3.6));  // 2000 rpm a second

  drive.send(0x000B);
  drive.run(0.25 - TestAxis::kCycle);

  EXPECT_NEAR(drive.rpm(), 500.0, 15.0);
}

TEST(AxisStates, Off2CoastsAndInhibitsSwitchingOnAtOnce) {
  for (const std::uint16_t controlword : {std::uint16_t{0x0000}, std::uint16_t{0x000D}}) {
    TestAxis drive;
    drive.turn_at(1000.0);

    EXPECT_EQ(drive.send(controlword) & 0x004F, 0x0040);

    EXPECT_FALSE(drive.axis.actual().pulses_enabled);
    EXPECT_NEAR(drive.rpm(), 1000.0, 5.0);
    drive.send(0x000F);
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  }
}

TEST(AxisStates, Off2CutsAnyBrakingShort) {
  for (const std::uint16_t braking : {std::uint16_t{0x0006}, std::uint16_t{0x000B}}) {
    TestAxis drive;
    drive.turn_at(1000.0);
    ASSERT_TRUE(drive.axis.write(1135, 10.0));
    drive.send(braking);
    drive.run(0.1);

    EXPECT_EQ(drive.send(0x0000) & 0x004F, 0x0040);
    EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  }
}

TEST(AxisStates, SwitchesThePulsesOffAfterTheMonitoringTimeWhenTheMotorCannotStop) {
  TestAxis drive{{.load = {.inertia = 0.05}}};
  drive.turn_at(100.0);
  ASSERT_TRUE(drive.axis.write(1121, 0.0));
  ASSERT_TRUE(drive.axis.write(1520, 2.0));
  ASSERT_TRUE(drive.axis.write(1521, -2.0));
  ASSERT_TRUE(drive.axis.write(1227, 0.5));
  drive.axis.set_load_torque(-5.0);  // drives the shaft on, stronger than the limit

  drive.send(0x0006);
  const double time = drive.run_until([](const Axis& a) { return !a.actual().pulses_enabled; }, 10.0);

  EXPECT_NEAR(time, 0.51, 0.02);
  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn);
  EXPECT_GT(drive.rpm(), 100.0);
}

TEST(AxisStates, WaitsThePulseSuppressionDelayAtEveryOff1) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(1228, 0.1));

  for (int i = 0; i < 3; ++i) {
    drive.enable();
    drive.send(0x0006);
    const double time = drive.run_until([](const Axis& a) { return !a.actual().pulses_enabled; }, 1.0);
    EXPECT_NEAR(time + TestAxis::kCycle, 0.1, TestAxis::kCycle) << i;
  }
}

TEST(AxisStates, ThePowerOffOfAResetCancelsThePulsesAndLeavesNoMessage) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.raise(8751, 0, Cause::Present));

  drive.axis.power_off();

  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_EQ(drive.status() & 0x00CF, 0x0040);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_TRUE(drive.axis.messages().alarms().empty());
  drive.send(0x000F);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_NEAR(drive.rpm(), 1000.0, 10.0);
}

TEST(AxisQuiescence, ComesAfterTheShaftHasStoppedAndStays) {
  TestAxis drive;
  EXPECT_FALSE(drive.axis.is_quiescent());
  drive.send(0x0000);
  drive.send(0x0000);
  EXPECT_TRUE(drive.axis.is_quiescent());
  drive.turn_at(500.0);
  EXPECT_FALSE(drive.axis.is_quiescent());

  drive.send(0x0000);
  EXPECT_FALSE(drive.axis.is_quiescent());
  const double time = drive.run_until([](const Axis& a) { return a.is_quiescent(); }, 20.0);
  EXPECT_GT(time, 0.1);
  EXPECT_LT(time, 2.0);
  EXPECT_EQ(drive.axis.actual().speed, 0.0);

  const ActualValues resting = drive.axis.actual();
  for (int i = 0; i < 1000; ++i) {
    drive.run(TestAxis::kCycle);
    ASSERT_TRUE(drive.axis.is_quiescent());
    ASSERT_EQ(drive.axis.actual(), resting);
  }
}

TEST(AxisQuiescence, EndsWithEverythingThatCouldChangeSomething) {
  const auto resting = [] {
    TestAxis drive;
    drive.send(0x0000);
    drive.send(0x0000);
    return drive;
  };
  TestAxis loaded = resting();
  loaded.axis.set_load_torque(1.0);
  EXPECT_FALSE(loaded.axis.is_quiescent());
  loaded.run(0.1);
  EXPECT_FALSE(loaded.axis.is_quiescent()) << "a weight pulls the shaft round";

  TestAxis faulty = resting();
  ASSERT_TRUE(faulty.axis.raise(7860));
  EXPECT_FALSE(faulty.axis.is_quiescent());
  faulty.run(0.1);
  EXPECT_TRUE(faulty.axis.is_quiescent());

  TestAxis changed = resting();
  ASSERT_TRUE(changed.axis.write(1120, 1.0));
  EXPECT_FALSE(changed.axis.is_quiescent());

  TestAxis enabled = resting();
  enabled.enable();
  enabled.run(1.0);
  EXPECT_FALSE(enabled.axis.is_quiescent()) << "the pulses are on";
}

}  // namespace
}  // namespace drive
