// What faults do to an axis that turns: the way down, the state at its end, and what follows.
#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

constexpr double kOff1Time = 7.2;   // 1000 rpm a second
constexpr double kOff3Time = 1.44;  // 5000 rpm a second
constexpr double kOff1Slope = 1000.0;
constexpr double kOff3Slope = 5000.0;

/// Turns at @p rpm with different ramps for OFF1 and OFF3.
TestAxis turning(double rpm) {
  TestAxis drive;
  EXPECT_TRUE(drive.axis.write(1121, kOff1Time));
  EXPECT_TRUE(drive.axis.write(1135, kOff3Time));
  drive.turn_at(rpm);
  return drive;
}

/// p2101 of a fault.
void set_reaction(Axis& axis, std::uint16_t number, int reaction) {
  ASSERT_TRUE(axis.write(2100, number));
  ASSERT_TRUE(axis.write(2101, reaction));
}

struct Case {
  const char* name;
  std::uint16_t fault;
  int reaction;   ///< p2101, -1 = as the table has it
  double slope;   ///< rpm a second; 0 = the motor coasts or goes on
  State at_once;  ///< in the cycle of the fault
  State finally;
};
constexpr int kStandard = -1;

class FaultReaction : public testing::TestWithParam<Case> {};

TEST_P(FaultReaction, StopsTheMotorAsItIsMeantFromBothDirections) {
  const Case& expected = GetParam();
  for (const double direction : {1.0, -1.0}) {
    TestAxis drive = turning(direction * 1000.0);
    if (expected.reaction != kStandard) set_reaction(drive.axis, expected.fault, expected.reaction);

    ASSERT_TRUE(drive.axis.raise(expected.fault));
    EXPECT_EQ(drive.state(), expected.at_once);
    drive.run(0.1);
    EXPECT_EQ(drive.state(), expected.at_once);
    const bool powered = pulses_enabled_in(expected.at_once);
    EXPECT_EQ(drive.axis.actual().pulses_enabled, powered);
    if (powered) {
      EXPECT_NEAR(direction * drive.rpm(), 1000.0 - expected.slope * 0.1, 30.0);
    } else
      EXPECT_GT(direction * drive.rpm(), 800.0) << "it coasts";
    drive.run(3.0);

    EXPECT_EQ(drive.state(), expected.finally);
    EXPECT_EQ(drive.axis.actual().pulses_enabled, pulses_enabled_in(expected.finally));
    const double end = expected.finally == State::OperationEnabled ? 1000.0 : 0.0;
    if (powered) {
      EXPECT_NEAR(direction * drive.rpm(), end, 2.0);
    }
    EXPECT_NE(drive.status() & 0x0008, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Reactions, FaultReaction,
    testing::Values(Case{"Off1", 7220, kStandard, kOff1Slope, State::FaultReactionActive, State::Fault},
                    Case{"Off2", 30001, kStandard, 0.0, State::Fault, State::Fault},
                    Case{"Off3", 8702, kStandard, kOff3Slope, State::FaultReactionActive, State::Fault},
                    Case{"Stop2", 7860, 5, kOff3Slope, State::Stop2Active, State::Stop2Active},
                    Case{"Encoder", 31118, kStandard, 0.0, State::Fault, State::Fault},
                    Case{"ShortCircuit", 7860, 6, 0.0, State::Fault, State::Fault},
                    Case{"None", 7950, kStandard, 0.0, State::OperationEnabled, State::OperationEnabled},
                    Case{"Off2MadeOff1", 7860, 1, kOff1Slope, State::FaultReactionActive, State::Fault},
                    Case{"Off1MadeOff3", 7220, 3, kOff3Slope, State::FaultReactionActive, State::Fault},
                    Case{"Off2MadeNone", 7860, 0, 0.0, State::OperationEnabled, State::OperationEnabled}),
    [](const auto& test) { return test.param.name; });

TEST(Stop2, HoldsTheShaftAgainstALoadUntilItIsAcknowledged) {
  TestAxis drive = turning(1000.0);
  set_reaction(drive.axis, 7860, 5);

  ASSERT_TRUE(drive.axis.raise(7860));
  drive.run(0.1);
  EXPECT_FALSE(drive.axis.acknowledge()) << "it still brakes";
  drive.run(1.0);
  drive.axis.set_load_torque(5.0);
  drive.run(1.0);
  EXPECT_NEAR(drive.rpm(), 0.0, 1.0);
  EXPECT_NEAR(drive.axis.actual().torque, 5.0, 0.2);
  EXPECT_EQ(drive.status() & 0x006F, 0x002F);
  EXPECT_EQ(drive.axis.read(2).value(), 18.0);

  drive.send(0x008F);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled) << "ON needs an edge";
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

TEST(Stop2, EndsInFaultWithEveryOff) {
  for (const std::uint16_t off : {std::uint16_t{0x0000}, std::uint16_t{0x0006}, std::uint16_t{0x000B}}) {
    TestAxis drive = turning(1000.0);
    set_reaction(drive.axis, 7860, 5);
    ASSERT_TRUE(drive.axis.raise(7860));
    drive.run(1.0);
    ASSERT_EQ(drive.state(), State::Stop2Active);

    drive.send(off);
    drive.run(0.1);

    EXPECT_EQ(drive.state(), State::Fault) << off;
    EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  }
}

TEST(Stop2, IsNotAcknowledgedBeforeItsSetpointIsAtRestTooThoughTheShaftStands) {
  TestAxis drive{{.load = {.inertia = 0.05}}};
  ASSERT_TRUE(drive.axis.write(1135, 3.6));  // 2000 rpm a second
  drive.turn_at(1000.0);
  set_reaction(drive.axis, 7860, 5);
  ASSERT_TRUE(drive.axis.raise(7860));
  drive.axis.set_load_torque(80.0, motor::LoadTorqueType::Friction);  // more than the motor has

  drive.run(0.3);
  ASSERT_NEAR(drive.rpm(), 0.0, 1.0);
  ASSERT_GT(drive.demand_rpm(), 200.0);
  EXPECT_FALSE(drive.axis.acknowledge()) << "it still brakes";
  EXPECT_EQ(drive.state(), State::Stop2Active);
  drive.run(0.4);

  EXPECT_TRUE(drive.axis.acknowledge());
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
}

struct Pair {
  const char* name;
  std::uint16_t first, second;
  double slope_after;  ///< of the second 100 ms, rpm a second
  State state;         ///< after the second
};

class SecondFault : public testing::TestWithParam<Pair> {};

TEST_P(SecondFault, SharpensTheReactionAndNeverSoftensIt) {
  const Pair& expected = GetParam();
  TestAxis drive = turning(1500.0);
  set_reaction(drive.axis, 7860, 5);
  ASSERT_TRUE(drive.axis.raise(expected.first));
  drive.run(0.1);
  const double before = drive.rpm();

  ASSERT_TRUE(drive.axis.raise(expected.second));
  drive.run(0.1);

  EXPECT_EQ(drive.state(), expected.state);
  if (pulses_enabled_in(expected.state)) {
    EXPECT_NEAR(before - drive.rpm(), 0.1 * expected.slope_after, 30.0);
  }
  EXPECT_EQ(drive.axis.messages().faults().size(), 2u);
  EXPECT_EQ(drive.axis.acknowledge(), expected.state == State::Fault);
}

INSTANTIATE_TEST_SUITE_P(Pairs, SecondFault,
                         testing::Values(Pair{"Off1ThenOff3", 7220, 8702, kOff3Slope, State::FaultReactionActive},
                                         Pair{"Off1ThenOff2", 7220, 30001, 0.0, State::Fault},
                                         Pair{"Off3ThenOff1", 8702, 7220, kOff3Slope, State::FaultReactionActive},
                                         Pair{"Off3ThenOff2", 8702, 30001, 0.0, State::Fault},
                                         Pair{"Off1ThenStop2", 7220, 7860, kOff3Slope, State::FaultReactionActive},
                                         Pair{"Stop2ThenOff1", 7860, 7220, kOff3Slope, State::FaultReactionActive},
                                         Pair{"Stop2ThenOff2", 7860, 30001, 0.0, State::Fault},
                                         Pair{"Off3ThenNone", 8702, 7950, kOff3Slope, State::FaultReactionActive}),
                         [](const auto& test) { return test.param.name; });

struct During {
  const char* name;
  std::uint16_t controlword;  ///< that the axis brakes with
  std::uint16_t fault;
  double slope_after;
  State state;
};

class FaultWhileBraking : public testing::TestWithParam<During> {};

TEST_P(FaultWhileBraking, GoesOnBrakingAtLeastAsHardAndEndsInFault) {
  const During& expected = GetParam();
  TestAxis drive = turning(1500.0);
  set_reaction(drive.axis, 7860, 5);
  drive.send(expected.controlword);
  drive.run(0.1);
  const double before = drive.rpm();

  ASSERT_TRUE(drive.axis.raise(expected.fault));
  drive.run(0.1);
  EXPECT_EQ(drive.state(), expected.state);
  if (pulses_enabled_in(expected.state)) {
    EXPECT_NEAR(before - drive.rpm(), 0.1 * expected.slope_after, 30.0);
  }
  drive.run(3.0);

  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
}

INSTANTIATE_TEST_SUITE_P(
    Brakings, FaultWhileBraking,
    testing::Values(During{"Off1InOff1", 0x0006, 7220, kOff1Slope, State::FaultReactionActive},
                    During{"Off3InOff1", 0x0006, 8702, kOff3Slope, State::FaultReactionActive},
                    During{"Stop2InOff1", 0x0006, 7860, kOff3Slope, State::FaultReactionActive},
                    During{"Off2InOff1", 0x0006, 30001, 0.0, State::Fault},
                    During{"Off1InOff3", 0x000B, 7220, kOff3Slope, State::FaultReactionActive},
                    During{"Off3InOff3", 0x000B, 8702, kOff3Slope, State::FaultReactionActive},
                    During{"Stop2InOff3", 0x000B, 7860, kOff3Slope, State::FaultReactionActive},
                    During{"Off2InOff3", 0x000B, 30001, 0.0, State::Fault}),
    [](const auto& test) { return test.param.name; });

TEST(FaultReactions, ShowWhichOffIsMissingFromWithin) {
  struct Shown {
    std::uint16_t fault;
    unsigned bits;
  };
  for (const Shown& expected : {Shown{7220, 1U << 16}, Shown{30001, 1U << 17}, Shown{8702, 1U << 18}}) {
    TestAxis drive = turning(1000.0);
    ASSERT_TRUE(drive.axis.raise(expected.fault));
    drive.run(0.02);

    const auto missing = static_cast<unsigned>(drive.axis.read(46).value());
    EXPECT_EQ(missing & 0x0007'0000U, expected.bits) << expected.fault;
  }
}

}  // namespace
}  // namespace drive
