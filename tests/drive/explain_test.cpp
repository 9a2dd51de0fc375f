// Every reason why an axis is not in Operation enabled, by an axis that is brought into it.
#include "drive/parameter/bico.hpp"
#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/explained_axis.hpp"

namespace drive {
namespace {

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
  cycle(dead, inputs, 0.004);
  cycle(dead, inputs, 0.004);
  inputs.on = true;
  cycle(dead, inputs, 0.004);
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

TEST(Explain, AMotorThatItsTorqueLimitsBlockByThemselves) {
  Enabled drive{100.0, {.load = {.coulomb_friction = 5.0}}};
  ASSERT_TRUE(drive.axis.write(1520, 0.0));
  ASSERT_TRUE(drive.axis.write(1521, 0.0));
  drive.run(2.0);
  ASSERT_EQ(drive.state(), State::Fault);

  EXPECT_EQ(
      told(drive.axis),
      "Fault F07900 Motor blocked (value 0): it can be acknowledged, by bit 7 of the controlword from 0 to 1; "
      "then give ON anew (0006h, 000Fh). The torque limits leave no torque (0 to 0 N·m; p1520 = 0, p1521 = 0): "
      "widen them first.\n");

  ASSERT_TRUE(drive.axis.write(1521, -10.0));
  drive.cycles(1);
  EXPECT_NE(told(drive.axis).find("The torque limits leave no torque in the positive direction (-10 to 0 N·m;"),
            std::string::npos)
      << told(drive.axis);
  ASSERT_TRUE(drive.axis.write(1520, 10.0));
  drive.cycles(1);
  EXPECT_EQ(told(drive.axis).find("torque limits"), std::string::npos) << told(drive.axis);
}

TEST(Explain, AShaftThatTheLoadDrives) {
  WiredAxis drive{{.load = {.constant_torque = 50.0}}};
  drive.run(0.01);
  EXPECT_NE(told(drive.axis).find(" rpm, since the pulses are off: take the load away, or brake it.\n"),
            std::string::npos)
      << told(drive.axis);

  drive.run(5.0);
  EXPECT_NE(told(drive.axis)
                .find("The load drives the shaft at -10800 rpm, the most that its rotor holds, since the "
                      "pulses are off: take the load away, or brake it.\n"),
            std::string::npos)
      << told(drive.axis);

  drive.axis.set_load_torque(0.0);
  drive.run(0.01);
  EXPECT_EQ(told(drive.axis).find("load drives"), std::string::npos) << "it coasts";
}

TEST(Explain, ALoadThatIsStrongerThanTheTorqueLimit) {
  Enabled drive{100.0};
  drive.run(1.0);
  ASSERT_TRUE(drive.axis.write(1520, 1.0));
  ASSERT_TRUE(drive.axis.write(1521, -1.0));
  drive.axis.set_load_torque(2.0);
  drive.run(0.3);

  EXPECT_NE(told(drive.axis).find("; the load drives it against its torque limit)."), std::string::npos)
      << told(drive.axis);

  drive.inputs.on = false;
  drive.run(0.1);
  EXPECT_NE(told(drive.axis)
                .find(" rpm against the torque limit: take the load away, or raise p1520, p1521 and "
                      "p0640.\n"),
            std::string::npos)
      << told(drive.axis);
}

TEST(Explain, AFaultThatWasAcknowledgedWhileItsCauseEnds) {
  WiredAxis drive;
  drive.cycles(2);
  ASSERT_TRUE(drive.axis.raise(8700, 1, Cause::Ending));

  ASSERT_NE(told(drive.axis).find("F08700 CAN communication error (value 1): its cause is still there"),
            std::string::npos);
  EXPECT_FALSE(drive.axis.acknowledge());
  EXPECT_NE(told(drive.axis).find("F08700 CAN communication error (value 1): it is acknowledged and leaves"),
            std::string::npos);

  drive.axis.withdraw(8700);
  EXPECT_EQ(told(drive.axis).find("F08700"), std::string::npos);
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

}  // namespace
}  // namespace drive
