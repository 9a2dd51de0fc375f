#include "drive/sequence_control/state_machine.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <gtest/gtest.h>

namespace drive {
namespace {

using enum State;
using enum Event;

/// The sequence control as the manual's state picture shows it, one row a state, one column an event; the state
/// itself where the event has no effect.
struct Row {
  State from;
  std::array<State, kEventCount> to;
};
// clang-format off
constexpr std::array<Row, kStateCount> kPicture{{
  // from                 Shutdown             SwitchOn             EnableOperation      DisableVoltage       QuickStop            Initialised          Standstill           FaultOff1            FaultOff2            FaultOff3            FaultStop2           Acknowledged         MeasurementEnded
  {NotReadyToSwitchOn,  {NotReadyToSwitchOn,  NotReadyToSwitchOn,  NotReadyToSwitchOn,  NotReadyToSwitchOn,  NotReadyToSwitchOn,  SwitchOnDisabled,    NotReadyToSwitchOn,  Fault,               Fault,               Fault,               Fault,               NotReadyToSwitchOn,  NotReadyToSwitchOn}},
  {SwitchOnDisabled,    {ReadyToSwitchOn,     SwitchOnDisabled,    SwitchOnDisabled,    SwitchOnDisabled,    SwitchOnDisabled,    SwitchOnDisabled,    SwitchOnDisabled,    Fault,               Fault,               Fault,               Fault,               SwitchOnDisabled,    SwitchOnDisabled}},
  {ReadyToSwitchOn,     {ReadyToSwitchOn,     SwitchedOn,          SwitchedOn,          SwitchOnDisabled,    SwitchOnDisabled,    ReadyToSwitchOn,     ReadyToSwitchOn,     Fault,               Fault,               Fault,               Fault,               ReadyToSwitchOn,     ReadyToSwitchOn}},
  {SwitchedOn,          {ReadyToSwitchOn,     SwitchedOn,          OperationEnabled,    SwitchOnDisabled,    SwitchOnDisabled,    SwitchedOn,          SwitchedOn,          Fault,               Fault,               Fault,               Fault,               SwitchedOn,          SwitchedOn}},
  {OperationEnabled,    {Off1Braking,         SwitchedOn,          OperationEnabled,    SwitchOnDisabled,    QuickStopActive,     OperationEnabled,    OperationEnabled,    FaultReactionActive, Fault,               FaultReactionActive, Stop2Active,         OperationEnabled,    SwitchOnDisabled}},
  {Off1Braking,         {Off1Braking,         SwitchedOn,          OperationEnabled,    SwitchOnDisabled,    QuickStopActive,     Off1Braking,         ReadyToSwitchOn,     FaultReactionActive, Fault,               FaultReactionActive, FaultReactionActive, Off1Braking,         Off1Braking}},
  {QuickStopActive,     {QuickStopActive,     QuickStopActive,     QuickStopActive,     SwitchOnDisabled,    QuickStopActive,     QuickStopActive,     SwitchOnDisabled,    FaultReactionActive, Fault,               FaultReactionActive, FaultReactionActive, QuickStopActive,     QuickStopActive}},
  {FaultReactionActive, {FaultReactionActive, FaultReactionActive, FaultReactionActive, Fault,               FaultReactionActive, FaultReactionActive, Fault,               FaultReactionActive, Fault,               FaultReactionActive, FaultReactionActive, FaultReactionActive, FaultReactionActive}},
  {Stop2Active,         {FaultReactionActive, Stop2Active,         Stop2Active,         Fault,               FaultReactionActive, Stop2Active,         Stop2Active,         FaultReactionActive, Fault,               FaultReactionActive, Stop2Active,         SwitchOnDisabled,    Stop2Active}},
  {Fault,               {Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               Fault,               SwitchOnDisabled,    Fault}},
}};
// clang-format on

TEST(StateMachine, GoesWhereTheStatePictureSaysForEveryStateAndEvent) {
  for (std::size_t from = 0; from < kStateCount; ++from) {
    ASSERT_EQ(kPicture[from].from, static_cast<State>(from));
    for (std::size_t event = 0; event < kEventCount; ++event) {
      const Transition* row = find_transition(kPicture[from].from, static_cast<Event>(event));
      const State to = row != nullptr ? row->to : kPicture[from].from;
      EXPECT_EQ(to, kPicture[from].to[event]) << "state " << from << ", event " << event;
    }
  }
}

TEST(StateMachine, HasTheMotorOnPowerInFiveStatesOnly) {
  constexpr std::array kPowered{OperationEnabled, Off1Braking, QuickStopActive, FaultReactionActive, Stop2Active};

  for (std::size_t i = 0; i < kStateCount; ++i) {
    const auto state = static_cast<State>(i);
    const bool expected = std::find(kPowered.begin(), kPowered.end(), state) != kPowered.end();
    EXPECT_EQ(pulses_enabled_in(state), expected) << i;
    EXPECT_EQ(is_braking(state), expected && state != OperationEnabled && state != Stop2Active) << i;
  }
}

struct ActionCase {
  State from;
  Event on;
  Action action;
};

TEST(StateMachine, BrakesSwitchesAndResumesWhereTheManualSaysSo) {
  constexpr std::array kCases{
      ActionCase{SwitchedOn, EnableOperation, Action::EnablePulses},
      ActionCase{OperationEnabled, Shutdown, Action::BrakeOnOff1},
      ActionCase{OperationEnabled, QuickStop, Action::BrakeOnOff3},
      ActionCase{OperationEnabled, SwitchOn, Action::InhibitPulses},
      ActionCase{OperationEnabled, FaultOff1, Action::BrakeOnOff1},
      ActionCase{OperationEnabled, FaultOff3, Action::BrakeOnOff3},
      ActionCase{OperationEnabled, FaultStop2, Action::BrakeOnOff3},
      ActionCase{Stop2Active, Shutdown, Action::BrakeOnOff3},
      ActionCase{Stop2Active, Acknowledged, Action::InhibitPulses},
      ActionCase{Off1Braking, EnableOperation, Action::FollowSetpoint},
      ActionCase{Off1Braking, QuickStop, Action::BrakeOnOff3},
      ActionCase{QuickStopActive, FaultOff1, Action::BrakeOnOff3},
      ActionCase{FaultReactionActive, FaultOff3, Action::BrakeOnOff3},
      ActionCase{FaultReactionActive, QuickStop, Action::BrakeOnOff3},
  };

  for (const ActionCase& expected : kCases) {
    const Transition* row = find_transition(expected.from, expected.on);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->action, expected.action);
  }
}

TEST(StateMachine, ReadsTheCommandFromBitsZeroToThreeOnly) {
  for (const unsigned other : {0x0000u, 0xFFF0u, 0x0080u, 0x0100u}) {
    const auto command = [&](unsigned low) { return command_of(static_cast<std::uint16_t>(other | low)); };
    for (const unsigned low : {0x0u, 0x1u, 0x4u, 0x5u, 0x8u, 0x9u, 0xCu, 0xDu})
      EXPECT_EQ(command(low), DisableVoltage);
    for (const unsigned low : {0x2u, 0x3u, 0xAu, 0xBu}) EXPECT_EQ(command(low), QuickStop);
    for (const unsigned low : {0x6u, 0xEu}) EXPECT_EQ(command(low), Shutdown);
    EXPECT_EQ(command(0x7u), SwitchOn);
    EXPECT_EQ(command(0xFu), EnableOperation);
  }
}

}  // namespace
}  // namespace drive
