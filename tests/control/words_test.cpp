#include "control/words.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"

namespace control {
namespace {

/// The parameters that @p words ask @p method for, or what is wrong with them.
std::string params_of(std::string_view method, const std::vector<std::string>& words) {
  std::vector<Words> each(find_method(method)->parameters.size());
  for (std::size_t i = 0; i < words.size(); ++i) each[i] = {words[i]};
  const auto params = parse_words(*find_method(method), each);
  return params ? params->dump() : params.error();
}

TEST(CommandWords, BecomeParameters) {
  EXPECT_EQ(params_of("status", {}), "{}");
  EXPECT_EQ(params_of("explain", {}), "{}");
  EXPECT_EQ(params_of("explain", {"9"}), R"({"axis":9})") << "the daemon knows how many there are";
  for (const char* const fault : {"7860", "07860", "F7860", "F07860", "f7860", "A07860"})
    EXPECT_EQ(params_of("fault.inject", {"0", fault}), R"({"axis":0,"number":7860})");
  EXPECT_EQ(params_of("fault.inject", {"1", "7860", "4294967295"}),
            R"({"axis":1,"number":7860,"value":4294967295})");
  EXPECT_EQ(params_of("load.set", {"1", "+2.5"}), R"({"axis":1,"torque_Nm":2.5})");
  EXPECT_EQ(params_of("load.set", {"1", "-1e3", "hoist"}), R"({"axis":1,"torque_Nm":-1000.0,"type":"hoist"})")
      << "the daemon knows the types";
  EXPECT_EQ(params_of("encoder.fail", {"1", ""}), R"({"axis":1,"defect":""})");
  EXPECT_EQ(params_of("input.set", {"-1", "on"}), R"({"input":-1,"state":true})") << "the daemon knows the inputs";
  EXPECT_EQ(params_of("input.set", {"20", "off"}), R"({"input":20,"state":false})");
}

TEST(CommandWords, ThatAreNoneAreRefusedInOneLine) {
  EXPECT_EQ(params_of("explain", {"0"}), "AXIS: expected a number from 1, got \"0\"");
  EXPECT_EQ(params_of("fault.ack", {"-1"}), "AXIS: expected a number from 0, got \"-1\"");
  EXPECT_EQ(params_of("fault.ack", {"1x"}), "AXIS: expected a number from 0, got \"1x\"");
  EXPECT_EQ(params_of("fault.ack", {"99999999999"}), "AXIS: expected a number from 0, got \"99999999999\"");
  for (const char* const fault : {"", "F", "0", "65536", "FF1", "C1"})
    EXPECT_EQ(params_of("fault.inject", {"1", fault}),
              std::string{"NUMBER: expected a number such as 7860, F07860 or A07850, got \""} + fault + '"');
  EXPECT_EQ(params_of("fault.inject", {"1", "1", "4294967296"}),
            "VALUE: expected a number 0 to 4294967295, got \"4294967296\"");
  EXPECT_EQ(params_of("load.set", {"1", "inf"}), "TORQUE: expected a number of N·m, got \"inf\"");
  EXPECT_EQ(params_of("supply.set", {"400V"}), "VOLTAGE: expected a number of V, got \"400V\"");
  EXPECT_EQ(params_of("input.set", {"a", "on"}), "INPUT: expected a number from 0, got \"a\"");
  EXPECT_EQ(params_of("input.set", {"1", "true"}), "STATE: expected on or off, got \"true\"");
}

/// What @p words become for one parameter of @p form.
std::string value_of(Form form, const Words& words, std::string_view unit = "") {
  const Parameter parameter{.key = "x", .form = form, .unit = unit, .option = "ex"};
  const Method method{.name = "test", .summary = "", .parameters = {&parameter, 1}};
  const auto params = parse_words(method, std::vector<Words>{words});
  return params ? params->dump() : params.error();
}

TEST(CommandWords, BecomeWhatTheFormSays) {
  EXPECT_EQ(value_of(Form::Place, {"0"}), R"({"x":0})");
  EXPECT_EQ(value_of(Form::Place, {"infeed"}), R"({"x":"infeed"})");
  EXPECT_EQ(value_of(Form::Place, {"in"}), "--ex: expected a number from 0 or infeed, got \"in\"");
  EXPECT_EQ(value_of(Form::Text, {"12"}), R"({"x":"12"})");
  EXPECT_EQ(value_of(Form::List, {"p1120", "r63"}), R"({"x":["p1120","r63"]})");
  EXPECT_EQ(value_of(Form::List, {}), "{}");
  EXPECT_EQ(value_of(Form::Words, {"047E", "0000"}), R"({"x":["047E","0000"]})");
  EXPECT_EQ(value_of(Form::Value, {"-12"}), R"({"x":-12})");
  EXPECT_EQ(value_of(Form::Value, {"+0.5"}), R"({"x":0.5})");
  EXPECT_EQ(value_of(Form::Value, {"0x1F"}), R"({"x":31})");
  EXPECT_EQ(value_of(Form::Value, {"0x"}), R"({"x":"0x"})");
  EXPECT_EQ(value_of(Form::Value, {"inf"}), R"({"x":"inf"})");
  EXPECT_EQ(value_of(Form::Value, {"r0899.2"}), R"({"x":"r0899.2"})");
  EXPECT_EQ(value_of(Form::Any, {R"({"a":[1]})"}), R"({"x":{"a":[1]}})");
  EXPECT_EQ(value_of(Form::Any, {"cycle"}), R"({"x":"cycle"})");
  EXPECT_EQ(value_of(Form::Number, {"x"}), "--ex: expected a number, got \"x\"");
}

TEST(CommandWords, AreNamedWhereTheDaemonNamesParameters) {
  const Method& load = *find_method("load.set");
  EXPECT_EQ(in_words_of(load, "torque_Nm: expected a number"), "TORQUE: expected a number");
  EXPECT_EQ(in_words_of(load, "the axis: is gone"), "the axis: is gone");
}

}  // namespace
}  // namespace control
