// The inputs of the sequence control beyond the controlword: jog, control by PLC, infeed, external messages.
#include "tests/drive/axis_inputs.hpp"

#include <gtest/gtest.h>

#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

TEST(Jog, SwitchesOnWithItsRisingEdgeAndOffLikeOff1) {
  WiredAxis drive;

  drive.inputs.jog_1 = true;
  drive.cycles(1);
  EXPECT_EQ(drive.state(), State::SwitchedOn);
  drive.cycles(1);
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_TRUE(drive.axis.jogs());
  EXPECT_EQ(drive.word(899) & 0x0008U, 0x0008U);
  EXPECT_EQ(drive.word(898) & 0x0301U, 0x0100U);
  EXPECT_EQ(drive.word(46), 0x80000000U);

  drive.inputs.jog_1 = false;
  drive.cycles(1);
  EXPECT_EQ(drive.state(), State::Off1Braking);
  EXPECT_FALSE(drive.axis.jogs());
  ASSERT_TRUE(drive.axis.write(1121, 0.0));
  drive.run(0.5);
  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn);
}

TEST(Jog, GoesOnWhenOneBitFollowsTheOther) {
  WiredAxis drive;
  drive.inputs.jog_1 = true;
  drive.cycles(3);

  drive.inputs.jog_2 = true;
  drive.cycles(1);
  EXPECT_EQ(drive.word(898) & 0x0300U, 0x0300U);
  EXPECT_TRUE(drive.axis.jogs());
  drive.inputs.jog_1 = false;
  drive.cycles(1);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_TRUE(drive.axis.jogs());
}

TEST(Jog, WaitsForTheOperationEnableLikeOn) {
  WiredAxis drive;
  drive.inputs.enable_operation = false;

  drive.inputs.jog_2 = true;
  drive.cycles(3);
  EXPECT_EQ(drive.state(), State::SwitchedOn);
  drive.inputs.enable_operation = true;
  drive.cycles(1);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
}

TEST(Jog, IsIgnoredWhileOnIsSetAndNeedsAnEdgeAfterwards) {
  WiredAxis drive;
  drive.turn_at(500.0);

  drive.inputs.jog_1 = true;
  drive.cycles(2);
  EXPECT_FALSE(drive.axis.jogs());
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  drive.inputs.on = false;
  drive.cycles(1);
  EXPECT_EQ(drive.state(), State::Off1Braking);
  EXPECT_TRUE(drive.axis.write(1121, 0.0));
  drive.run(0.5);

  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn);
}

TEST(Jog, NeedsAnEdgeAfterOff2AndAfterAFault) {
  WiredAxis drive;
  drive.inputs.jog_1 = true;
  drive.cycles(3);

  drive.inputs.no_off2 = false;
  drive.cycles(1);
  drive.inputs.no_off2 = true;
  drive.cycles(5);
  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn) << "ON = 0 lifts the inhibit, the jog bit stays without effect";
  drive.inputs.jog_1 = false;
  drive.cycles(1);
  drive.inputs.jog_1 = true;
  drive.cycles(2);
  ASSERT_EQ(drive.state(), State::OperationEnabled);

  ASSERT_TRUE(drive.axis.raise(30001));
  EXPECT_TRUE(drive.acknowledge());
  drive.cycles(5);
  EXPECT_EQ(drive.state(), State::ReadyToSwitchOn);
}

TEST(Jog, HandsOverToOn) {
  WiredAxis drive;
  drive.inputs.jog_1 = true;
  drive.cycles(3);

  drive.inputs.on = true;
  drive.cycles(1);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_FALSE(drive.axis.jogs());
}

TEST(Jog, TakesOverAnAxisThatBrakesOnOff1) {
  WiredAxis drive;
  ASSERT_TRUE(drive.axis.write(1121, 7.2));  // 1000 rpm a second
  ASSERT_TRUE(drive.axis.write(1058, 100.0));
  drive.turn_at(1000.0);
  drive.inputs.on = false;
  drive.run(0.1);
  ASSERT_EQ(drive.state(), State::Off1Braking);

  drive.inputs.jog_1 = true;
  drive.cycles(1);
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_TRUE(drive.axis.jogs());
  drive.run(2.0);
  EXPECT_NEAR(drive.rpm(), 100.0, 2.0);
}

TEST(ControlByPlc, BrakesOnOff1WhenItIsWithdrawnInOperation) {
  WiredAxis drive;
  ASSERT_TRUE(drive.axis.write(1121, 7.2));  // 1000 rpm a second
  drive.turn_at(1000.0);

  drive.inputs.control_by_plc = false;
  drive.cycles(1);
  EXPECT_TRUE(drive.has(7220));
  EXPECT_EQ(drive.state(), State::FaultReactionActive);
  EXPECT_FALSE(drive.acknowledge());
  drive.run(0.5);
  EXPECT_NEAR(drive.rpm(), 500.0, 20.0);
  drive.run(0.7);

  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_EQ(drive.word(46) & 0x00070000U, 0x00010000U);
  EXPECT_TRUE(drive.acknowledge());
}

TEST(Infeed, KeepsThePulsesOffAndAfterP0857IsMissed) {
  WiredAxis drive;
  ASSERT_TRUE(drive.axis.write(857, 1000.0));
  drive.inputs.infeed_operates = false;

  drive.inputs.on = true;
  drive.run(0.996);
  EXPECT_EQ(drive.state(), State::SwitchedOn);
  EXPECT_EQ(drive.word(2), 23U);
  EXPECT_FALSE(drive.axis.is_quiescent()) << "p0857 runs";
  drive.cycles(2);

  EXPECT_TRUE(drive.has(7840));
  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_TRUE(drive.acknowledge());
}

TEST(Infeed, LetsTheAxisGoWhenItComes) {
  WiredAxis drive;
  drive.inputs.infeed_operates = false;
  drive.inputs.on = true;
  drive.run(0.5);

  drive.inputs.infeed_operates = true;
  drive.cycles(1);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
  drive.run(10.0);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

TEST(Infeed, CoastsWhenItDropsInOperation) {
  WiredAxis drive;
  drive.turn_at(1000.0);

  drive.inputs.infeed_operates = false;
  drive.cycles(1);

  EXPECT_TRUE(drive.has(7841));
  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_NEAR(drive.rpm(), 1000.0, 10.0);
}

TEST(Infeed, WithoutADcLinkThePowerUnitIsNotReady) {
  const motor::SupplyData dead{.line_voltage = 0.0};
  Axis axis{AxisConfiguration{}, 0, 0, dead};
  AxisInputs inputs{};
  cycle(axis, inputs, 0.004);
  cycle(axis, inputs, 0.004);
  inputs.on = true;

  for (int i = 0; i < 1499; ++i) cycle(axis, inputs, 0.004);
  EXPECT_EQ(axis.actual().state, State::SwitchedOn);
  EXPECT_EQ(axis.read(2).value(), 23.0);
  EXPECT_NE(static_cast<unsigned>(axis.read(46).value()) & 1U << 21, 0U);
  for (int i = 0; i < 3; ++i) cycle(axis, inputs, 0.004);

  ASSERT_FALSE(axis.messages().faults().empty());
  EXPECT_EQ(axis.messages().faults().back().row->number, 7802);
  EXPECT_EQ(axis.actual().state, State::Fault);
}

struct External {
  bool AxisInputs::*signal;
  std::uint16_t number;
};

TEST(ExternalMessages, LastAsLongAsTheirSignalIs0) {
  for (const External& external :
       {External{&AxisInputs::no_external_fault_1, 7860}, External{&AxisInputs::no_external_fault_2, 7861},
        External{&AxisInputs::no_external_fault_3, 7862}}) {
    WiredAxis drive;
    drive.turn_at(1000.0);

    drive.inputs.*external.signal = false;
    drive.cycles(1);
    EXPECT_TRUE(drive.has(external.number));
    EXPECT_EQ(drive.state(), State::Fault);
    EXPECT_NEAR(drive.rpm(), 1000.0, 10.0);
    EXPECT_FALSE(drive.acknowledge());
    drive.inputs.*external.signal = true;
    drive.cycles(1);
    EXPECT_TRUE(drive.has(external.number));
    EXPECT_TRUE(drive.acknowledge());
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled) << "ON is still set";
  }
}

TEST(ExternalMessages, TheAlarmComesAndGoesWithItsSignal) {
  WiredAxis drive;
  drive.turn_at(1000.0);

  drive.inputs.no_external_alarm_1 = false;
  drive.cycles(1);
  EXPECT_TRUE(drive.has(7850));
  EXPECT_EQ(drive.axis.actual().statusword, 0x06B7);
  drive.inputs.no_external_alarm_1 = true;
  drive.cycles(1);

  EXPECT_FALSE(drive.has(7850));
  EXPECT_EQ(drive.state(), State::OperationEnabled);
}

TEST(ExternalMessages, AnInjectedAlarmStaysAlthoughTheSignalIs1) {
  WiredAxis drive;
  ASSERT_TRUE(drive.axis.raise(7850, 0, Cause::Latched));

  drive.cycles(3);

  EXPECT_TRUE(drive.has(7850));
}

}  // namespace
}  // namespace drive
