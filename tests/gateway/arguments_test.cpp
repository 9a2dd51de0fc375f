#include "gateway/routes/arguments.hpp"

#include <gtest/gtest.h>

namespace gateway {
namespace {

using nlohmann::json;

constexpr const char* kUnit = "/api/v1/units/vcan0/5";

std::string arguments(std::string_view verb, const std::string& path, const Query& query = {},
                      std::string_view body = "") {
  const auto match = find_route(verb, kUnit + path);
  if (!match) return match.error().code;
  const auto params = arguments_of(*match, query, body);
  return params ? params->dump() : params.error().message;
}

TEST(Arguments, ComeFromPathQueryAndBody) {
  EXPECT_EQ(arguments("PUT", "/parameters/p1120", {{"axis", "2"}}, R"({"value": 2.5})"),
            R"({"axis":2,"parameter":"p1120","value":2.5})");
  EXPECT_EQ(arguments("GET", "/parameters/p1120,r0722.3", {{"axis", "infeed"}}),
            R"({"axis":"infeed","parameters":["p1120","r0722.3"]})");
  EXPECT_EQ(arguments("PUT", "/terminals/inputs/3", {}, R"({"state": true})"), R"({"input":3,"state":true})");
  EXPECT_EQ(arguments("GET", "/pdos", {{"all", "true"}, {"count", "5"}}), R"({"all":true,"count":5})");
  EXPECT_EQ(arguments("GET", ""), "{}");
}

TEST(Arguments, ThatAreNoneOfTheirFormAreForTheDaemonToJudge) {
  EXPECT_EQ(arguments("GET", "/axes/x/load"), R"({"axis":"x"})");
  EXPECT_EQ(arguments("GET", "/pdos", {{"all", "perhaps"}}), R"({"all":"perhaps"})");
  EXPECT_EQ(value_of(control::Form::Number, "1e3"), json(1000.0));
  EXPECT_EQ(value_of(control::Form::Integer, "1.5"), json("1.5"));
}

TEST(Arguments, ThatTheResourceDoesNotHaveAreRefused) {
  EXPECT_EQ(arguments("GET", "/explain", {{"axle", "1"}}),
            R"("axle": no such parameter in the query, known are axis)");
  EXPECT_EQ(arguments("GET", "/explain", {{"unit", "vcan0/7"}}),
            R"("unit": no such parameter in the query, known are axis)");
  EXPECT_EQ(arguments("GET", "/nmt", {{"a", ""}}), R"("a": no such parameter in the query, it takes none)");
  EXPECT_EQ(arguments("GET", "/explain", {{"axis", "1"}, {"axis", "2"}}), R"("axis": is there twice)");
  EXPECT_EQ(arguments("PUT", "/supply", {}, R"({"unit": "vcan0/7"})"),
            R"("unit": no such member of the body, known are line_voltage_V)");
  EXPECT_EQ(arguments("PUT", "/axes/1/load", {}, R"({"axis": 2})"),
            R"("axis": no such member of the body, known are torque_Nm, type)");
  EXPECT_EQ(arguments("GET", "/pdos", {{"watch", "true"}}),
            R"("watch": no such parameter in the query, known are axis, direction, all, from, count)");
}

TEST(Arguments, BodyIsAnObject) {
  for (const std::string body : {"[]", "5", "{", "\"x\"", "{\"a\":[[[[[[[[[[1]]]]]]]]]]}"})
    EXPECT_EQ(arguments("PUT", "/supply", {}, body),
              "the body: expected a JSON object, nested at most eight levels deep")
        << body;
}

}  // namespace
}  // namespace gateway
