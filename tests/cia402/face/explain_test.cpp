// Every reason why an axis does not move, by what its master does or leaves undone.
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr std::int64_t kSpeed = 200000;  // units/s

std::string told(const TestDevice& device, std::size_t axis = 1) {
  std::string lines;
  for (const std::string& sentence : device.device.explain(axis)) lines += sentence + "\n";
  return lines;
}

TEST(ExplainAxis, IsContentWithAnAxisThatTurns) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  ASSERT_EQ(device.write(0x60FF, kSpeed), 0U);
  device.passes(500ms);
  EXPECT_EQ(told(device), "");
}

TEST(ExplainAxis, LeavesTheWordToWhoCommandsTheAxis) {
  TestDevice device;
  device.start();
  const std::vector<std::string> commanding{"Another bus commands the axis."};
  EXPECT_EQ(device.device.explain(1, commanding), commanding);
}

TEST(ExplainAxis, TellsTheNmtStateUntilAControlwordComes) {
  TestDevice device;
  device.start();
  EXPECT_EQ(told(device),
            "The node is Pre-operational, so that no PDO is received: send the NMT command start (01h).\n"
            "The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to 6040h.\n");

  ASSERT_EQ(device.write(0x6040, 0x06), 0U) << "SDO needs no start";
  EXPECT_EQ(told(device), "The axis is in Ready to switch on: write 000Fh to 6040h.\n");
}

TEST(ExplainAxis, MissesTheVoltageOfTheDcLink) {
  Configuration configuration{.node_id = 5};
  configuration.supply.line_voltage = 0.0;
  TestDevice device{configuration};
  device.start_operational();
  EXPECT_EQ(told(device),
            "The DC link has no voltage: switch the supply on.\n"
            "The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to 6040h.\n");

  device.device.set_line_voltage(400.0, device.now);
  device.passes(100ms);
  EXPECT_EQ(told(device), "The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to 6040h.\n");
}

TEST(ExplainAxis, LeadsThroughTheStatesBelowOperationEnabled) {
  TestDevice device;
  device.start_operational();
  device.says("205#0600");
  device.passes(10ms);
  EXPECT_EQ(told(device), "The axis is in Ready to switch on: write 000Fh to 6040h.\n");

  device.says("205#0700");
  device.passes(10ms);
  EXPECT_EQ(told(device), "The axis is in Switched on: write 000Fh to 6040h.\n");
}

TEST(ExplainAxis, NamesTheObjectsOfAFurtherAxis) {
  TestDevice device{Configuration{.node_id = 5, .axes = std::vector<AxisSetup>(2)}};
  device.start_operational();
  ASSERT_EQ(device.write(0x6840, 0x06), 0U);
  EXPECT_EQ(told(device, 1), "The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to 6040h.\n");
  EXPECT_EQ(told(device, 2), "The axis is in Ready to switch on: write 000Fh to 6840h.\n");

  ASSERT_TRUE(device.device.raise(2, 30001, 0, device.now));
  device.passes(10ms);
  EXPECT_EQ(told(device, 2),
            "Error 2310h (683Fh) holds the axis in Fault: remove its cause, then let bit 7 of the controlword "
            "rise.\n");
}

TEST(ExplainAxis, Fault) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  ASSERT_TRUE(device.device.raise(1, 30001, 0, device.now));
  ASSERT_TRUE(device.reaches(0x4F, 0x08, 1000ms));
  EXPECT_EQ(told(device),
            "Error 2310h (603Fh) holds the axis in Fault: remove its cause, then let bit 7 of the controlword "
            "rise.\n");

  device.write(0x6040, 0x00);
  device.write(0x6040, 0x80);
  EXPECT_EQ(told(device), "The axis is in Switch on disabled: write 0006h, 0007h and 000Fh to 6040h.\n");
}

TEST(ExplainAxis, FaultReactionWhileItStillTurns) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  device.write(0x6085, kSpeed);  // quick stop within 1 s
  device.write(0x60FF, kSpeed);
  device.passes(300ms);
  device.says("000#8005");  // leaves Operational: 6007h
  EXPECT_EQ(told(device),
            "Error 8130h (603Fh) holds the axis in Fault reaction active: remove its cause, then let bit 7 of the "
            "controlword rise.\n");
}

TEST(ExplainAxis, QuickStopThatHolds) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  ASSERT_EQ(device.write(0x605A, 6), 0U);
  ASSERT_EQ(device.write(0x6040, 0x0B), 0U);
  device.passes(100ms);
  EXPECT_EQ(told(device), "Quick stop is active (6040h bit 2 = 0): write 000Fh, or disable the voltage.\n");

  ASSERT_EQ(device.write(0x6040, 0x0F), 0U);
  EXPECT_EQ(told(device), "The target velocity 60FFh is 0.\n");
}

TEST(ExplainAxis, PulsesThatAreStillToCome) {
  TestDevice device;
  device.start_operational();
  device.write(0x6060, 3);
  device.write(0x60FF, kSpeed);
  for (const int word : {0x06, 0x07, 0x0F}) ASSERT_EQ(device.write(0x6040, word), 0U);
  EXPECT_EQ(told(device), "The motor is magnetised, or its brake opens: it turns after that.\n");

  device.passes(500ms);
  EXPECT_EQ(told(device), "");
}

TEST(ExplainAxis, BrakeThatOpens) {
  Configuration configuration{.node_id = 5};
  configuration.axes.front().drive.load.brake.torque = 100.0;
  TestDevice device{configuration};
  device.enable(Mode::ProfileVelocity);
  device.write(0x60FF, kSpeed);
  device.passes(20ms);
  EXPECT_EQ(told(device), "The motor is magnetised, or its brake opens: it turns after that.\n");

  device.passes(1s);
  EXPECT_EQ(told(device), "");
}

TEST(ExplainAxis, Halt) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  device.write(0x60FF, kSpeed);
  device.passes(300ms);
  ASSERT_EQ(device.write(0x6040, 0x010F), 0U);
  device.passes(1s);
  EXPECT_EQ(told(device), "Halt: bit 8 of 6040h is set.\n");

  ASSERT_EQ(device.write(0x6040, 0x000F), 0U);
  device.passes(500ms);
  EXPECT_EQ(told(device), "");
}

TEST(ExplainAxis, ModeThatIsMissing) {
  TestDevice device;
  device.enable(Mode::None);
  EXPECT_EQ(told(device), "No mode is chosen: write 6060h.\n");
}

TEST(ExplainAxis, SetPointOfProfilePositionThatIsMissing) {
  const std::string missing = "No set-point was handed over: write 607Ah, then let bit 4 of 6040h rise.\n";
  TestDevice device;
  device.enable(Mode::ProfilePosition);
  device.write(0x607A, 20000);
  EXPECT_EQ(told(device), missing) << "the target alone is none";

  ASSERT_EQ(device.write(0x6040, 0x1F), 0U);
  EXPECT_EQ(told(device), "");
  ASSERT_EQ(device.write(0x6040, 0x0F), 0U);
  ASSERT_TRUE(device.reaches(0x1400, 0x0400, 2000ms));
  device.passes(200ms);
  EXPECT_EQ(told(device), missing) << "it has arrived";
}

TEST(ExplainAxis, TargetsThatAreZero) {
  struct Row {
    Mode mode;
    std::uint16_t index;
    std::int64_t target;
    const char* sentence;
  };
  for (const Row& row : {Row{Mode::ProfileVelocity, 0x60FF, kSpeed, "The target velocity 60FFh is 0.\n"},
                         Row{Mode::ProfileTorque, 0x6071, 200, "The target torque 6071h is 0.\n"}}) {
    TestDevice device;
    device.enable(row.mode);
    EXPECT_EQ(told(device), row.sentence);
    ASSERT_EQ(device.write(row.index, row.target), 0U);
    EXPECT_EQ(told(device), "") << row.sentence;
  }
}

TEST(ExplainAxis, VelocityModeWithoutTargetAndWithoutItsRamp) {
  const std::string ramp = "The ramp is not enabled, unlocked and led: set bits 4, 5 and 6 of 6040h.\n";
  TestDevice device;
  device.enable(Mode::Velocity);
  EXPECT_EQ(told(device), "The target velocity 6042h is 0.\n" + ramp);

  ASSERT_EQ(device.write(0x6042, 100), 0U);
  for (const int word : {0x0F, 0x1F, 0x3F, 0x6F}) {
    ASSERT_EQ(device.write(0x6040, word), 0U);
    EXPECT_EQ(told(device), ramp) << word;
  }
  ASSERT_EQ(device.write(0x6040, 0x7F), 0U);
  device.passes(500ms);
  EXPECT_EQ(told(device), "");
}

TEST(ExplainAxis, HomingThatDoesNotRun) {
  const std::string idle = "No homing runs: choose a method in 6098h, then let bit 4 of 6040h rise.\n";
  TestDevice device;
  device.enable(Mode::Homing);
  ASSERT_EQ(device.write(0x6098, 34), 0U);
  EXPECT_EQ(told(device), idle) << "a method alone begins nothing";

  ASSERT_EQ(device.write(0x6040, 0x1F), 0U);
  EXPECT_EQ(told(device), "");
  ASSERT_TRUE(device.reaches(0x3400, 0x1400, 10s));
  device.passes(500ms);
  EXPECT_EQ(told(device), idle) << "it is over";
}

TEST(ExplainAxis, SetPointsOfCyclicModesThatDoNotCome) {
  struct Row {
    Mode mode;
    std::uint16_t index;
    std::int64_t set_point;
  };
  for (const Row& row :
       {Row{Mode::CyclicSynchronousPosition, 0x607A, 1000}, Row{Mode::CyclicSynchronousVelocity, 0x60FF, kSpeed},
        Row{Mode::CyclicSynchronousTorque, 0x6071, 100}}) {
    TestDevice device;
    device.enable(row.mode);
    EXPECT_EQ(told(device), "No set-point is followed (statusword bit 12 = 0): send one with each SYNC.\n")
        << name_of(row.mode);
    ASSERT_EQ(device.write(row.index, row.set_point), 0U);
    EXPECT_EQ(told(device), "") << name_of(row.mode);
  }
}

TEST(ExplainAxis, InterpolationThatIsNotActive) {
  TestDevice device;
  device.enable(Mode::InterpolatedPosition);
  EXPECT_EQ(told(device), "Interpolation is not active: set bit 4 of 6040h.\n");

  ASSERT_EQ(device.write(0x6040, 0x1F), 0U);
  EXPECT_EQ(told(device), "");
}

/// A device that was told to turn with @p speed, with @p fitted as the switch of @p signal beside its way.
struct BesideSwitch : TestDevice {
  BesideSwitch(Signal signal, const TravelSwitch& fitted, std::int64_t speed) : TestDevice{with(signal, fitted)} {
    enable(Mode::ProfileVelocity);
    turn(speed);
  }
  static Configuration with(Signal signal, const TravelSwitch& fitted) {
    Configuration configuration{.node_id = 5};
    configuration.axes.front().switches.set(signal, fitted);
    return configuration;
  }
  void turn(std::int64_t speed) {
    EXPECT_EQ(write(0x60FF, speed), 0U);
    passes(2s);
  }
};

TEST(ExplainAxis, NegativeLimitSwitch) {
  BesideSwitch device{Signal::NegativeLimit, {.from = -1e6, .to = 0.5}, -kSpeed};
  EXPECT_EQ(told(device), "The negative limit switch is reached: nothing moves towards it.\n");

  device.turn(kSpeed);
  EXPECT_EQ(told(device), "") << "it turns away";
  device.turn(0);
  EXPECT_EQ(told(device), "The target velocity 60FFh is 0.\n");
}

TEST(ExplainAxis, PositiveLimitSwitch) {
  BesideSwitch device{Signal::PositiveLimit, {.from = 1.0, .to = 1e6}, kSpeed};
  EXPECT_EQ(told(device), "The positive limit switch is reached: nothing moves towards it.\n");
}

TEST(ExplainAxis, TorqueLimitOfZero) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  ASSERT_EQ(device.write(0x6072, 0), 0U);
  ASSERT_EQ(device.write(0x60FF, kSpeed), 0U);
  device.passes(50ms);
  EXPECT_EQ(told(device), "The torque limit 6072h is 0.\n");

  ASSERT_EQ(device.write(0x6072, 1000), 0U);
  device.passes(500ms);
  EXPECT_EQ(told(device), "");
}

}  // namespace
}  // namespace cia402
