// What a client of the control socket that is an operator panel is told, and what a person who looks at an axis.
#include <algorithm>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using namespace std::chrono_literals;
using control::ErrorCode;

class APanel : public ControlledUnit {
 protected:
  const json kAxis{{"axis", 1}};

  json set(bool on, double rpm) { return result_of("panel.set", {{"axis", 1}, {"on", on}, {"speed_rpm", rpm}}); }
  double speed() { return result_of("status").at("axes").at(0).at("speed_rpm").get<double>(); }
};

TEST_F(APanel, TakesTheControlTurnsTheAxisAndGivesItBack) {
  json told = result_of("panel.get", kAxis);
  EXPECT_EQ(told, (json{{"axis", 1},
                        {"active", false},
                        {"on", false},
                        {"speed_rpm", 0.0},
                        {"timeout_ms", 0},
                        {"remaining_ms", 0},
                        {"state", "Switch on disabled"}}));

  told = result_of("panel.take", kAxis);
  EXPECT_EQ(told.at("active"), true);
  EXPECT_EQ(told.at("timeout_ms"), 1000);
  EXPECT_EQ(told.at("remaining_ms"), 1000);
  for (int i = 0; i < 40; ++i) {
    set(true, 300.0);
    run(100ms);
  }
  EXPECT_NEAR(speed(), 300.0, 1.0);
  told = result_of("panel.get", kAxis);
  EXPECT_EQ(told.at("state"), "Operation enabled");
  EXPECT_EQ(told.at("on"), true);
  EXPECT_NEAR(told.at("speed_rpm").get<double>(), 300.0, 1e-9);
  EXPECT_NEAR(told.at("remaining_ms").get<double>(), 900.0, 5.0);
  EXPECT_EQ(result_of("status").at("axes").at(0).at("setpoint_rpm").get<double>(), 300.0);

  EXPECT_EQ(result_of("panel.release", kAxis).at("remaining_ms"), 0);
  run(10ms);
  EXPECT_EQ(result_of("panel.get", kAxis).at("state"), "OFF1 braking");
  EXPECT_EQ(error_of("panel.set", {{"axis", 1}, {"on", true}, {"speed_rpm", 1}}).code, ErrorCode::Refused);
  run(10s);
  EXPECT_EQ(result_of("panel.get", kAxis).at("active"), false);
  EXPECT_EQ(error_of("panel.release", kAxis).message, "no operator panel has the control");
}

TEST_F(APanel, ThatIsSilentLosesTheControlInTheTimeOfTheUnit) {
  result_of("panel.take", {{"axis", 1}, {"timeout_ms", 100}});
  set(true, 300.0);
  run(90ms);
  EXPECT_EQ(result_of("panel.get", kAxis).at("state"), "Operation enabled");
  run(20ms);
  EXPECT_EQ(result_of("panel.get", kAxis).at("state"), "OFF1 braking");
  run(10s);
  EXPECT_EQ(result_of("panel.get", kAxis).at("active"), false);
  EXPECT_EQ(error_of("panel.set", {{"axis", 1}, {"on", true}, {"speed_rpm", 1}}).message,
            "no operator panel has the control: take it first (panel.take)");
}

TEST_F(APanel, IsRefusedWithTheReason) {
  result_of("panel.take", kAxis);
  control::Error error = error_of("panel.take", kAxis);
  EXPECT_EQ(error.code, ErrorCode::Refused);
  EXPECT_TRUE(error.message.starts_with("an operator panel has the control (r0807 = 1)")) << error.message;
  EXPECT_EQ(result_of("panel.get", kAxis).at("refusal"), error.message);
  result_of("panel.release", kAxis);
  run(20ms);

  result_of("parameter.write", {{"parameter", "1/p0806"}, {"value", 1}});
  EXPECT_EQ(error_of("panel.take", kAxis).message, "master control is inhibited (p0806 = 1)");
  result_of("parameter.write", {{"parameter", "1/p0806"}, {"value", 0}});

  for (const char* const controlword : {"06", "07", "0F"}) {
    answer(std::string{"605#2B406000"} + controlword + "000000");
    run(20ms);
  }
  EXPECT_EQ(error_of("panel.take", kAxis).message,
            "the axis is in operation under the control of another: switch it off there first");
  EXPECT_EQ(error_of("panel.take", {{"axis", 2}}).code, ErrorCode::BadParameter);
}

TEST_F(APanel, IsExplainedInPlaceOfTheBus) {
  result_of("panel.take", kAxis);
  run(10ms);
  const json reasons = result_of("explain", kAxis).at("reasons");
  ASSERT_EQ(reasons.size(), 2U) << reasons;
  EXPECT_TRUE(reasons[0].get<std::string>().starts_with("The control is with an operator panel (r0807 = 1)"));
  EXPECT_EQ(reasons[1], "ON is missing (by the operator panel): switch it on at the panel.");
}

TEST_F(APanel, StatesOfAnAxisAreShownWithWhatTheyNeed) {
  const json machine = result_of("state.machine", kAxis);
  EXPECT_EQ(machine.at("state"), "Switch on disabled");
  EXPECT_EQ(machine.at("states").size(), 10U);
  const auto way = std::ranges::find_if(machine.at("transitions"),
                                        [](const json& transition) { return transition.value("number", 0) == 2; });
  ASSERT_NE(way, machine.at("transitions").end());
  EXPECT_EQ(way->at("to"), "Ready to switch on");
  EXPECT_EQ(way->at("is_open"), false);
  const json& off2 = way->at("conditions").at(1);
  EXPECT_EQ(off2, (json{{"text", "OFF2 is not given (p0844 = r8890.1)"}, {"met", false}, {"parameter", "p0844"}}));
}

TEST_F(APanel, MeasurementsAreShownWithTheirSelection) {
  EXPECT_EQ(result_of("identification.get", kAxis).at("phase"), "idle");
  result_of("parameter.write", {{"parameter", "1/p1910"}, {"value", 1}});
  const json told = result_of("identification.get", kAxis);
  EXPECT_EQ(told.at("phase"), "waiting");
  EXPECT_EQ(told.at("selected"), "standstill (p1910)");
  EXPECT_EQ(told.at("results"), json::array());
}

}  // namespace
}  // namespace axisd
