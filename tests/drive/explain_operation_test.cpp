// Every reason why an axis in Operation enabled does not turn, by an axis that is brought into it.
#include <gtest/gtest.h>

#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/explained_axis.hpp"

namespace drive {
namespace {

TEST(Explain, HoldingBrakeThatOpens) {
  AxisConfiguration configuration{};
  configuration.load.brake = {.torque = 20.0, .opening_time = 0.1, .closing_time = 0.1};
  Axis axis{configuration};
  ASSERT_TRUE(axis.write(1215, 1));
  AxisInputs inputs{};
  cycle(axis, inputs, 0.004);
  cycle(axis, inputs, 0.004);
  inputs.on = true;
  for (int i = 0; i < 4; ++i) cycle(axis, inputs, 0.004);

  EXPECT_EQ(axis.read(2).value(), 15.0);
  EXPECT_EQ(explain(axis).front(), "The holding brake opens (r0002 = 15): wait for its opening time.");
}

TEST(Explain, SpeedControllerThatIsInhibited) {
  Enabled drive;
  drive.inputs.enable_speed_controller = false;

  EXPECT_EQ(drive.told_after().substr(0, 85),
            "The speed controller is inhibited and gives no torque (p0856 = 1): write p0856 = 1 or");
}

TEST(Explain, HaltAtZeroSpeed) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(8791, 1));
  drive.inputs.controlword = 0x0100;

  EXPECT_EQ(drive.told_after(),
            "A halt keeps the axis at zero (bit 8 of the controlword with p8791 = 1): clear bit 8.\n");
}

TEST(Explain, EnablesOfTheRamp) {
  struct Enable {
    bool AxisInputs::*signal;
    const char* sentence;
  };
  for (const Enable& enable :
       {Enable{&AxisInputs::enable_ramp,
               "The ramp-function generator is held at zero (p1140 = 1): write p1140 = 1"},
        Enable{&AxisInputs::continue_ramp, "The ramp-function generator is frozen (p1141 = 1): write p1141 = 1"},
        Enable{&AxisInputs::enable_setpoint, "The setpoint is not enabled (p1142 = 1): write p1142 = 1"}}) {
    Enabled drive;
    drive.inputs.*enable.signal = false;
    EXPECT_EQ(drive.told_after().find(enable.sentence), 0U) << told(drive.axis);
  }
}

TEST(Explain, EnablesOfTheRampInVelocityMode) {
  Enabled drive;
  drive.axis.request_mode(2);
  drive.inputs.controlword = 0x000F;

  const std::string lines = drive.told_after();

  EXPECT_NE(lines.find("held at zero (bit 4 of the controlword in velocity mode): send 007Fh.\n"),
            std::string::npos);
  EXPECT_NE(lines.find("frozen (bit 5 of"), std::string::npos);
  EXPECT_NE(lines.find("not enabled (bit 6 of"), std::string::npos);
}

TEST(Explain, SetpointZero) {
  Enabled drive{0.0};

  EXPECT_EQ(drive.told_after(),
            "The speed setpoint is 0 (p1070 = r8860[1], p1155 = 0): send a setpoint (60FFh), or connect p1070 to "
            "another source.\n");
}

TEST(Explain, JogsWithoutASpeedAndAgainstEachOther) {
  WiredAxis drive;
  drive.inputs.jog_1 = true;
  ASSERT_TRUE(drive.axis.write(1058, 0.0));
  drive.cycles(5);
  EXPECT_EQ(told(drive.axis), "The jog speed is 0: write p1058 and p1059.\n");

  drive.inputs.jog_2 = true;
  drive.cycles(2);
  EXPECT_EQ(told(drive.axis), "Both jog bits are set, which is setpoint 0: take one of p1055 and p1056 away.\n");
}

TEST(Explain, DirectionThatIsInhibited) {
  Enabled drive{-100.0};
  drive.inputs.inhibit_negative = true;

  EXPECT_EQ(drive.told_after(),
            "The negative direction is inhibited (p1110 = 0): write p1110 = 0 or connect it, or reverse the "
            "setpoint.\n");
}

TEST(Explain, SpeedLimitsOfZero) {
  Enabled drive{100.0};
  ASSERT_TRUE(drive.axis.write(1083, 0.0));
  EXPECT_EQ(drive.told_after(),
            "The speed limit of the positive direction is 0: raise p1083 (p1085 = r1083[0]).\n");

  WiredAxis stopped;
  ASSERT_TRUE(stopped.axis.write(1082, 0.0));
  stopped.inputs.on = true;
  stopped.inputs.main_setpoint = 10.0;
  stopped.cycles(5);
  EXPECT_NE(told(stopped.axis).find("The maximum speed is 0 (p1082): write p1082.\n"), std::string::npos);
}

TEST(Explain, TorqueLimitsOfZero) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(1520, 0.0));

  EXPECT_NE(drive.told_after().find("The torque limits leave no torque in this direction"), std::string::npos)
      << told(drive.axis);
}

/// A load that holds the shaft with 5 N·m.
AxisConfiguration jammed() {
  AxisConfiguration configuration{};
  configuration.load.coulomb_friction = 5.0;
  return configuration;
}

TEST(Explain, MotorThatIsJammed) {
  Enabled drive{100.0, jammed()};
  ASSERT_TRUE(drive.axis.write(1520, 1.0));
  ASSERT_TRUE(drive.axis.write(1521, -1.0));

  EXPECT_EQ(
      drive.told_after(50),
      "The motor is at its torque limit (1 N·m) and does not turn: take the load or the brake away, or raise "
      "p1520, p1521 and p0640.\n");
}

TEST(Explain, RampThatHasJustBegun) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(1120, 999999.0));

  EXPECT_EQ(drive.told_after(), "The ramp begins (p1120 = 999999 s, to 100 rpm): wait, or shorten it.\n");
}

TEST(Explain, TorqueControlWithoutASetpoint) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(1300, 23));

  EXPECT_EQ(
      drive.told_after(),
      "Torque control is active and its setpoint is 0 (p1503 = r8850[3]): send 6071h, or choose speed control "
      "(6060h = 3).\n");
}

TEST(Explain, TorqueThatDoesNotMoveTheLoad) {
  Enabled drive{100.0, jammed()};
  ASSERT_TRUE(drive.axis.write(1300, 23));
  drive.inputs.torque_setpoint = 2.5;

  EXPECT_EQ(drive.told_after(), "The torque setpoint of 2.5 N·m does not move the load: raise it.\n");
}

}  // namespace
}  // namespace drive
