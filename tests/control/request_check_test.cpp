#include "control/request_check.hpp"

#include <string>
#include <string_view>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"

namespace control {
namespace {

/// What is wrong with @p params of @p method on a unit of two axes.
std::string verdict(std::string_view method, std::string_view params) {
  const auto checked = check(*find_method(method), nlohmann::json::parse(params), 2);
  return checked ? "fine" : checked.error();
}

/// A request and what is said of it.
struct Case {
  std::string_view method;
  std::string_view params;
  std::string_view said;
};

TEST(RequestCheck, LetsThroughWhatTheRowsAllow) {
  for (const auto& [method, params] : {std::pair{"status", R"({"unknown": [1]})"},
                                       {"explain", "{}"},
                                       {"explain", R"({"axis": 2})"},
                                       {"fault.inject", R"({"axis": 0, "number": 65535})"},
                                       {"fault.inject", R"({"axis": 2, "number": 1, "value": 4294967295})"},
                                       {"load.set", R"({"axis": 1, "torque_Nm": -1e6})"},
                                       {"load.set", R"({"axis": 1, "torque_Nm": -5, "type": "constant"})"},
                                       {"load.set", R"({"axis": 1, "torque_Nm": 0, "type": "friction"})"},
                                       {"supply.set", R"({"line_voltage_V": 1000})"},
                                       {"encoder.fail", R"({"axis": 1, "defect": "lost_pulses"})"},
                                       {"input.set", R"({"input": 17, "state": false})"},
                                       {"input.set", R"({"input": 21, "state": true})"}})
    EXPECT_EQ(verdict(method, params), "fine") << method << params;
}

TEST(RequestCheck, SaysInOneLineWhatIsWrong) {
  for (const Case& c : {
           Case{"explain", R"({"axis": null})", "axis: expected an integer 1 to 2, got null"},
           Case{"explain", R"({"axis": 0})", "axis: expected an integer 1 to 2, got 0"},
           Case{"fault.ack", "{}", "axis: expected an integer 0 to 2, got nothing"},
           Case{"fault.inject", R"({"number": 0})", "axis: expected an integer 0 to 2, got nothing"},
           Case{"fault.inject", R"({"axis": 3, "number": 0})", "axis: expected an integer 0 to 2, got 3"},
           Case{"fault.inject", R"({"axis": 1.0})", "axis: expected an integer 0 to 2, got 1.0"},
           Case{"fault.inject", R"({"axis": 1})", "number: expected an integer 1 to 65535, got nothing"},
           Case{"fault.inject", R"({"axis": 1, "number": 65536})",
                "number: expected an integer 1 to 65535, got 65536"},
           Case{"fault.inject", R"({"axis": 1, "number": 1, "value": -1})",
                "value: expected an integer 0 to 4294967295, got -1"},
           Case{"fault.inject", R"({"axis": 1, "number": 1, "value": 4294967296})",
                "value: expected an integer 0 to 4294967295, got 4294967296"},
           Case{"load.set", R"({"axis": 1})", "torque_Nm: expected a number -1000000 to 1000000, got nothing"},
           Case{"load.set", R"({"axis": 1, "torque_Nm": -1, "type": "friction"})",
                "torque_Nm: expected a number 0 to 1000000, got -1"},
           Case{"load.set", R"({"axis": 1, "torque_Nm": "5", "type": "hoist"})",
                "type: expected constant or friction, got \"hoist\""},
           Case{"load.set", R"({"axis": 1, "torque_Nm": 5, "type": 1})",
                "type: expected constant or friction, got 1"},
           Case{"supply.set", R"({"line_voltage_V": 1001})",
                "line_voltage_V: expected a number 0 to 1000, got 1001"},
           Case{"encoder.fail", R"({"axis": 1})",
                "defect: expected none, loss, lost_pulses or reversed, got nothing"},
           Case{"encoder.fail", R"({"axis": 1, "defect": "los"})",
                "defect: expected none, loss, lost_pulses or reversed, got \"los\""},
           Case{"input.set", R"({"input": 22, "state": true})", "input: expected an integer 0 to 21, got 22"},
           Case{"input.set", R"({"input": 18, "state": true})", "input: expected 0 to 17, 20 or 21, got 18"},
           Case{"input.set", R"({"input": 0, "state": 1})", "state: expected true or false, got 1"},
           Case{"input.set", R"({"input": 0})", "state: expected true or false, got nothing"},
       })
    EXPECT_EQ(verdict(c.method, c.params), c.said) << c.params;
}

/// What is wrong with @p value for a parameter of @p form on a unit of two axes.
std::string verdict(Form form, std::string_view value, std::string_view absent = "") {
  const Parameter parameter{.key = "x", .form = form, .range = {1, 2}, .absent = absent};
  const Method method{.name = "test", .summary = "", .parameters = {&parameter, 1}};
  const auto checked = check(method, nlohmann::json::parse(value), 2);
  return checked ? "fine" : checked.error();
}

TEST(RequestCheck, KnowsEveryForm) {
  for (const auto& [form, value] : {std::pair{Form::Place, R"({"x": 0})"},
                                    {Form::Place, R"({"x": "infeed"})"},
                                    {Form::Text, R"({"x": ""})"},
                                    {Form::List, R"({"x": "p1120"})"},
                                    {Form::List, R"({"x": ["p1120", "r63"]})"},
                                    {Form::Words, R"({"x": "047E0000"})"},
                                    {Form::Words, R"({"x": [1150, "047E"]})"},
                                    {Form::Value, R"({"x": "r0899.2"})"},
                                    {Form::Value, R"({"x": -0.5})"},
                                    {Form::Any, R"({"x": [{"a": null}]})"}})
    EXPECT_EQ(verdict(form, value), "fine") << value;
  for (const auto& [form, value, said] :
       {std::tuple{Form::Place, R"({"x": 3})", "x: expected an integer 0 to 2 or \"infeed\", got 3"},
        {Form::Place, R"({"x": -1})", "x: expected an integer 0 to 2 or \"infeed\", got -1"},
        {Form::Place, R"({"x": "cu"})", "x: expected an integer 0 to 2 or \"infeed\", got \"cu\""},
        {Form::Text, R"({"x": 5})", "x: expected a text, got 5"},
        {Form::Text, "{}", "x: expected a text, got nothing"},
        {Form::List, R"({"x": [1]})", "x: expected a text or a list of texts, got [1]"},
        {Form::List, R"({"x": []})", "x: expected 1 to 2 texts, got 0"},
        {Form::List, R"({"x": ["", "", ""]})", "x: expected 1 to 2 texts, got 3"},
        {Form::Words, R"({"x": [65536]})",
         "x: expected a hexadecimal text or a list of words (0 to 65535, or hexadecimal texts), got [65536]"},
        {Form::Words, R"({"x": [1, 2, 3]})", "x: expected 1 to 2 words, got 3"},
        {Form::Value, R"({"x": true})", "x: expected a number or a text, got true"},
        {Form::Value, R"({"x": [1]})", "x: expected a number or a text, got [1]"},
        {Form::Any, "{}", "x: expected a value, got nothing"}})
    EXPECT_EQ(verdict(form, value), said) << value;
  EXPECT_EQ(verdict(Form::Text, "{}", "none"), "fine");
}

TEST(RequestCheck, QuotesTheBeginningOfALongValue) {
  const std::string said = verdict(Form::Place, R"({"x": ")" + std::string(60000, '"' - 1) + "\"}");

  EXPECT_LT(said.size(), 200u);
  EXPECT_TRUE(said.ends_with("!...")) << said;
}

TEST(RequestCheck, NamesTheOnlyAxisOfAUnit) {
  const auto checked = check(*find_method("explain"), nlohmann::json::parse(R"({"axis": 2})"), 1);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error(), "axis: expected 1, got 2");
}

}  // namespace
}  // namespace control
