// Every state, with the shaft still and turning, and every controlword: the axis does what the text table says.
#include "tests/drive/sequence_table.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

using enum State;

/// What a fault leaves to be acknowledged.
enum class Condition { Free, CausePresent, BitHeld };

struct Case {
  std::string state;
  bool still;
  Condition condition = Condition::Free;
};

std::string name_of(const Case& prepared) {
  constexpr std::array kConditions{"", "_cause_present", "_bit_held"};
  return prepared.state + (prepared.still ? "_still" : "_turning") +
         kConditions[static_cast<std::size_t>(prepared.condition)];
}
void PrintTo(const Case& prepared, std::ostream* out) {
  *out << name_of(prepared);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [name, state] : states_by_name())
    for (const bool still : {true, false}) {
      // An axis whose shaft turns has seen its first cycle.
      if (state == NotReadyToSwitchOn && !still) continue;
      all.push_back({name, still});
      if (state != Fault && state != Stop2Active) continue;
      all.push_back({name, still, Condition::CausePresent});
      all.push_back({name, still, Condition::BitHeld});
    }
  return all;
}

/// The last controlword before the one that is tried.
std::uint16_t held(const Case& prepared, std::uint16_t word) {
  return static_cast<std::uint16_t>(word | (prepared.condition == Condition::BitHeld ? 0x0080 : 0));
}

void raise(TestAxis& drive, const Case& prepared, std::uint16_t number) {
  const Cause cause = prepared.condition == Condition::CausePresent ? Cause::Present : Cause::Gone;
  EXPECT_TRUE(drive.axis.raise(number, 0, cause));
}

/// Brings an axis in Operation enabled to the state of @p prepared.
void leave_operation(TestAxis& drive, const Case& prepared) {
  constexpr std::uint16_t kStop2Fault = 7860;  // by p2100 and p2101
  constexpr std::uint16_t kOff2Fault = 30001;
  constexpr std::uint16_t kOff1Fault = 7220;
  drive.send(held(prepared, 0x000F));
  switch (states_by_name().at(prepared.state)) {
    case SwitchOnDisabled:
      drive.send(0x0000);
      break;
    case ReadyToSwitchOn:
      drive.send(0x0000), drive.send(0x0006);
      break;
    case SwitchedOn:
      drive.send(0x0007);
      break;
    case Off1Braking:
      drive.send(0x0006);
      break;
    case QuickStopActive:
      drive.send(0x000B);
      break;
    case FaultReactionActive:
      raise(drive, prepared, kOff1Fault), drive.send(0x000F);
      break;
    case Stop2Active:
      raise(drive, prepared, kStop2Fault), drive.send(held(prepared, 0x000F));
      break;
    case Fault:
      raise(drive, prepared, kOff2Fault), drive.send(held(prepared, 0x000F));
      break;
    case NotReadyToSwitchOn:
    case OperationEnabled:
      break;
  }
}

/// An axis that is in the state of @p prepared; what brakes at standstill is about to switch the pulses off.
TestAxis prepare(const Case& prepared, double halt_option = -1.0) {
  TestAxis drive;
  EXPECT_TRUE(drive.axis.write(8791, halt_option));
  EXPECT_TRUE(drive.axis.write(2100, 7860));
  EXPECT_TRUE(drive.axis.write(2101, 5));
  EXPECT_TRUE(drive.axis.write(1121, 10.0));
  EXPECT_TRUE(drive.axis.write(1135, 10.0));
  const State wanted = states_by_name().at(prepared.state);
  if (wanted == NotReadyToSwitchOn) return drive;
  drive.turn_at(prepared.still ? 0.0 : 1000.0);
  leave_operation(drive, prepared);
  if (is_braking(wanted)) {
    drive.run(TestAxis::kCycle);
    for (int i = 0; i < 15; ++i) drive.axis.cycle(drive.setpoints, motor::kControlPeriod);
  }
  return drive;
}

/// Tries every controlword with a copy of one prepared axis.
struct Sweep {
  const SequenceTable& table;
  const SequenceTable::Commands& commands;
  const TestAxis& before;
  Case prepared;
  std::vector<bool> used = std::vector<bool>(table.rows.size());

  bool fits(const SequenceTable::Row& row, std::uint16_t word) const {
    if (row.state != before.state() || !(prepared.still ? row.still : row.turning)) return false;
    if (row.only_free && prepared.condition != Condition::Free) return false;
    const auto [first, last] = commands.equal_range(row.command);
    return std::any_of(first, last, [=](const auto& command) { return command.second.matches(word); });
  }
  State expected(std::uint16_t word) {
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      if (fits(table.rows[i], word)) {
        used[i] = true;
        return table.rows[i].next;
      }
    return before.state();
  }
  /// The first deviation with the controlwords up to @p highest, or nothing.
  std::string run(unsigned highest = 0xFFFF) {
    TestAxis trial = before;
    for (unsigned i = 0; i <= highest; ++i) {
      const auto word = static_cast<std::uint16_t>(i);
      trial.axis = before.axis;
      trial.setpoints.controlword = word;
      trial.axis.cycle(trial.setpoints, motor::kControlPeriod);
      const State next = expected(word);
      const auto status = table.statusword(next, prepared.still, word);
      if (trial.state() == next && status.matches(trial.status())) continue;
      return fmt::format("controlword {:04X}h: state {}, 6041h = {:04X}h; expected state {}, {:04X}h in {:04X}h",
                         word, static_cast<int>(trial.state()), trial.status(), static_cast<int>(next),
                         status.value, status.mask);
    }
    return {};
  }
};

/// Bit 8 and all below it.
constexpr unsigned kAroundTheHalt = 0x01FF;

class SequenceControl : public testing::TestWithParam<Case> {};

TEST_P(SequenceControl, DoesWhatTheTableSaysWithEveryControlword) {
  const SequenceTable table = read_sequence_table();
  const TestAxis before = prepare(GetParam());
  ASSERT_EQ(before.state(), states_by_name().at(GetParam().state));
  ASSERT_EQ(std::abs(before.axis.drive_train().signals().measured_speed) < 1.0, GetParam().still);

  Sweep sweep{table, table.commands, before, GetParam()};
  EXPECT_EQ(sweep.run(), "");

  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const SequenceTable::Row& row = table.rows[i];
    const bool meant = row.state == before.state() && (GetParam().still ? row.still : row.turning) &&
                       (!row.only_free || GetParam().condition == Condition::Free);
    EXPECT_EQ(sweep.used[i], meant) << "row " << i + 1 << " of the transitions";
  }
}

TEST_P(SequenceControl, TakesAHaltWithTheOptionCode0AsAMissingOperationEnable) {
  const SequenceTable table = read_sequence_table();
  const TestAxis before = prepare(GetParam(), 0.0);

  EXPECT_EQ((Sweep{table, table.halt_commands, before, GetParam()}.run(kAroundTheHalt)), "");
}

TEST_P(SequenceControl, HaltsInItsStateWithTheOptionCodes1To3) {
  const SequenceTable table = read_sequence_table();
  for (const double option : {1.0, 2.0, 3.0}) {
    const TestAxis before = prepare(GetParam(), option);

    EXPECT_EQ((Sweep{table, table.commands, before, GetParam()}.run(kAroundTheHalt)), "") << option;
  }
}

INSTANTIATE_TEST_SUITE_P(States, SequenceControl, testing::ValuesIn(cases()),
                         [](const auto& test) { return name_of(test.param); });

TEST(SequenceTable, HoldsWhileAMeasurementOfTheMotorLeads) {
  const SequenceTable table = read_sequence_table();
  for (const std::uint16_t parameter : std::array<std::uint16_t, 2>{1910, 1960}) {
    TestAxis before;
    ASSERT_TRUE(before.axis.write(parameter, 1.0));
    before.enable();
    before.run(0.1);
    ASSERT_EQ(before.state(), OperationEnabled);
    ASSERT_TRUE(before.axis.identification().leads());
    Sweep sweep{table, table.commands, before, {.state = "enabled", .still = true}};
    for (unsigned word = 0; word <= kAroundTheHalt; ++word) {
      TestAxis trial = before;
      trial.setpoints.controlword = static_cast<std::uint16_t>(word);
      trial.axis.cycle(trial.setpoints, motor::kControlPeriod);
      EXPECT_EQ(trial.state(), sweep.expected(trial.setpoints.controlword)) << word;
      EXPECT_EQ(trial.axis.identification().leads(), trial.state() == OperationEnabled) << word;
    }
  }
}

TEST(SequenceTable, HasAStatuswordForEveryStateAndOneCommandForEveryControlword) {
  const SequenceTable table = read_sequence_table();

  EXPECT_EQ(table.statuswords.size(), kStateCount);
  EXPECT_EQ(states_by_name().size(), kStateCount);
  for (const SequenceTable::Commands* commands : {&table.commands, &table.halt_commands})
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
      const auto matching = std::count_if(commands->begin(), commands->end(), [=](const auto& command) {
        const bool event = command.first == "any" || command.first == "acknowledge";
        return !event && command.second.matches(static_cast<std::uint16_t>(word));
      });
      ASSERT_EQ(matching, 1) << word;
    }
  for (const SequenceTable::Row& row : table.rows) EXPECT_NE(table.commands.count(row.command), 0u) << row.command;
}

}  // namespace
}  // namespace drive
