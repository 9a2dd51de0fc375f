// Modes of operation of an axis without a bus: codes, changeover in motion, torque control.
#include "drive/speed_control/operating_mode.hpp"

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
  EXPECT_TRUE(mode.has_ramp_bits(21));
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
  for (const Case& c :
       {Case{ObjectKind::Servo, 4, 4}, Case{ObjectKind::Servo, 2, 2}, Case{ObjectKind::Servo, -20, -20},
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
