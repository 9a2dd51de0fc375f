// The terminals of the control unit over the control socket, and an analogue setpoint by way of r0752.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct TerminalLists : ControlledUnit {
  json input(std::size_t place) { return result_of("input.list").at("inputs").at(place); }
  json output(std::size_t place) { return result_of("output.list").at("outputs").at(place); }
  json value(const char* parameter) {
    return result_of("parameter.read", {{"parameters", {parameter}}}).at("parameters").at(0).at("value");
  }
  void write(const char* parameter, const json& value) {
    result_of("parameter.write", {{"parameter", parameter}, {"value", value}});
  }
};

TEST_F(TerminalLists, ShowInputsAsTheyAreAndAsTheUnitSeesThem) {
  result_of("input.set", {{"input", 3}, {"state", true}});
  write("p0795.3", 1);  // simulated, as 0
  run(std::chrono::milliseconds{8});

  EXPECT_EQ(result_of("input.list").at("inputs").size(), 20U);
  EXPECT_EQ(input(3), (json{{"input", 3},
                            {"name", "DI 3"},
                            {"is_output", false},
                            {"terminal", true},
                            {"state", false},
                            {"is_simulated", true}}));
  EXPECT_EQ(input(8).at("name"), "DI/DO 8");
}

TEST_F(TerminalLists, ShowOutputsWithWhatTheyTake) {
  write("p0728.8", 1);
  write("p0738", 1);
  write("p0739", "r0722.1");
  run(std::chrono::milliseconds{8});

  EXPECT_EQ(output(0), (json{{"output", 8},
                             {"name", "DI/DO 8"},
                             {"is_output", true},
                             {"state", true},
                             {"is_inverted", false},
                             {"source", "1"}}));
  EXPECT_EQ(output(1).at("source"), "r0722.1");
  EXPECT_EQ(output(1).at("is_output"), false);
}

TEST_F(TerminalLists, LeadASpeedSetpointFromTheAnalogueInput) {
  write("1/p1070", "r0752 of drive object 1");
  write("1/p2000", 3000);

  result_of("input.analog", {{"voltage_V", 5}});
  run(std::chrono::milliseconds{12});

  EXPECT_EQ(value("r0752"), 5.0);
  EXPECT_EQ(result_of("input.list").at("analog").at(0).at("value_V"), 5.0);
  EXPECT_NEAR(value("1/r1078").get<double>(), 1500.0, 0.1);
  EXPECT_EQ(error_of("input.analog", {{"voltage_V", 10.5}}).code, ErrorCode::BadParameter);
}

}  // namespace
}  // namespace axisd
