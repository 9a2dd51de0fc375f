// 605Ah to 605Eh, as CiA 402 and the description of the axis say.
#include "cia402/state/option_codes.hpp"

#include <array>

#include <gtest/gtest.h>

#include "tests/cia402/state/machine_in.hpp"

namespace cia402 {
namespace {

using enum State;

/// What @p braking None does and where it ends at once, what the others do first and where they end.
struct Case {
  std::int16_t code;
  Braking braking;
  State end;
};

constexpr std::array kQuickStop{
    Case{0, Braking::None, SwitchOnDisabled},          Case{1, Braking::SlowDownRamp, SwitchOnDisabled},
    Case{2, Braking::QuickStopRamp, SwitchOnDisabled}, Case{3, Braking::MaxTorque, SwitchOnDisabled},
    Case{4, Braking::MaxTorque, SwitchOnDisabled},     Case{5, Braking::SlowDownRamp, QuickStopActive},
    Case{6, Braking::QuickStopRamp, QuickStopActive},  Case{7, Braking::MaxTorque, QuickStopActive},
    Case{8, Braking::MaxTorque, QuickStopActive},
};

TEST(QuickStopOptionCode, SaysHowToBrakeAndWhereThatEnds) {
  for (const Case& row : kQuickStop) {
    SCOPED_TRACE(row.code);
    const OptionCodes codes{.quick_stop = row.code};
    StateMachine machine = machine_in(OperationEnabled, codes);
    const Outcome outcome = machine.controlword(0x02, codes);
    EXPECT_EQ(outcome.braking, row.braking);
    if (row.braking == Braking::None) {
      EXPECT_EQ(outcome.action, Action::PulsesOff);
      EXPECT_EQ(outcome.transitions, (TransitionNumbers{11, 12}));
      EXPECT_EQ(machine.state(), SwitchOnDisabled);
      continue;
    }
    EXPECT_EQ(outcome.action, Action::Brake);
    EXPECT_EQ(outcome.transitions, (TransitionNumbers{11}));
    EXPECT_EQ(machine.state(), QuickStopActive);
    EXPECT_EQ(machine.braking(), row.braking);

    const Outcome end = machine.standstill_reached();
    const bool stays = row.end == QuickStopActive;
    EXPECT_EQ(machine.state(), row.end);
    EXPECT_EQ(end.action, stays ? Action::None : Action::PulsesOff);
    EXPECT_EQ(end.transitions, stays ? TransitionNumbers{} : TransitionNumbers{12});
    EXPECT_EQ(machine.is_powered(), stays);
    EXPECT_FALSE(machine.is_braking());
  }
}

TEST(QuickStopOptionCode, AllowsToEnableAgainOnlyIfItStays) {
  for (const Case& row : kQuickStop)
    for (const bool stands : {false, true}) {
      SCOPED_TRACE(row.code);
      const OptionCodes codes{.quick_stop = row.code};
      StateMachine machine = machine_in(OperationEnabled, codes);
      machine.controlword(0x02, codes);
      if (stands) machine.standstill_reached();
      const State before = machine.state();
      const Outcome outcome = machine.controlword(0x0F, codes);

      const bool stays = row.end == QuickStopActive;
      EXPECT_EQ(machine.state(), stays ? OperationEnabled : before);
      EXPECT_EQ(outcome.action, stays ? Action::Enable : Action::None);
      EXPECT_EQ(machine.is_braking(), !stays && before == QuickStopActive);
    }
}

TEST(QuickStopOptionCode, CountsAsItWasWhenTheQuickStopBegan) {
  StateMachine machine = machine_in(QuickStopActive, {.quick_stop = 2});

  EXPECT_EQ(machine.controlword(0x0F, {.quick_stop = 6}), Outcome{});
  machine.standstill_reached();
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
}

struct LeavingCase {
  std::int16_t code;
  std::uint16_t word;
  Braking braking;
  State end;
  std::uint8_t number;
};

TEST(ShutdownAndDisableOperationOptionCode, ShowTheStateAtOnceAndTakePowerAwayAtRest) {
  constexpr std::array kCases{
      LeavingCase{0, 0x06, Braking::None, ReadyToSwitchOn, 8},
      LeavingCase{1, 0x06, Braking::SlowDownRamp, ReadyToSwitchOn, 8},
      LeavingCase{0, 0x07, Braking::None, SwitchedOn, 5},
      LeavingCase{1, 0x07, Braking::SlowDownRamp, SwitchedOn, 5},
  };
  for (const LeavingCase& row : kCases) {
    SCOPED_TRACE(::testing::Message() << row.word << ' ' << row.code);
    const OptionCodes codes{.shutdown = row.code, .disable_operation = row.code};
    StateMachine machine = machine_in(OperationEnabled, codes);
    const Outcome outcome = machine.controlword(row.word, codes);
    EXPECT_EQ(machine.state(), row.end);
    EXPECT_EQ(outcome.transitions, (TransitionNumbers{row.number}));
    EXPECT_EQ(outcome.braking, row.braking);
    const bool brakes = row.braking != Braking::None;
    EXPECT_EQ(outcome.action, brakes ? Action::Brake : Action::PulsesOff);
    EXPECT_EQ(machine.is_powered(), brakes);
    EXPECT_EQ(machine.standstill_reached(), (Outcome{.action = brakes ? Action::PulsesOff : Action::None}));
    EXPECT_EQ(machine.state(), row.end);
    EXPECT_FALSE(machine.is_powered());
  }
}

TEST(HaltOptionCode, StaysInOperationEnabled) {
  constexpr std::array kBraking{Braking::SlowDownRamp, Braking::QuickStopRamp, Braking::MaxTorque,
                                Braking::MaxTorque};
  for (std::int16_t code = 1; code <= 4; ++code) {
    const StopRow& row = stop_of(StopCause::Halt, {.halt = code});
    EXPECT_EQ(row.braking, kBraking[static_cast<std::size_t>(code - 1)]) << code;
    EXPECT_EQ(row.end, OperationEnabled);
  }
}

TEST(FaultReactionOptionCode, EndsInFault) {
  constexpr std::array kCases{Case{0, Braking::None, Fault}, Case{1, Braking::SlowDownRamp, Fault},
                              Case{2, Braking::QuickStopRamp, Fault}, Case{3, Braking::MaxTorque, Fault},
                              Case{4, Braking::MaxTorque, Fault}};
  for (const Case& row : kCases) {
    SCOPED_TRACE(row.code);
    const OptionCodes codes{.fault_reaction = row.code};
    StateMachine machine = machine_in(OperationEnabled, codes);
    const Outcome outcome = machine.fault(codes, true);
    EXPECT_EQ(outcome.braking, row.braking);
    if (row.braking == Braking::None) {
      EXPECT_EQ(outcome, (Outcome{.action = Action::PulsesOff, .transitions = {13, 14}}));
    } else {
      EXPECT_EQ(outcome, (Outcome{.action = Action::Brake, .braking = row.braking, .transitions = {13}}));
      EXPECT_EQ(machine.state(), FaultReactionActive);
      EXPECT_EQ(machine.standstill_reached(), (Outcome{.action = Action::PulsesOff, .transitions = {14}}));
    }
    EXPECT_EQ(machine.state(), Fault);
    EXPECT_FALSE(machine.is_powered());
  }
}

TEST(OptionCodes, ThatDoNotExistActLikeTheFactoryValues) {
  const OptionCodes wrong{.quick_stop = 9, .shutdown = -1, .disable_operation = 2, .halt = 0, .fault_reaction = 5};
  for (const StopCause cause : {StopCause::QuickStop, StopCause::Shutdown, StopCause::DisableOperation,
                                StopCause::Halt, StopCause::FaultReaction})
    EXPECT_EQ(&stop_of(cause, wrong), &stop_of(cause, OptionCodes{}));
  EXPECT_EQ(stop_rows().size(), 9U + 2U + 2U + 4U + 5U);
}

}  // namespace
}  // namespace cia402
