// Modes of operation of an axis without a bus: codes, changeover in motion, torque control.
#include "drive/operating_mode.hpp"

#include <cmath>

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

struct CodeRow {
  int code;
  std::int32_t control_mode;  ///< p1300, or -1
};
const std::vector<CodeRow> kCodes{{3, 21},   {4, 23},   {-20, 20}, {-22, 22}, {0, 0},    {-1, 1},   {-7, 7},
                                  {-15, 15}, {-18, 18}, {-19, 19}, {1, -1},   {6, -1},   {-21, -1}, {-23, -1},
                                  {-24, -1}, {5, -1},   {7, -1},   {127, -1}, {-128, -1}};

TEST(OperatingMode, HasACodeForEveryControlMode) {
  for (const CodeRow& row : kCodes) {
    const auto found = control_mode_of(static_cast<std::int8_t>(row.code), true);
    EXPECT_EQ(found.value_or(-1), row.control_mode) << row.code;
    if (found) {
      EXPECT_EQ(mode_of(*found), row.code);
    }
  }
  EXPECT_EQ(control_mode_of(2, true), 21);
  EXPECT_EQ(control_mode_of(2, false), 20);
}

TEST(OperatingMode, KeepsWhatWasAskedForAndShowsWhatIsActive) {
  OperatingMode mode;
  EXPECT_EQ(mode.requested(), 3);
  EXPECT_EQ(mode.display(21), 3);
  mode.on_request(6, 21, false);
  EXPECT_EQ(mode.requested(), 6);
  EXPECT_EQ(mode.display(21), 3);
  mode.on_request(2, 21, true);
  EXPECT_EQ(mode.display(21), 2);
  EXPECT_EQ(mode.display(20), 2) << "without encoder too";
  EXPECT_TRUE(mode.velocity_mode(21));
  mode.on_request(1, 21, false);
  EXPECT_EQ(mode.display(21), 2) << "what is not possible changes nothing";
  mode.on_parameter(23);
  EXPECT_EQ(mode.requested(), 4);
  EXPECT_EQ(mode.display(23), 4);
  mode.on_parameter(21);
  EXPECT_EQ(mode.requested(), 3);
  EXPECT_EQ(mode.display(21), 3) << "p1300 has ended mode 2";
}

TEST(OperatingMode, TogglesByProcessData) {
  OperatingMode mode;
  struct Step {
    int code;
    int shown;
  };
  for (const Step& step : {Step{3, 3}, Step{4, 4}, Step{3, 3}, Step{2, 2}, Step{4, 4}, Step{2, 2}, Step{3, 3},
                           Step{4, 4}, Step{0, 4}, Step{6, 4}, Step{-5, 4}, Step{3, 3}, Step{1, 3}}) {
    EXPECT_TRUE(mode.on_process_data(static_cast<std::int8_t>(step.code), 21));
    EXPECT_EQ(mode.display(21), step.shown) << step.code;
    EXPECT_EQ(mode.torque_control(21), step.shown == 4);
  }
  mode.on_process_data(4, 21);
  mode.on_process_data(std::nullopt, 21);
  EXPECT_EQ(mode.display(21), 3) << "no longer mapped";
}

TEST(OperatingMode, DoesNotToggleWhereP1300IsNotSpeedControl) {
  for (const std::int32_t control_mode : {0, 5, 19, 22, 23}) {
    OperatingMode mode;
    mode.on_parameter(control_mode);
    for (const int code : {2, 3, 4, -20, -22}) {
      EXPECT_TRUE(mode.on_process_data(static_cast<std::int8_t>(code), control_mode));
      EXPECT_EQ(mode.display(control_mode), mode_of(control_mode)) << code << " with p1300 = " << control_mode;
      EXPECT_EQ(mode.requested(), code);
    }
  }
}

TEST(OperatingMode, RefusesTorqueWithoutEncoderOnce) {
  OperatingMode mode;
  mode.on_parameter(20);
  EXPECT_FALSE(mode.on_process_data(4, 20));
  EXPECT_TRUE(mode.on_process_data(4, 20)) << "asked for in the cycle before";
  EXPECT_EQ(mode.display(20), -20);
  EXPECT_FALSE(mode.on_changeover(true, 20));
  EXPECT_TRUE(mode.on_changeover(true, 20));
  EXPECT_FALSE(mode.torque_control(20));
  EXPECT_TRUE(mode.on_changeover(true, 21));
  EXPECT_TRUE(mode.torque_control(21));
}

AxisConfiguration without_encoder(ObjectKind kind = ObjectKind::Servo) {
  AxisConfiguration configuration{.kind = kind};
  configuration.machine.encoder.type = motor::EncoderType::None;
  return configuration;
}

TEST(RequestedMode, IsP1300WhereThatHasIt) {
  struct Case {
    ObjectKind kind;
    int code, shown;
  };
  for (const Case& c : {Case{ObjectKind::Servo, 4, 4}, Case{ObjectKind::Servo, 2, 2}, Case{ObjectKind::Servo, -20, -20},
                        Case{ObjectKind::Servo, -22, -22}, Case{ObjectKind::Servo, -5, 3}, Case{ObjectKind::Servo, 0, 3},
                        Case{ObjectKind::Servo, 1, 3}, Case{ObjectKind::Servo, 6, 3}, Case{ObjectKind::Servo, 100, 3},
                        Case{ObjectKind::Vector, -5, -5}, Case{ObjectKind::Vector, -19, -19}, Case{ObjectKind::Vector, 0, 0},
                        Case{ObjectKind::Vector, 4, 4}}) {
    Axis axis{AxisConfiguration{.kind = c.kind}};
    ASSERT_TRUE(axis.write(1300, 21.0));
    axis.request_mode(static_cast<std::int8_t>(c.code));
    EXPECT_EQ(axis.requested_mode(), c.code);
    EXPECT_EQ(axis.actual().mode, c.shown) << c.code << (c.kind == ObjectKind::Servo ? " servo" : " vector");
  }
}

TEST(RequestedMode, IsNotTakenWithThePulsesOn) {
  WiredUnit wired;
  wired.switch_on(kX);
  wired.axis(kX).request_mode(4);
  EXPECT_EQ(wired.axis(kX).requested_mode(), 4);
  EXPECT_EQ(wired.axis(kX).actual().mode, 3);
  wired.axis(kX).request_mode(2);
  EXPECT_EQ(wired.axis(kX).actual().mode, 3);
  EXPECT_EQ(wired.read(kX, 1300), 21.0);
}

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
  for (const auto& [word, braking, end] :
       {std::tuple{0x000E, State::Off1Braking, State::ReadyToSwitchOn},
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
    wired.receives(kX, 0, 0x010F);
    wired.cycles(25);  // 0.1 s: a quarter or half of the rated torque
    const double left = option == 1 ? 0.25 : 0.0;
    EXPECT_NEAR(wired.axis(kX).actual().torque, left * rated, 0.03 * rated) << "p8791 = " << option;
    wired.cycles(50);
    EXPECT_NEAR(wired.axis(kX).actual().torque, 0.0, 0.02 * rated);
    EXPECT_EQ(wired.state(kX), State::OperationEnabled);
    wired.receives(kX, 0, 0x000F);
    wired.cycles(5);
    EXPECT_NEAR(wired.axis(kX).actual().torque, 0.5 * rated, 0.02 * rated) << "and goes on";
  }
}

TEST(TorqueControl, IsImpossibleWithoutAnEncoder) {
  DriveUnit unit{{.axes = {without_encoder()}, .node_id = 5}};
  Axis& axis = unit.axes()[0];
  ASSERT_TRUE(axis.write(1300, 20.0));
  ASSERT_TRUE(axis.write(1501, pack({8890, kOwnObject, 12})));
  const std::array awake{true};
  for (const int word : {0x0006, 0x0006, 0x0007, 0x000F, 0x000F}) {
    axis.process_data().received[0] = static_cast<std::uint16_t>(word);
    unit.cycle(awake, kCycle);
  }
  ASSERT_EQ(axis.actual().state, State::OperationEnabled);
  axis.process_data().received[0] = 0x100F;
  unit.cycle(awake, kCycle);
  unit.cycle(awake, kCycle);
  ASSERT_FALSE(axis.messages().faults().empty());
  EXPECT_EQ(axis.messages().faults()[0].row->number, 7430);
  EXPECT_EQ(axis.actual().mode, -20);
}

}  // namespace
}  // namespace drive
