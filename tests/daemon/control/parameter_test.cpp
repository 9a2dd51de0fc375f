// Parameters over the control socket: what is read is what a master reads, and what a master may not write nobody
// may.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

constexpr const char* kOn = "605#2B40600006000000";
constexpr const char* kSwitchOn = "605#2B40600007000000";
constexpr const char* kEnable = "605#2B4060000F000000";

struct ParameterMethods : ControlledUnit {
  /// The entry of one parameter.
  json entry(const std::string& name, const json& axis = nullptr) {
    return result_of("parameter.read", {{"axis", axis}, {"parameters", {name}}}).at("parameters").at(0);
  }
  json value(const std::string& name, const json& axis = nullptr) { return entry(name, axis).at("value"); }
  json write(const std::string& name, const json& to, const json& axis = nullptr) {
    return result_of("parameter.write", {{"axis", axis}, {"parameter", name}, {"value", to}});
  }
  control::Error refusal(const std::string& name, const json& to, const json& axis = nullptr) {
    return error_of("parameter.write", {{"axis", axis}, {"parameter", name}, {"value", to}});
  }
};

TEST_F(ParameterMethods, ReadWhatAParameterIsAndWhatItMayBe) {
  const json ramp = entry("p1120");

  EXPECT_EQ(ramp.at("axis"), 1);
  EXPECT_EQ(ramp.at("drive_object"), 2);
  EXPECT_EQ(ramp.at("parameter"), "p1120");
  EXPECT_EQ(ramp.at("number"), 1120);
  EXPECT_EQ(ramp.at("index"), 0);
  EXPECT_EQ(ramp.at("value"), 10.0);
  EXPECT_EQ(ramp.at("factory"), 10.0);
  EXPECT_EQ(ramp.at("unit"), "s");
  EXPECT_EQ(ramp.at("type"), "F32");
  EXPECT_EQ(ramp.at("minimum"), 0.0);
  EXPECT_EQ(ramp.at("maximum"), 999999.0);
  EXPECT_EQ(ramp.at("access"), "read-write");
  EXPECT_EQ(ramp.at("writable"), true);
  EXPECT_EQ(ramp.at("differs_from_factory"), false);
  EXPECT_EQ(ramp.at("differs_from_stored"), false);
  EXPECT_FALSE(ramp.contains("stored")) << "nothing was saved yet";
}

TEST_F(ParameterMethods, ReadSeveralAtOnceFromWhereTheyAre) {
  const json result =
      result_of("parameter.read", {{"parameters", {"p1120", "0/r0722", "P0728", "8620", "1/r0063"}}});

  ASSERT_EQ(result.at("parameters").size(), 5U);
  EXPECT_EQ(result.at("parameters").at(1).at("axis"), 0);
  EXPECT_EQ(result.at("parameters").at(2).at("parameter"), "p0728");
  EXPECT_EQ(result.at("parameters").at(3).at("value"), 5);
  EXPECT_EQ(result.at("parameters").at(4).at("access"), "read-only");
}

TEST_F(ParameterMethods, ReadTheValueThatAMasterReads) {
  EXPECT_EQ(write("p1121", 12.5).at("value"), 12.5);
  write("p8630[0]", 2);
  EXPECT_EQ(answer("605#4061240000000000"), Lines{"585#4361240000004841"}) << "12.5 as REAL32";
}

TEST_F(ParameterMethods, ReadBitsOfAParameter) {
  result_of("input.set", {{"input", 3}, {"state", true}});
  run(std::chrono::milliseconds{8});

  EXPECT_EQ(value("r0722"), 8);
  EXPECT_EQ(value("r0722.3"), 1);
  EXPECT_EQ(value("r0722.2"), 0);
  EXPECT_EQ(error_of("parameter.read", {{"parameters", {"r0722.32"}}}).message,
            "r0722.32: it has the bits 0 to 31");
  EXPECT_EQ(error_of("parameter.read", {{"parameters", {"p1120.0"}}}).code, ErrorCode::NotFound);
}

TEST_F(ParameterMethods, NameTheDriveObjectsThatHaveAParameter) {
  switch_on(unit_of(2));

  const control::Error error = error_of("parameter.read", {{"parameters", {"p1120"}}});

  EXPECT_EQ(error.code, ErrorCode::BadParameter);
  EXPECT_EQ(error.message, "p1120: axis 1, axis 2 have it: say which by axis, or as in 1/p1120");
  EXPECT_EQ(error.details.at("axes"), json::array({1, 2}));
  EXPECT_EQ(entry("p1120", 2).at("axis"), 2);
  EXPECT_EQ(entry("2/p1120").at("drive_object"), 3);
}

TEST_F(ParameterMethods, RefuseWhatThereIsNot) {
  EXPECT_EQ(error_of("parameter.read", {{"parameters", {"p9999"}}}).code, ErrorCode::NotFound);
  EXPECT_EQ(error_of("parameter.read", {{"axis", 0}, {"parameters", {"p1120"}}}).message,
            "p1120: the control unit has no such parameter");
  EXPECT_EQ(error_of("parameter.read", {{"parameters", {"p1120[1]"}}}).message, "p1120[1]: it has no indices");
  EXPECT_EQ(error_of("parameter.read", {{"axis", 1}, {"parameters", {"p8700[3]"}}}).code, ErrorCode::NotFound);
  EXPECT_EQ(error_of("parameter.read", {{"axis", 2}, {"parameters", {"p1120"}}}).message,
            "axis: expected 0 for the control unit or an axis 1 to 1, got 2");
  EXPECT_EQ(error_of("parameter.read", {{"axis", "infeed"}, {"parameters", {"p0840"}}}).code,
            ErrorCode::BadParameter);
  for (const char* const text : {"", "p", "x1120", "p1120[", "p1120[0", "p1120.", "/p1120", "1/", "p1120 ", "-1"})
    EXPECT_EQ(error_of("parameter.read", {{"parameters", {text}}}).code, ErrorCode::BadParameter) << text;
  EXPECT_EQ(error_of("parameter.read", {{"parameters", json::array()}}).message,
            "parameters: expected a list of 1 to 32 parameters, got []");
}

TEST_F(ParameterMethods, WriteNumbersInTheWaysPeopleWriteThem) {
  EXPECT_EQ(write("p1120", 2).at("value"), 2.0);
  EXPECT_EQ(write("p1120", "2.5").at("value"), 2.5);
  EXPECT_EQ(write("p1120", "1e1").at("value"), 10.0);
  EXPECT_EQ(write("p0728", "0x100").at("value"), 0x100);
  EXPECT_EQ(write("p0728", "200h").at("value"), 0x200);
  EXPECT_EQ(write("p0728", "0b10000000000").at("value"), 0x400);
  EXPECT_EQ(write("p0728.8", true).at("value"), 1);
  EXPECT_EQ(value("p0728"), 0x500) << "one bit only";
  EXPECT_EQ(write("p0728.10", 0).at("value"), 0);
  EXPECT_EQ(value("p0728"), 0x100);
  EXPECT_EQ(refusal("p0728.10", 2).message, "value: expected 0 or 1, got 2");
  for (const json& none : {json("ten"), json("nan"), json("inf"), json(""), json::array(), json::object()})
    EXPECT_EQ(refusal("p1120", none).code, ErrorCode::BadParameter) << none;
}

TEST_F(ParameterMethods, ConnectAnInputBySayingWhatItTakes) {
  EXPECT_EQ(write("p0844", "r0722.3 of drive object 1").at("value"), "r0722.3 of drive object 1");

  const json input = entry("p0844");
  EXPECT_EQ(input.at("source").at("axis"), 0);
  EXPECT_EQ(input.at("source").at("parameter"), "r0722.3");
  EXPECT_EQ(input.at("source").at("value"), 0);
  const json output = entry("r0722");
  EXPECT_EQ(output.at("uses"), 1);
  EXPECT_EQ(output.at("used_by"), json::array({{{"axis", 1}, {"parameter", "p0844"}, {"position", 3}}}));
  EXPECT_EQ(write("p0844", 1).at("value"), "1");
  EXPECT_EQ(refusal("p0844", "r0063").code, ErrorCode::OutOfRange) << "no bits";
  EXPECT_EQ(refusal("p0844", "r0722,3").code, ErrorCode::BadParameter);
}

TEST_F(ParameterMethods, RefuseWhatIsBeyondTheLimitsAndNameThem) {
  const control::Error error = refusal("p1120", 1e6);

  EXPECT_EQ(error.code, ErrorCode::OutOfRange);
  EXPECT_EQ(error.message, "p1120: above the maximum of 999999 s");
  EXPECT_EQ(error.details.at("limits"), (json{{"minimum", 0.0}, {"maximum", 999999.0}, {"unit", "s"}}));
  EXPECT_EQ(error.details.at("abort_code"), 0x06090031);
  EXPECT_EQ(refusal("p1300", 20.5).code, ErrorCode::OutOfRange) << "no integer";
}

TEST_F(ParameterMethods, RefuseWhatIsNeverOrNotNowWritten) {
  EXPECT_EQ(refusal("r0063", 1).code, ErrorCode::ReadOnly);

  const control::Error error = refusal("p0304", 400);
  EXPECT_EQ(error.code, ErrorCode::ReadOnly);
  EXPECT_EQ(error.message, "p0304: can only be written with p0010 = 3 or 1");
  EXPECT_EQ(error.details.at("when"), "C(1,3)");
  EXPECT_EQ(entry("p0304").at("writable"), false);
  EXPECT_EQ(entry("p0304").at("refusal"), "can only be written with p0010 = 3 or 1");

  write("p0010", 1);
  EXPECT_EQ(entry("p0304").at("writable"), true);
}

TEST_F(ParameterMethods, RefuseWhatIsNotWrittenWhileTheMotorRuns) {
  answer("000#0105");
  for (const char* const controlword : {kOn, kSwitchOn, kEnable}) {
    answer(controlword);
    run(std::chrono::milliseconds{500});
  }
  ASSERT_EQ(result_of("status").at("axes").at(0).at("state"), "Operation enabled");

  const control::Error error = refusal("p0010", 1);
  EXPECT_EQ(error.code, ErrorCode::ReadOnly);
  EXPECT_EQ(error.message, "p0010: cannot be written while the pulses are enabled");
  EXPECT_EQ(write("p1120", 3).at("value"), 3.0) << "U, T";
}

TEST_F(ParameterMethods, CarryACommandOutWithItsConsequences) {
  write("p1120", 3);
  EXPECT_EQ(refusal("p0976", 1).code, ErrorCode::ReadOnly);
  write("p0009", 30);
  write("p0976", 1);  // factory values
  run(std::chrono::milliseconds{8});

  EXPECT_EQ(value("p1120"), 10.0);
}

TEST_F(ParameterMethods, KnowWhatWasStored) {
  write("p1120", 3);
  EXPECT_EQ(entry("p1120").at("differs_from_stored"), true) << "the next power-on would not have it";

  write("p0977", 1);
  EXPECT_EQ(refusal("p1120", 4).code, ErrorCode::Busy) << "while the file is written";
  await_write();

  EXPECT_EQ(entry("p1120").at("differs_from_stored"), false);
  EXPECT_EQ(entry("p1120").at("stored"), 3.0);
  EXPECT_EQ(entry("p1120").at("differs_from_factory"), true);
  write("p1120", 4);
  EXPECT_EQ(entry("p1120").at("differs_from_stored"), true);
  switch_on(unit_of(1));
  EXPECT_EQ(value("p1120"), 3.0);
}

TEST_F(ParameterMethods, TellWhatTheConfigurationLaysOverAParameter) {
  Configuration configuration = unit_of(1);
  configuration.axes.front().parameters.push_back({1120, 7.0, 0});
  switch_on(configuration);

  EXPECT_EQ(entry("p1120").at("preset"), 7.0);
  EXPECT_EQ(value("p1120"), 7.0);
}

}  // namespace
}  // namespace axisd
