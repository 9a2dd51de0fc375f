// Every controlword in every state, against the table of the commands of CiA 402.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cia402/state/machine_in.hpp"

namespace cia402 {
namespace {

using enum State;

/// A command: bits 7, 3, 2, 1, 0 of 6040h, x any; and its transitions.
struct Command {
  std::string_view bits;
  std::vector<int> transitions;
};
const std::array kCommands{
    Command{"0x110", {2, 6, 8}},       // shutdown
    Command{"00111", {3, 5}},          // switch on, disable operation
    Command{"01111", {4, 16}},         // enable operation
    Command{"0xx0x", {7, 9, 10, 12}},  // disable voltage
    Command{"0x01x", {7, 10, 11}},     // quick stop
};

struct Numbered {
  int number;
  State from;
  State to;
};
constexpr std::array kNumbered{
    Numbered{2, SwitchOnDisabled, ReadyToSwitchOn},  Numbered{3, ReadyToSwitchOn, SwitchedOn},
    Numbered{4, SwitchedOn, OperationEnabled},       Numbered{5, OperationEnabled, SwitchedOn},
    Numbered{6, SwitchedOn, ReadyToSwitchOn},        Numbered{7, ReadyToSwitchOn, SwitchOnDisabled},
    Numbered{8, OperationEnabled, ReadyToSwitchOn},  Numbered{9, OperationEnabled, SwitchOnDisabled},
    Numbered{10, SwitchedOn, SwitchOnDisabled},      Numbered{11, OperationEnabled, QuickStopActive},
    Numbered{12, QuickStopActive, SwitchOnDisabled}, Numbered{15, Fault, SwitchOnDisabled},
    Numbered{16, QuickStopActive, OperationEnabled},
};

bool matches(std::string_view pattern, unsigned word) {
  constexpr std::array kBits{7U, 3U, 2U, 1U, 0U};
  for (std::size_t i = 0; i < kBits.size(); ++i)
    if (pattern[i] != 'x' && (pattern[i] == '1') != ((word >> kBits[i] & 1U) != 0)) return false;
  return true;
}

/// The row of @p number if it leaves @p state.
std::optional<Numbered> leaving(State state, int number) {
  for (const Numbered& row : kNumbered)
    if (row.number == number && row.from == state) return row;
  return std::nullopt;
}

struct Expected {
  State to;
  TransitionNumbers numbers{};
};

Expected expected(State state, bool former_bit_7, unsigned word) {
  if ((word & 0x80U) != 0) {
    const bool resets = state == Fault && !former_bit_7;
    return resets ? Expected{SwitchOnDisabled, {15}} : Expected{state};
  }
  if (state == ReadyToSwitchOn && matches("01111", word)) return {OperationEnabled, {3, 4}};
  for (const Command& command : kCommands) {
    if (!matches(command.bits, word)) continue;
    for (const int number : command.transitions)
      if (const auto row = leaving(state, number)) return {row->to, {static_cast<std::uint8_t>(number)}};
  }
  return {state};
}

/// Option codes that let no state be passed at once, and allow 16.
constexpr OptionCodes kCodes{.quick_stop = 6, .shutdown = 1, .disable_operation = 1};

Action action_of(const Expected& row) {
  switch (row.numbers[1] != 0 ? row.numbers[1] : row.numbers[0]) {
    case 4:
    case 16:
      return Action::Enable;
    case 5:
    case 8:
    case 11:
      return Action::Brake;
    case 9:
    case 12:
      return Action::PulsesOff;
    default:
      return Action::None;
  }
}

TEST(Controlword, LeadsFromEveryStateWhereItsCommandSays) {
  for (const StateRow& row : kStates)
    for (const bool former_bit_7 : {false, true})
      for (unsigned word = 0; word <= 0x1FF; ++word) {
        StateMachine machine = machine_in(row.state, kCodes, former_bit_7);
        const Outcome outcome = machine.controlword(static_cast<std::uint16_t>(word), kCodes);

        const Expected right = expected(row.state, former_bit_7, word);
        SCOPED_TRACE(::testing::Message()
                     << row.name << ", bit 7 " << former_bit_7 << ", word " << std::hex << word);
        ASSERT_EQ(machine.state(), right.to);
        ASSERT_EQ(outcome.transitions, right.numbers);
        ASSERT_EQ(outcome.action, action_of(right));
        ASSERT_EQ(machine.wants_halt(), (word & 0x100U) != 0);
        ASSERT_EQ(machine.controlword(), word);
      }
}

TEST(Controlword, IsNotReadInItsOtherBits) {
  for (const StateRow& row : kStates)
    for (const unsigned other : {0x10U, 0x20U, 0x40U, 0x200U, 0x400U, 0x800U, 0xF000U, 0xFE70U})
      for (unsigned word = 0; word <= 0xFF; ++word) {
        StateMachine machine = machine_in(row.state, kCodes);
        machine.controlword(static_cast<std::uint16_t>(word | other), kCodes);
        ASSERT_EQ(machine.state(), expected(row.state, false, word).to) << row.name << ' ' << word << ' ' << other;
      }
}

TEST(Controlword, ResetsAFaultWithTheEdgeOfBit7Only) {
  StateMachine machine = machine_in(Fault, kCodes);

  EXPECT_EQ(machine.controlword(0x008F, kCodes).transitions, (TransitionNumbers{15}));
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
  EXPECT_EQ(machine.controlword(0x0086, kCodes), Outcome{});  // bits 0 to 3 count without bit 7 only
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
  machine.controlword(0x0006, kCodes);
  EXPECT_EQ(machine.state(), ReadyToSwitchOn);
}

TEST(Controlword, NeedsANewEdgeWhenTheFaultIsLater) {
  StateMachine machine = machine_in(OperationEnabled, kCodes);
  machine.controlword(0x0080, kCodes);
  EXPECT_EQ(machine.state(), OperationEnabled);
  machine.fault(kCodes, false);

  EXPECT_EQ(machine.controlword(0x0080, kCodes), Outcome{});
  EXPECT_EQ(machine.state(), Fault);
  machine.controlword(0x0000, kCodes);
  machine.controlword(0x0080, kCodes);
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
}

TEST(Controlword, DoesNotResetWhatIsStillThere) {
  StateMachine machine = machine_in(Fault, kCodes);

  EXPECT_EQ(machine.controlword(0x0080, kCodes, false), Outcome{});
  EXPECT_EQ(machine.state(), Fault);
  EXPECT_EQ(machine.controlword(0x0080, kCodes, true), Outcome{});  // the edge is gone
  machine.controlword(0x0000, kCodes);
  machine.controlword(0x0080, kCodes, true);
  EXPECT_EQ(machine.state(), SwitchOnDisabled);
}

TEST(Commands, ComeFromALostConnectionToo) {
  EXPECT_EQ(abort_reaction(0), AbortReaction::None);
  EXPECT_EQ(abort_reaction(1), AbortReaction::Fault);
  EXPECT_EQ(abort_reaction(2), AbortReaction::DisableVoltage);
  EXPECT_EQ(abort_reaction(3), AbortReaction::QuickStop);
  EXPECT_EQ(abort_reaction(4), AbortReaction::None);
  EXPECT_EQ(abort_reaction(-1), AbortReaction::None);

  StateMachine machine = machine_in(OperationEnabled, kCodes);
  EXPECT_EQ(machine.command(Event::QuickStop, kCodes).action, Action::Brake);
  EXPECT_EQ(machine.state(), QuickStopActive);
  EXPECT_EQ(machine.command(Event::DisableVoltage, kCodes).action, Action::PulsesOff);
  EXPECT_EQ(machine.controlword(), 0x0F);
}

}  // namespace
}  // namespace cia402
