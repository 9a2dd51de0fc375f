// Torque control of an axis, and the changeover from and to speed control.
#include <cmath>

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

/// Axis X in operation at a speed and with a load, which it changes over between the controls.
struct Changeover : WiredUnit {
  Changeover() {
    EXPECT_EQ(write(kX, 1120, 1.0), std::nullopt);
    axis(kX).set_load_torque(1.0);
    receives_double_word(kX, 1, 0x10000000);
    wire(kX, 1501, {8890, kOwnObject, 12});
    wire(kX, 1503, {79, kOwnObject, 0});  // goes on with the torque that there is
    switch_on(kX);
    cycles(500);
    EXPECT_NEAR(rpm(kX), full() / 4, 1.0);
  }
  double full() const { return read(kX, 2000); }
  double torque() { return axis(kX).actual().torque; }
};

TEST(Changeover, BetweenSpeedAndTorqueControlMakesNoJump) {
  Changeover drive;
  for (const int word : {0x100F, 0x000F, 0x100F, 0x000F}) {
    const double rpm = drive.rpm(kX), torque = drive.torque();
    drive.receives(kX, 0, static_cast<std::uint16_t>(word));
    for (int i = 0; i < 25; ++i) {
      drive.cycles();
      EXPECT_NEAR(drive.torque(), torque, 0.05 * drive.read(kX, 333)) << std::hex << word << " cycle " << i;
      EXPECT_NEAR(drive.rpm(kX), rpm, 0.01 * rpm) << std::hex << word << " cycle " << i;
    }
    EXPECT_EQ(drive.axis(kX).actual().mode, word == 0x100F ? 4 : 3);
    const auto status = static_cast<unsigned>(drive.read(kX, 1407));
    EXPECT_EQ(status & 0x0CU, word == 0x100F ? 0x04U : 0x08U) << "r1407.2, r1407.3";
  }
}

TEST(Changeover, ToSpeedControlGoesUpTheRampFromTheSpeedThatThereIs) {
  Changeover drive;
  drive.set(kX, 1503, false);
  drive.receives(kX, 0, 0x100F);
  drive.cycles(50);
  const double slower = drive.rpm(kX);
  ASSERT_LT(slower, 0.9 * drive.full() / 4) << "the load brakes";

  drive.receives(kX, 0, 0x000F);
  drive.cycles();
  const double maximum = drive.read(kX, 1082);
  EXPECT_NEAR(drive.axis(kX).actual().speed_demand / kRpm, slower, 0.02 * maximum);
  double before = drive.axis(kX).actual().speed_demand;
  for (int i = 0; i < 20; ++i) {
    drive.cycles();
    const double step = drive.axis(kX).actual().speed_demand - before;
    EXPECT_LE(step, 1.01 * maximum * kRpm * kCycle) << "p1120 is 1 s";
    before = drive.axis(kX).actual().speed_demand;
  }
}

TEST(TorqueControl, GivesTheTorqueWithinItsLimits) {
  WiredUnit wired;
  const double rated = wired.read(kX, 333);
  ASSERT_EQ(wired.write(kX, 1300, 23.0), std::nullopt);
  ASSERT_EQ(wired.write(kX, 1520, 0.8 * rated), std::nullopt);
  ASSERT_EQ(wired.write(kX, 1521, -0.5 * rated), std::nullopt);
  wired.switch_on(kX);
  for (const auto& [word, share] : {std::pair{0x0800, 0.125}, std::pair{0x2000, 0.5}, std::pair{0x4000, 0.8},
                                    std::pair{0xC000, -0.5}, std::pair{0x0000, 0.0}}) {
    wired.receives(kX, 3, static_cast<std::uint16_t>(word));
    wired.cycles(10);
    EXPECT_NEAR(wired.axis(kX).actual().torque, share * rated, 0.02 * rated) << std::hex << word;
    EXPECT_EQ((wired.axis(kX).actual().statusword & 0x0800) != 0, std::abs(share) > 0.45 && word != 0x2000);
  }
}

TEST(TorqueControl, TakesConnectedLimits) {
  WiredUnit wired;
  const double rated = wired.read(kX, 333);
  ASSERT_EQ(wired.write(kX, 1300, 23.0), std::nullopt);
  wired.wire(kX, 1522, {8850, kY, 0});
  wired.wire(kX, 1523, {8850, kY, 1});
  wired.receives(kY, 0, 0x1000);
  wired.receives(kY, 1, 0xF800);
  wired.switch_on(kX);
  wired.receives(kX, 3, 0x4000);
  wired.cycles(5);
  EXPECT_NEAR(wired.axis(kX).actual().torque, 0.25 * rated, 0.02 * rated);
  wired.receives(kX, 3, 0xC000);
  wired.cycles(5);
  EXPECT_NEAR(wired.axis(kX).actual().torque, -0.125 * rated, 0.02 * rated);
}

TEST(SupplementaryTorques, AddInBothControls) {
  for (const bool torque_control : {false, true}) {
    WiredUnit wired;
    const double rated = wired.read(kX, 333);
    if (torque_control) {
      ASSERT_EQ(wired.write(kX, 1300, 23.0), std::nullopt);
    }
    wired.wire(kX, 1511, {8850, kY, 0});
    wired.wire(kX, 1513, {8850, kY, 1});
    wired.switch_on(kX);
    wired.cycles(20);
    wired.receives(kY, 0, 0x1000);
    wired.receives(kY, 1, 0x0800);
    wired.cycles(1);
    EXPECT_NEAR(wired.axis(kX).actual().torque_demand, 0.375 * rated, 0.2 * rated) << torque_control;
    EXPECT_GT(wired.axis(kX).actual().torque_demand, 0.15 * rated) << torque_control;
  }
}

TEST(TorqueControl, IsLeftForSpeedControlByOff1AndOff3) {
  for (const auto& [word, braking, end] : {std::tuple{0x000E, State::Off1Braking, State::ReadyToSwitchOn},
                                           std::tuple{0x000B, State::QuickStopActive, State::SwitchOnDisabled}}) {
    WiredUnit wired;
    ASSERT_EQ(wired.write(kX, 1300, 23.0), std::nullopt);
    ASSERT_EQ(wired.write(kX, 1121, 1.0), std::nullopt);
    ASSERT_EQ(wired.write(kX, 1135, 1.0), std::nullopt);
    wired.switch_on(kX);
    wired.receives(kX, 3, 0x1000);
    wired.cycles(40);
    const double rpm = wired.rpm(kX);
    ASSERT_GT(rpm, 50.0);
    wired.receives(kX, 0, static_cast<std::uint16_t>(word));
    wired.cycles(3);
    EXPECT_EQ(wired.state(kX), braking);
    EXPECT_NEAR(wired.rpm(kX), rpm, 0.1 * rpm) << "no jump";
    wired.cycles(static_cast<int>(rpm / wired.read(kX, 1082) / kCycle) + 50);
    EXPECT_EQ(wired.state(kX), end) << "though the torque setpoint stands";
    EXPECT_NEAR(wired.rpm(kX), 0.0, 1.0);
  }
}

TEST(TorqueControl, HaltsWithoutTorque) {
  for (const int option : {1, 2, 3}) {
    WiredUnit wired;
    const double rated = wired.read(kX, 333);
    ASSERT_EQ(wired.write(kX, 1300, 23.0), std::nullopt);
    ASSERT_EQ(wired.write(kX, 1121, 0.4), std::nullopt);
    ASSERT_EQ(wired.write(kX, 1135, 0.2), std::nullopt);
    ASSERT_EQ(wired.write(kX, 8791, option), std::nullopt);
    wired.switch_on(kX);
    wired.receives(kX, 3, 0x2000);
    wired.cycles(10);
    ASSERT_NEAR(wired.axis(kX).actual().torque, 0.5 * rated, 0.02 * rated);
    wired.axis(kX).process_data().controlword = 0x010F;
    wired.cycles(25);  // 0.1 s: a quarter or half of the rated torque
    const double left = option == 1 ? 0.25 : 0.0;
    EXPECT_NEAR(wired.axis(kX).actual().torque, left * rated, 0.03 * rated) << "p8791 = " << option;
    wired.cycles(50);
    EXPECT_NEAR(wired.axis(kX).actual().torque, 0.0, 0.02 * rated);
    EXPECT_EQ(wired.state(kX), State::OperationEnabled);
    wired.axis(kX).process_data().controlword = 0x000F;
    wired.cycles(5);
    EXPECT_NEAR(wired.axis(kX).actual().torque, 0.5 * rated, 0.02 * rated) << "and goes on";
  }
}

}  // namespace
}  // namespace drive
