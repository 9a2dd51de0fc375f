/// The list of messages (data/faults.csv) against the table and against a unit of two axes.
#include <regex>

#include <gtest/gtest.h>

#include "drive/drive_unit.hpp"
#include "tests/drive/csv.hpp"

namespace drive {
namespace {

using drive_test::CsvRow;

constexpr std::uint8_t kUnit = kControlUnitNumber;
constexpr std::uint8_t kX = 2;
constexpr std::uint8_t kY = 3;

const std::map<std::string, Reaction> kReactions{
    {"NONE", Reaction::None},      {"OFF1", Reaction::Off1},   {"OFF2", Reaction::Off2},
    {"OFF3", Reaction::Off3},      {"STOP2", Reaction::Stop2}, {"IASC/DCBRK", Reaction::ShortCircuit},
    {"ENCODER", Reaction::Encoder}};
const std::map<std::string, Acknowledge> kAcknowledges{{"NONE", Acknowledge::None},
                                                       {"IMMEDIATELY", Acknowledge::Immediately},
                                                       {"PULSE_INHIBIT", Acknowledge::PulseInhibit},
                                                       {"POWER_ON", Acknowledge::PowerOn}};
const std::map<std::string, Scope> kScopes{
    {"AXIS", Scope::Axis}, {"CU", Scope::ControlUnit}, {"BOTH", Scope::Both}};

/// "[settable: OFF2 (NONE, OFF1)]" in the cause, or of an alarm "[settable as fault: OFF1]".
Reactions alternatives_in(const std::string& cause) {
  if (cause.find("[settable as fault: OFF1]") != std::string::npos) return bit_of(Reaction::Off1);
  static const std::regex kSettable{R"(\[settable: \S+ \(([^)]*)\)\])"};
  static const std::regex kName{"[A-Z0-9/]+"};
  std::smatch settable;
  Reactions set = 0;
  if (!std::regex_search(cause, settable, kSettable)) return set;
  const std::string names = settable[1];
  for (std::sregex_iterator it{names.begin(), names.end(), kName}; it != std::sregex_iterator{}; ++it)
    set = static_cast<Reactions>(set | bit_of(kReactions.at(it->str())));
  return set;
}

std::uint8_t bits_in(const std::string& list) {
  unsigned bits = 0;
  std::stringstream text{list};
  for (std::string bit; std::getline(text, bit, ';');) bits |= 1U << std::stoul(bit);
  return static_cast<std::uint8_t>(bits);
}

std::uint16_t number_of(const CsvRow& row) {
  return static_cast<std::uint16_t>(std::stoi(row.at("code").substr(1)));
}

TEST(MessageList, IsTheTable) {
  const std::vector<CsvRow> list = drive_test::read_csv("faults.csv");

  EXPECT_EQ(list.size(), fault_rows().size());
  for (const CsvRow& listed : list) {
    SCOPED_TRACE(listed.at("code"));
    const FaultRow* const row = find_fault(number_of(listed));
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(fault_text(*row), listed.at("code"));
    EXPECT_EQ(row->name, listed.at("name"));
    EXPECT_EQ(row->scope, kScopes.at(listed.at("do")));
    EXPECT_EQ(row->reaction, kReactions.at(listed.at("reaction")));
    EXPECT_EQ(row->alternatives, alternatives_in(listed.at("cause")));
    EXPECT_EQ(row->acknowledge, kAcknowledges.at(listed.at("acknowledge")));
    const bool global = listed.at("cause").find("propagation GLOBAL") != std::string::npos;
    EXPECT_EQ(row->propagation, global ? Propagation::Global : Propagation::Local);
    EXPECT_EQ(row->error_register, bits_in(listed.at("error_register_bits")));
    const std::string& code = listed.at("emcy_code");
    const FaultEntry entry{.row = row, .value = 2, .kind = row->kind};  // F08700: the value that the list means
    EXPECT_EQ(entry.emcy_code(), code.empty() ? 0 : std::stoi(code, nullptr, 16));
  }
}

/// One message on a unit of two axes that stand in Ready to switch on.
class EveryListedMessage : public testing::TestWithParam<FaultRow> {
 protected:
  EveryListedMessage() {
    for (Axis& axis : unit_.axes())
      for (int i = 0; i < 2; ++i) axis.cycle(Setpoints{.controlword = 0x0006}, 0.004);
  }
  std::uint8_t origin() const { return GetParam().scope == Scope::ControlUnit ? kUnit : kX; }
  double read(std::uint16_t number, std::size_t index = 0) const { return read_of(origin(), number, index); }
  double read_of(std::uint8_t object, std::uint16_t number, std::size_t index = 0) const {
    return decode(unit_.read(object, number, index).value());
  }

  DriveUnit unit_{{.axes = {{}, {}}, .node_id = 5}};
};

TEST_P(EveryListedMessage, IsInTheBuffersFromItsComingToItsGoing) {
  const FaultRow& row = GetParam();
  const bool alarm = row.kind == Kind::Alarm;
  unit_.set_time(86'400'000 + 1500);
  ASSERT_TRUE(unit_.raise(origin(), row.number, 77));

  EXPECT_EQ(read(alarm ? 2122 : 945), row.number);
  EXPECT_EQ(read(alarm ? 2110 : 947), row.number);
  EXPECT_EQ(read(alarm ? 2124 : 949), 77.0);
  EXPECT_EQ(read(alarm ? 2123 : 948), 1500.0);
  EXPECT_EQ(read(alarm ? 2145 : 2130), 1.0);
  EXPECT_EQ(read(alarm ? 2132 : 2131), row.number);
  EXPECT_EQ(read(2139), alarm ? 0x80 : 0x08);

  unit_.set_time(86'400'000 + 2500);
  if (alarm) unit_.withdraw(origin(), row.number);
  const bool cleared = unit_.acknowledge();
  const bool stays = row.acknowledge == Acknowledge::PowerOn;
  const std::size_t place = alarm || stays ? 0 : 8;
  EXPECT_EQ(cleared, !stays);
  EXPECT_EQ(read(alarm ? 2122 : 945, place), row.number);
  EXPECT_EQ(read(alarm ? 2125 : 2109, place), stays ? 0.0 : 2500.0);
  EXPECT_EQ(read(2139), stays ? 0x08 : 0.0);
  EXPECT_EQ(read(alarm ? 2111 : 952), 1.0);
}

TEST_P(EveryListedMessage, SpreadsAsItsPropagationSays) {
  const FaultRow& row = GetParam();
  const auto has = [&](std::uint8_t object) {
    return read_of(object, row.kind == Kind::Alarm ? 2122 : 945) == row.number;
  };
  ASSERT_TRUE(unit_.raise(origin(), row.number));

  const bool global = row.propagation == Propagation::Global;
  EXPECT_TRUE(has(origin()));
  EXPECT_EQ(has(kY), global);
  EXPECT_EQ(has(kUnit), global || origin() == kUnit);
  if (row.kind == Kind::Alarm || row.reaction == Reaction::None) return;
  EXPECT_EQ(unit_.axes()[1].actual().state == State::Fault, global);
  EXPECT_EQ(unit_.axes()[0].actual().state == State::Fault, origin() == kX || global);
}

TEST_P(EveryListedMessage, CanBeMutedAndMadeTheOtherType) {
  const FaultRow& row = GetParam();
  DriveObject& object = *unit_.object(origin());
  const bool alarm = row.kind == Kind::Alarm;
  ASSERT_TRUE(object.write(2118, row.number));

  ASSERT_TRUE(object.write(2119, 3));
  ASSERT_TRUE(object.raise(row.number));
  EXPECT_EQ(read(2139), 0.0);
  ASSERT_TRUE(object.write(2119, alarm ? 1 : 2));
  ASSERT_TRUE(object.raise(row.number));
  EXPECT_EQ(read(2139), alarm ? 0x08 : 0x80);
  const bool communication = row.number >= 8700 && row.number < 8800;
  EXPECT_EQ(object.messages().error_register(), communication ? 0x11 : alarm ? 0x81 : 0x00);
  object.withdraw(row.number);
  object.acknowledge();
  EXPECT_EQ(read(2139), 0.0);
}

TEST_P(EveryListedMessage, TakesTheReactionsThatItOffersAndNoOther) {
  const FaultRow& row = GetParam();
  if (row.kind == Kind::Alarm || origin() == kUnit) return;
  const std::array values{Reaction::None, Reaction::Off1, Reaction::Off2, Reaction::Off3};
  for (std::size_t value = 0; value < values.size(); ++value) {
    MessageSettings settings;
    settings.reaction_numbers[19] = row.number;
    settings.reactions[19] = static_cast<std::uint8_t>(value);
    const bool offered = values[value] == row.reaction || (row.alternatives & bit_of(values[value])) != 0;
    EXPECT_EQ(settings.reaction_to(row), offered ? std::optional{values[value]} : std::nullopt) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(List, EveryListedMessage, testing::ValuesIn(fault_rows().begin(), fault_rows().end()),
                         [](const auto& test) { return fault_text(test.param); });

}  // namespace
}  // namespace drive
