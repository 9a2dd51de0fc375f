// Gear, pitch and switches of an axis.
#include <numbers>

#include <gtest/gtest.h>

#include "drive/values/factory_values.hpp"
#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/daemon/configuration/command_line.hpp"

namespace axisd {
namespace {

Configuration parsed(const std::string& axes) {
  return parse_configuration(R"({"axes": [)" + axes + "]}", "node.json");
}

AxisConfiguration axis_with(const std::string& load) {
  return parsed(R"({"load": )" + load + "}").axes.front();
}

TEST(ConfiguredGear, IsARatioOfWholeNumbers) {
  struct Case {
    const char* gear;
    std::uint32_t motor;
    std::uint32_t load;
  };
  for (const Case& gear :
       {Case{"1", 1, 1}, Case{"10", 10, 1}, Case{"2.5", 5, 2}, Case{"0.001", 1, 1000}, Case{"10000", 10000, 1},
        Case{"2.3333", 23333, 10000}, Case{"[7, 3]", 7, 3}, Case{"[1048576, 1048575]", 1048576, 1048575},
        Case{"0.3333333333333333", 1, 3}, Case{"3.141592653589793", 103993, 33102}}) {
    const AxisConfiguration axis = axis_with(std::string{R"({"gear": )"} + gear.gear + R"(, "inertia": 1})");
    EXPECT_EQ(axis.mechanics.gear_motor, gear.motor) << gear.gear;
    EXPECT_EQ(axis.mechanics.gear_load, gear.load) << gear.gear;
    EXPECT_DOUBLE_EQ(axis.load.inertia, 1.0 / axis.mechanics.ratio() / axis.mechanics.ratio());
  }
}

TEST(ConfiguredGear, AndPitchAreFactoryValues) {
  using namespace drive::factory;
  drive::ObjectContext context{};
  EXPECT_EQ(gear_motor_revolutions(context, 0), 1.0);
  EXPECT_EQ(gear_load_revolutions(context, 0), 1.0);
  EXPECT_EQ(units_per_load_revolution(context, 0), 10000.0);
  context.axis.mechanics = axis_with(R"({"gear": [7, 3], "pitch": 5.08})").mechanics;
  EXPECT_EQ(gear_motor_revolutions(context, 0), 7.0);
  EXPECT_EQ(gear_load_revolutions(context, 0), 3.0);
  EXPECT_EQ(units_per_load_revolution(context, 0), 5080.0);
}

TEST(ConfiguredEndStops, MayBeRevolutionsOfTheLoad) {
  const motor::Load load =
      axis_with(R"({"gear": 3, "end_stops": {"lower_revolutions": -0.5, "upper_revolutions": 12.5}})").load;

  EXPECT_DOUBLE_EQ(load.end_stops.lower, -3.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(load.end_stops.upper, 75.0 * std::numbers::pi);
}

TEST(ConfiguredSwitches, AreThoseOfTheAxis) {
  const Configuration unit = parsed(R"({"switches": [{"input": 0, "from": 20, "to": 20.5},
                                                     {"input": 7, "from": -1, "to": 30, "inverted": true}]},
                                       {"switches": [{"input": 3, "from": -2, "to": -1.5, "inverted": false}]}, {})");

  const auto switches = unit.axes[0].switches.all();
  ASSERT_EQ(switches.size(), 2U);
  EXPECT_EQ(switches[0].input, 0U);
  EXPECT_EQ(switches[0].from, 20.0);
  EXPECT_EQ(switches[0].to, 20.5);
  EXPECT_FALSE(switches[0].inverted);
  EXPECT_EQ(switches[1].input, 7U);
  EXPECT_TRUE(switches[1].inverted);
  EXPECT_EQ(unit.axes[1].switches.all()[0].from, -2.0);
  EXPECT_TRUE(unit.axes[2].switches.all().empty());
}

class BadMechanics : public testing::TestWithParam<BadFile> {};

TEST_P(BadMechanics, AreRefusedWithFilePlaceAndExpectation) {
  EXPECT_EQ(message_of([] { parsed(std::string{GetParam().text}); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Load, BadMechanics,
    testing::Values(
        BadFile{R"({"load": {"gear": 0.0009}})",
                "node.json: /axes/0/load/gear: expected a number 0.001 to 10000, got 0.0009"},
        BadFile{R"({"load": {"gear": "7:3"}})",
                "node.json: /axes/0/load/gear: expected a number 0.001 to 10000, got \"7:3\""},
        BadFile{R"({"load": {"gear": [7]}})", "node.json: /axes/0/load/gear: expected an array of 2, got [7]"},
        BadFile{R"({"load": {"gear": [7, 0]}})",
                "node.json: /axes/0/load/gear/1: expected an integer 1 to 1048576, got 0"},
        BadFile{R"({"load": {"gear": [7.5, 3]}})",
                "node.json: /axes/0/load/gear/0: expected an integer 1 to 1048576, got 7.5"},
        BadFile{
            R"({"load": {"gear": [1, 1001]}})",
            "node.json: /axes/0/load/gear: expected revolutions of the motor and the load with a ratio of 0.001 "
            "to 10000, got [1,1001]"},
        BadFile{R"({"load": {"pitch": 0}})",
                "node.json: /axes/0/load/pitch: expected a number 0.001 to 2147483, got 0"},
        BadFile{
            R"({"load": {"end_stops": {"upper": 1, "upper_revolutions": 2}}})",
            "node.json: /axes/0/load/end_stops/upper_revolutions: expected upper or upper_revolutions, not both, "
            "got 2"},
        BadFile{
            R"({"load": {"end_stops": {"lower_revolutions": 1}}})",
            "node.json: /axes/0/load/end_stops/lower_revolutions: expected a number not above 0, where the load "
            "is at power-on, got 1"}));

INSTANTIATE_TEST_SUITE_P(
    Switches, BadMechanics,
    testing::Values(
        BadFile{R"({"switches": {}})", "node.json: /axes/0/switches: expected an array of 0 to 8, got {}"},
        BadFile{R"({"switches": [{"input": 0, "from": 1}]})",
                "node.json: /axes/0/switches/0: expected the key to, got {\"from\":1,\"input\":0}"},
        BadFile{R"({"switches": [{"input": 0, "from": 1, "to": 2, "at": 3}]})",
                "node.json: /axes/0/switches/0/at: unknown key, expected one of: input, role, from, to, inverted"},
        BadFile{R"({"switches": [{"input": 8, "from": 1, "to": 2}]})",
                "node.json: /axes/0/switches/0/input: expected an integer 0 to 7, got 8"},
        BadFile{R"({"switches": [{"input": 0, "from": 2, "to": 2}]})",
                "node.json: /axes/0/switches/0/to: expected a number above 2, where the switch begins, got 2"},
        BadFile{R"({"switches": [{"input": 0, "from": 1, "to": 2, "inverted": 1}]})",
                "node.json: /axes/0/switches/0/inverted: expected true or false, got 1"},
        BadFile{
            R"({"switches": [{"input": 4, "from": 1, "to": 2}, {"input": 4, "from": 3, "to": 4}]})",
            "node.json: /axes/0/switches/1/input: expected an input that /axes/0/switches/0 does not feed, got 4"},
        BadFile{
            R"({"switches": [{"input": 4, "from": 1, "to": 2}]}, {"switches": [{"input": 4, "from": 3, "to": 4}]})",
            "node.json: /axes/1/switches/0/input: expected an input that /axes/0/switches/0 does not feed, got "
            "4"}));

}  // namespace
}  // namespace axisd
