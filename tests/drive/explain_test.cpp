// Every reason why an axis does not turn, by an axis that is brought into it.
#include "drive/explain.hpp"

#include <algorithm>
#include <string>

#include "drive/parameter/bico.hpp"
#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

/// The reasons as lines.
std::string told(const Axis& axis) {
  std::string lines;
  for (const std::string& sentence : explain(axis)) lines += sentence + "\n";
  return lines;
}

/// An axis in Operation enabled with a setpoint of 100 rpm and a ramp that takes no time.
struct Enabled : WiredAxis {
  explicit Enabled(double rpm = 100.0, const AxisConfiguration& configuration = {}) : WiredAxis{configuration} {
    inputs.on = true;
    inputs.main_setpoint = rpm * kRpm;
  }
  std::string told_after(int count = 5) {
    cycles(count);
    EXPECT_EQ(state(), State::OperationEnabled);
    return told(axis);
  }
};

TEST(Explain, SaysThatItTurns) {
  Enabled drive;

  EXPECT_EQ(drive.told_after(250), "It turns at 100 rpm (setpoint 100 rpm).\n");
}

TEST(Explain, RunUp) {
  const Axis axis{AxisConfiguration{}};

  EXPECT_EQ(told(axis), "The axis is in run-up (r0002 = 70): wait for its first cycle.\n");
}

TEST(Explain, Commissioning) {
  WiredAxis drive;
  ASSERT_TRUE(drive.axis.write(10, 1));
  drive.cycles(1);

  EXPECT_EQ(told(drive.axis), "Commissioning keeps the axis off (p0010 = 1): write p0010 = 0.\n");

  ASSERT_TRUE(drive.axis.write(10, 0));
  drive.axis.inhibit(true);
  drive.cycles(1);
  EXPECT_EQ(told(drive.axis),
            "Commissioning of the unit keeps the axis off: write p0009 = 0 on the control unit.\n");
}

TEST(Explain, Off2OfAControlword) {
  WiredAxis drive;
  drive.inputs.no_off2 = false;
  drive.cycles(1);

  EXPECT_EQ(told(drive.axis), "OFF2 is given by p0844 = r8890.1: send a controlword with bit 1 = 1.\n");
}

TEST(Explain, Off2OfAConstantAndOfAnotherSource) {
  WiredAxis drive;
  drive.inputs.no_off2_second = false;
  drive.cycles(1);
  ASSERT_TRUE(drive.axis.write(845, 0));
  EXPECT_EQ(told(drive.axis), "OFF2 is given by p0845 = 0: write p0845 = 1 or connect it.\n");

  ASSERT_TRUE(drive.axis.write(845, pack({2139, kOwnObject, 3})));
  EXPECT_EQ(told(drive.axis), "OFF2 is given by p0845 = r2139.3: make r2139.3 1.\n");
}

TEST(Explain, Off3) {
  WiredAxis drive;
  drive.inputs.no_off3 = false;
  drive.cycles(1);

  EXPECT_EQ(told(drive.axis), "OFF3 is given by p0848 = r8890.2: send a controlword with bit 2 = 1.\n");
}

TEST(Explain, OnThatNeedsAnEdge) {
  WiredAxis drive;
  drive.inputs.on = true;
  drive.inputs.no_off2 = false;
  drive.cycles(1);
  drive.inputs.no_off2 = true;
  drive.cycles(1);

  EXPECT_EQ(told(drive.axis),
            "ON (p0840 = r8890.0) is still set and needs an edge: send 0006h first, then 000Fh.\n");
}

TEST(Explain, OnThatIsMissing) {
  const WiredAxis drive;

  EXPECT_EQ(told(drive.axis),
            "ON is missing (p0840 = r8890.0): send a controlword with bit 0 = 1, together with operation enable "
            "000Fh.\n");
}

TEST(Explain, OperationEnableThatIsMissing) {
  WiredAxis drive;
  drive.inputs.enable_operation = false;
  drive.inputs.on = true;
  drive.cycles(2);

  EXPECT_EQ(told(drive.axis),
            "The operation enable is missing (p0852 = r8890.3): send a controlword with bit 3 = 1.\n");
}

TEST(Explain, HaltWithThePulsesOff) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(8791, 0));
  drive.inputs.controlword = 0x0100;
  drive.cycles(3);

  EXPECT_EQ(told(drive.axis),
            "A halt keeps the pulses off (bit 8 of the controlword with p8791 = 0): clear bit 8.\n");
}

TEST(Explain, InfeedAndDcLink) {
  Enabled drive;
  drive.inputs.infeed_operates = false;
  drive.cycles(3);
  EXPECT_EQ(
      told(drive.axis),
      "The infeed does not operate (p0864 = 1, r0002 = 23): write p0864 = 1 or connect it before p0857 ends in "
      "F07840.\n");

  Axis dead{AxisConfiguration{}, 0, 0, {.line_voltage = 0.0}};
  AxisInputs inputs{};
  dead.cycle(inputs, 0.004);
  dead.cycle(inputs, 0.004);
  inputs.on = true;
  dead.cycle(inputs, 0.004);
  EXPECT_NE(told(dead).find("V, less than 360 V: switch the line on before p0857 ends in F07802."),
            std::string::npos)
      << told(dead);
}

TEST(Explain, Faults) {
  Enabled drive;
  drive.cycles(250);
  ASSERT_TRUE(drive.axis.raise(30001, 2));
  ASSERT_TRUE(drive.axis.raise(30022));
  drive.inputs.no_external_fault_1 = false;
  drive.cycles(1);

  EXPECT_EQ(
      told(drive.axis),
      "Fault F30001 Power unit overcurrent (value 2): it can be acknowledged, by bit 7 of the controlword from "
      "0 to 1; then give ON anew (0006h, 000Fh).\n"
      "Fault F30022 Monitoring U_ce (value 0): it leaves only when the unit is switched off and on.\n"
      "Fault F07860 External fault 1 (value 0): its cause is still there (0 at p2106); remove it, then "
      "acknowledge.\n");
}

TEST(Explain, BrakingByOffAndByFault) {
  const auto braking = [](auto stop) {
    Enabled drive{1000.0};
    EXPECT_TRUE(drive.axis.write(1135, 10.0));
    drive.cycles(250);
    stop(drive);
    drive.cycles(1);
    return told(drive.axis);
  };

  EXPECT_EQ(braking([](Enabled& drive) { drive.inputs.on = false; }),
            "OFF1 brakes the axis (p1121 = 10 s): wait for Ready to switch on, or give ON again (000Fh).\n");
  EXPECT_EQ(braking([](Enabled& drive) { drive.inputs.no_off3 = false; }),
            "OFF3 brakes the axis (p1135 = 10 s) and is not taken back: wait, then send 0006h and 000Fh.\n");
  EXPECT_NE(braking([](Enabled& drive) { EXPECT_TRUE(drive.axis.raise(8702)); }).find("still brakes because of"),
            std::string::npos);
}

TEST(Explain, Stop2) {
  Enabled drive;
  ASSERT_TRUE(drive.axis.write(2100, 7860));
  ASSERT_TRUE(drive.axis.write(2101, 5));
  drive.cycles(250);
  ASSERT_TRUE(drive.axis.raise(7860));
  drive.cycles(250);

  EXPECT_NE(told(drive.axis).find("STOP2 holds the shaft at zero speed: acknowledge, or give OFF1 (0006h).\n"),
            std::string::npos);
}

TEST(Explain, HoldingBrakeThatOpens) {
  AxisConfiguration configuration{};
  configuration.load.brake = {.torque = 20.0, .opening_time = 0.1, .closing_time = 0.1};
  Axis axis{configuration};
  ASSERT_TRUE(axis.write(1215, 1));
  AxisInputs inputs{};
  axis.cycle(inputs, 0.004);
  axis.cycle(inputs, 0.004);
  inputs.on = true;
  for (int i = 0; i < 4; ++i) axis.cycle(inputs, 0.004);

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
