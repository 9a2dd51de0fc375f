// Faults, a lost DC link, and what comes while the axis still brakes.
#include <array>

#include <gtest/gtest.h>

#include "tests/cia402/state/machine_in.hpp"

namespace cia402 {
namespace {

using enum State;

constexpr OptionCodes kCodes{.quick_stop = 6, .shutdown = 1};
constexpr Outcome kNothing{};

/// What a fault that can be braked for, one that cannot, and a lost DC link do in a state.
struct Row {
  State from;
  State braked;
  State unbraked;
  State without_voltage;
};
constexpr std::array<Row, kStateCount> kRows{{
    {NotReadyToSwitchOn, Fault, Fault, NotReadyToSwitchOn},
    {SwitchOnDisabled, Fault, Fault, SwitchOnDisabled},
    {ReadyToSwitchOn, Fault, Fault, ReadyToSwitchOn},
    {SwitchedOn, Fault, Fault, SwitchOnDisabled},
    {OperationEnabled, FaultReactionActive, Fault, SwitchOnDisabled},
    {QuickStopActive, FaultReactionActive, Fault, SwitchOnDisabled},
    {FaultReactionActive, FaultReactionActive, Fault, Fault},
    {Fault, Fault, Fault, Fault},
}};

TEST(Events, LeadFromEveryStateWhereTheyShould) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(name_of(row.from));
    const bool was_powered = machine_in(row.from, kCodes).is_powered();
    StateMachine braked = machine_in(row.from, kCodes);
    braked.fault(kCodes, true);
    EXPECT_EQ(braked.state(), row.braked);
    StateMachine unbraked = machine_in(row.from, kCodes);
    const Outcome fault = unbraked.fault(kCodes, false);
    EXPECT_EQ(unbraked.state(), row.unbraked);
    EXPECT_EQ(fault.action, was_powered ? Action::PulsesOff : Action::None);
    StateMachine dark = machine_in(row.from, kCodes);
    const Outcome loss = dark.voltage_lost();
    EXPECT_EQ(dark.state(), row.without_voltage);
    EXPECT_EQ(loss.action, was_powered ? Action::PulsesOff : Action::None);
    EXPECT_FALSE(dark.is_powered());
  }
}

TEST(Events, ThatMeanNothingInAStateChangeNothing) {
  for (const StateRow& row : kStates) {
    SCOPED_TRACE(row.name);
    StateMachine machine = machine_in(row.state, kCodes);
    const bool brakes = machine.is_braking();
    EXPECT_EQ(brakes, row.state == QuickStopActive || row.state == FaultReactionActive);
    if (!brakes) {
      EXPECT_EQ(machine.standstill_reached(), kNothing);
    }
    if (row.state != FaultReactionActive) {
      EXPECT_EQ(machine.fault_reaction_over(), kNothing);
    }
    if (row.state != NotReadyToSwitchOn) {
      EXPECT_EQ(machine.initialised(), kNothing);
    }
  }
}

TEST(StateMachine, StartsNotReadyAndHearsNoCommandBeforeItIsInitialised) {
  StateMachine machine;
  EXPECT_EQ(machine.state(), NotReadyToSwitchOn);
  EXPECT_EQ(machine.controlword(0x06, kCodes), kNothing);
  EXPECT_EQ(machine.initialised().transitions, (TransitionNumbers{1}));
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
}

TEST(StateMachine, HasPowerInThreeStatesAndWhereItBrakes) {
  for (const StateRow& row : kStates) {
    const bool expected =
        row.state == OperationEnabled || row.state == QuickStopActive || row.state == FaultReactionActive;
    EXPECT_EQ(machine_in(row.state, kCodes).is_powered(), expected) << row.name;
  }
}

/// An axis that brakes after a shutdown: Ready to switch on is shown already.
StateMachine braking_machine() {
  StateMachine machine = machine_in(OperationEnabled, kCodes);
  machine.controlword(0x06, kCodes);
  EXPECT_EQ(machine.state(), ReadyToSwitchOn);
  EXPECT_TRUE(machine.is_powered());
  return machine;
}

TEST(BrakingAfterShutdown, GoesOnThroughTheStatesBelow) {
  StateMachine machine = braking_machine();
  EXPECT_EQ(machine.controlword(0x07, kCodes).action, Action::None);
  EXPECT_EQ(machine.state(), SwitchedOn);
  EXPECT_EQ(machine.controlword(0x06, kCodes).action, Action::None);
  EXPECT_TRUE(machine.is_braking());
  EXPECT_EQ(machine.standstill_reached(), Outcome{.action = Action::PulsesOff});
  EXPECT_EQ(machine.state(), ReadyToSwitchOn);
}

TEST(BrakingAfterShutdown, EndsWhereOperationIsEnabledAgain) {
  StateMachine machine = braking_machine();
  EXPECT_EQ(machine.controlword(0x0F, kCodes), (Outcome{.action = Action::Enable, .transitions = {3, 4}}));
  EXPECT_FALSE(machine.is_braking());
  EXPECT_EQ(machine.standstill_reached(), kNothing);
  EXPECT_EQ(machine.state(), OperationEnabled);
}

TEST(BrakingAfterShutdown, BecomesAQuickStop) {
  StateMachine machine = braking_machine();
  EXPECT_EQ(machine.controlword(0x02, kCodes),
            (Outcome{.action = Action::Brake, .braking = Braking::QuickStopRamp, .transitions = {7}}));
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
  EXPECT_EQ(machine.controlword(0x0F, kCodes), kNothing);
  EXPECT_EQ(machine.standstill_reached(), Outcome{.action = Action::PulsesOff});
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
  EXPECT_FALSE(machine.is_powered());
}

TEST(BrakingAfterShutdown, BecomesAQuickStopWithoutBraking) {
  StateMachine machine = braking_machine();
  EXPECT_EQ(machine.controlword(0x02, {.quick_stop = 0}),
            (Outcome{.action = Action::PulsesOff, .transitions = {7}}));
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
}

TEST(BrakingAfterShutdown, IsGivenUpWithTheVoltage) {
  StateMachine disabled = braking_machine();
  EXPECT_EQ(disabled.controlword(0x00, kCodes), (Outcome{.action = Action::PulsesOff, .transitions = {7}}));
  EXPECT_FALSE(disabled.is_powered());

  StateMachine dark = braking_machine();
  EXPECT_EQ(dark.voltage_lost(), Outcome{.action = Action::PulsesOff});
  EXPECT_EQ(dark.state(), ReadyToSwitchOn);

  StateMachine stopping = braking_machine();
  stopping.controlword(0x02, kCodes);
  EXPECT_EQ(stopping.controlword(0x00, kCodes), Outcome{.action = Action::PulsesOff});
  EXPECT_EQ(stopping.state(), SwitchOnDisabled);
}

TEST(BrakingAfterShutdown, BecomesAFaultReaction) {
  for (const bool can_brake : {true, false}) {
    StateMachine machine = braking_machine();
    const Outcome outcome = machine.fault({.fault_reaction = 3}, can_brake);
    EXPECT_EQ(outcome.action, can_brake ? Action::Brake : Action::PulsesOff);
    EXPECT_EQ(outcome.braking, can_brake ? Braking::MaxTorque : Braking::None);
    EXPECT_EQ(machine.state(), can_brake ? FaultReactionActive : Fault);
    EXPECT_EQ(machine.is_powered(), can_brake);
  }
}

TEST(FaultReaction, IsNotSoftenedByAnotherFaultNorByACommand) {
  StateMachine machine = machine_in(OperationEnabled, kCodes);
  machine.fault({.fault_reaction = 3}, true);

  EXPECT_EQ(machine.fault({.fault_reaction = 1}, true), kNothing);
  EXPECT_EQ(machine.controlword(0x00, kCodes), kNothing);
  EXPECT_EQ(machine.braking(), Braking::MaxTorque);
  EXPECT_EQ(machine.fault_reaction_over(), (Outcome{.action = Action::PulsesOff, .transitions = {14}}));
  EXPECT_EQ(machine.state(), Fault);
}

TEST(QuickStop, EndsWithAFaultReaction) {
  StateMachine machine = machine_in(QuickStopActive, kCodes);
  EXPECT_EQ(machine.fault({.fault_reaction = 1}, true),
            (Outcome{.action = Action::Brake, .braking = Braking::SlowDownRamp, .transitions = {13}}));
  machine.standstill_reached();
  EXPECT_EQ(machine.state(), Fault);
}

TEST(QuickStop, HoldsWithPowerAndCanBeLeft) {
  StateMachine machine = machine_in(QuickStopActive, kCodes);
  machine.standstill_reached();
  EXPECT_TRUE(machine.is_powered());
  EXPECT_EQ(machine.controlword(0x06, kCodes), kNothing);
  EXPECT_EQ(machine.controlword(0x0F, kCodes), (Outcome{.action = Action::Enable, .transitions = {16}}));
  EXPECT_EQ(machine.state(), OperationEnabled);
}

}  // namespace
}  // namespace cia402
