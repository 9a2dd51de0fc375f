// The setpoint channel in an axis: fixed setpoints, setpoints behind the ramp.
#include "tests/drive/wired_axis.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

TEST(SetpointChannelOfAnAxis, FollowsItsFixedSetpoint) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  ASSERT_EQ(wired.write(kX, 1121, 0.0), std::nullopt);
  wired.wire(kX, 1070, {1024, kOwnObject, 0});
  wired.wire(kX, 1020, {8890, kOwnObject, 11});
  wired.wire(kX, 1021, {8890, kOwnObject, 12});
  ASSERT_EQ(wired.write(kX, 1001, 300.0), std::nullopt);
  ASSERT_EQ(wired.write(kX, 1003, -200.0), std::nullopt);
  wired.switch_on(kX);
  for (const auto& [word, rpm] : {std::pair{0x080F, 300.0}, std::pair{0x180F, -200.0}, std::pair{0x000F, 0.0}}) {
    wired.receives(kX, 0, static_cast<std::uint16_t>(word));
    wired.cycles(150);
    EXPECT_NEAR(wired.rpm(kX), rpm, 0.5);
    EXPECT_NEAR(wired.read(kX, 1024), rpm, 1e-3);
  }
}

TEST(SetpointChannelOfAnAxis, ShowsTheChosenSetpointWithThePulsesOff) {
  WiredUnit wired;
  wired.set(kX, 1020, true);
  ASSERT_EQ(wired.write(kX, 1001, 300.0), std::nullopt);
  wired.set(kX, 1075, true);
  wired.cycles();
  EXPECT_NEAR(wired.read(kX, 1024), 300.0, 1e-3);
  EXPECT_NEAR(wired.read(kX, 1078), wired.read(kX, 2000), 1e-2);
  EXPECT_EQ(wired.read(kX, 1119), 0.0) << "nothing goes to the ramp";
  ASSERT_EQ(wired.write(kX, 1001, 100.0), std::nullopt);
  wired.cycles();
  EXPECT_NEAR(wired.read(kX, 1024), 100.0, 1e-3);
}

TEST(SetpointChannelOfAnAxis, KeepsAWiredLimitWhateverIsWritten) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  wired.wire(kX, 1070, {2900, kOwnObject, 0});
  wired.wire(kX, 1085, {2901, kOwnObject, 0});
  ASSERT_EQ(wired.write(kX, 2900, 20.0), std::nullopt);
  ASSERT_EQ(wired.write(kX, 2901, 30.0), std::nullopt);
  wired.switch_on(kX);
  wired.cycles(20);
  ASSERT_NEAR(wired.read(kX, 1170), 0.2 * wired.read(kX, 2000), 1e-3);
  ASSERT_EQ(wired.write(kX, 2901, 10.0), std::nullopt);
  wired.cycles(2);
  const double limit = 0.1 * wired.read(kX, 2000);
  ASSERT_GT(wired.read(kX, 1150), limit) << "on its ramp";
  for (const auto& [number, value] :
       {std::pair{1001, 50.0}, {1083, 2000.0}, {1120, 3.0}, {1226, 20.0}, {1460, 1.0}}) {
    ASSERT_EQ(wired.write(kX, static_cast<std::uint16_t>(number), value), std::nullopt);
    EXPECT_NEAR(wired.read(kX, 1170), limit, 1e-3) << "before the next cycle, after p" << number;
  }
}

TEST(SetpointChannelOfAnAxis, BrakesWithASetpointBehindTheRampToStandstill) {
  for (const int word : {0x000E, 0x000B}) {
    WiredUnit wired;
    ASSERT_EQ(wired.write(kX, 1121, 1.0), std::nullopt);
    ASSERT_EQ(wired.write(kX, 1135, 1.0), std::nullopt);
    wired.wire(kX, 1155, {8860, kY, 4});
    wired.switch_on(kX);
    wired.receives_double_word(kY, 4, 0x10000000);
    wired.cycles(200);
    ASSERT_NEAR(wired.rpm(kX), 0.25 * wired.read(kX, 2000), 1.0);

    wired.receives(kX, 0, static_cast<std::uint16_t>(word));
    wired.cycles(2);
    EXPECT_GT(wired.rpm(kX), 0.2 * wired.read(kX, 2000)) << "on a ramp";
    wired.cycles(300);
    EXPECT_NEAR(wired.rpm(kX), 0.0, 0.5);
    EXPECT_FALSE(wired.axis(kX).actual().pulses_enabled);
  }
}

TEST(SetpointBehindTheRamp, WaitsForTheHoldingBrake) {
  WiredAxis test{[] {
    AxisConfiguration configuration{};
    configuration.load.brake = {.torque = 20.0, .opening_time = 0.2, .closing_time = 0.05};
    return configuration;
  }()};
  test.inputs.speed_setpoint_1 = 300.0 * kRpm;
  test.inputs.on = true;
  test.run(0.15);
  EXPECT_EQ(test.axis.actual().speed_demand, 0.0);
  EXPECT_NEAR(test.axis.actual().torque_demand, 0.0, 0.5) << "not against the brake";
  test.run(0.5);
  EXPECT_NEAR(test.rpm(), 300.0, 1.0);
}

TEST(SetpointBehindTheRamp, EndsWithAHaltAtTheTorqueLimit) {
  constexpr std::uint16_t kHalt = 0x0100;
  WiredAxis test;
  ASSERT_TRUE(test.axis.write(8791, 3.0));
  test.inputs.bypass_ramp = true;
  test.inputs.speed_setpoint_1 = 300.0 * kRpm;
  test.inputs.on = true;
  test.run(0.5);
  ASSERT_NEAR(test.rpm(), 300.0, 1.0);
  test.inputs.controlword = kHalt;
  test.run(0.5);
  EXPECT_NEAR(test.rpm(), 0.0, 0.5);
  EXPECT_EQ(test.state(), State::OperationEnabled);
  test.inputs.controlword = 0;
  test.run(0.5);
  EXPECT_NEAR(test.rpm(), 300.0, 1.0);
}

TEST(SetpointBehindTheRamp, IsWatchedForABlockedMotor) {
  WiredAxis test;
  ASSERT_TRUE(test.axis.write(1520, 0.0));
  ASSERT_TRUE(test.axis.write(1521, 0.0));
  test.inputs.speed_setpoint_1 = 300.0 * kRpm;
  test.inputs.on = true;
  test.run(3.0);
  EXPECT_TRUE(test.has(7900));
}

}  // namespace
}  // namespace drive
