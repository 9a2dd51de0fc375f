// Every message of positioning from its cause.
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/drive/csv.hpp"
#include "tests/drive/positioning/positioning_scenarios.hpp"

namespace drive {
namespace {

class PositioningCauses : public testing::TestWithParam<Scenario> {};

TEST_P(PositioningCauses, BringTheirMessage) {
  const Scenario& scenario = GetParam();
  PositioningUnit unit{scenario.configuration()};
  EXPECT_FALSE(unit.has(scenario.message));
  scenario.bring(unit);
  EXPECT_TRUE(unit.run_until([&] { return unit.has(scenario.message); }, 8000))
      << testing::PrintToString(unit.messages());
  EXPECT_EQ(unit.value_of(scenario.message), scenario.value);
}

INSTANTIATE_TEST_SUITE_P(List, PositioningCauses, testing::ValuesIn(positioning_scenarios()),
                         [](const auto& test) { return std::to_string(test.param.message); });

/// Of changes of data sets, which a unit has one of.
const std::set<int> kOfNothingThatAnAxisHas{7494, 7590};

/// p2118 and p2119 make a fault of the alarm at a software limit; it stops with OFF1 as the list says.
TEST(PositioningMessages, StopAsFaults) {
  PositioningUnit unit;
  unit.set(2118, 7480.0);
  unit.set(2119, 1.0);
  unit.set(2581, 5000.0);
  unit.set(2582, 1.0);
  unit.enable();
  unit.set_reference();
  unit.move(9000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.axis().actual().state == State::FaultReactionActive; }));
  EXPECT_TRUE(unit.run_until([&] { return unit.axis().actual().state == State::Fault; }, 2000));
  EXPECT_EQ(unit.read(945), 7480.0);
  EXPECT_FALSE(unit.bit(2526, 3));
}

TEST(PositioningMessages, TellOfAMissingEncoderFromTheBeginning) {
  AxisConfiguration axis = PositioningUnit::axis_configuration();
  axis.machine.encoder.type = motor::EncoderType::None;
  PositioningUnit unit{axis};
  EXPECT_TRUE(unit.has(7587));
  EXPECT_TRUE(unit.has(7454));
}

TEST(PositioningMessages, HaveEachItsScenario) {
  std::set<int> covered{7587};  // TellOfAMissingEncoderFromTheBeginning
  for (const Scenario& scenario : positioning_scenarios()) covered.insert(scenario.message);
  std::set<int> raised;
  for (const PositioningMessageRow& row : kPositioningMessages) raised.insert(row.number);
  EXPECT_EQ(covered, raised);

  for (const drive_test::CsvRow& row : drive_test::read_csv("faults.csv")) {
    const int number = std::stoi(row.at("code").substr(1));
    const bool of_positioning = row.at("name").rfind("EPOS", 0) == 0 || (number >= 7440 && number <= 7599);
    const bool never = row.at("cause").find("not raised by axisd") != std::string::npos;
    if (!of_positioning || number == 7575 || kOfNothingThatAnAxisHas.contains(number)) continue;
    EXPECT_EQ(raised.contains(number), !never) << number;
  }
}

}  // namespace
}  // namespace drive
