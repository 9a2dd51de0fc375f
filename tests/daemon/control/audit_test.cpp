// What a client of the control socket is told of the masters of a unit.
#include <map>
#include <string>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;

class AuditedUnit : public ControlledUnit {
 protected:
  AuditedUnit() {
    Configuration configuration = unit_of(1);
    configuration.audit = true;
    switch_on(configuration);
  }

  /// Rules that were broken, and how often.
  std::map<std::string, int> broken() {
    std::map<std::string, int> rules;
    const json told = result_of("audit.get");
    for (const json& rule : told.at("rules")) rules[rule.at("rule")] = rule.at("times");
    return rules;
  }
};

TEST_F(ControlledUnit, IsNotAuditedUnlessItsConfigurationSaysSo) {
  const control::Error error = error_of("audit.get");
  EXPECT_EQ(error.code, ErrorCode::Refused);
  EXPECT_EQ(error.message, R"(the unit is not audited: expected "audit": true in its configuration)");
}

TEST_F(AuditedUnit, HasNothingAgainstAMasterThatIsRight) {
  ASSERT_FALSE(answer("605#4000100000000000").empty());
  ASSERT_FALSE(answer("605#2B171000E8030000").empty());
  answer("000#0105");
  run(std::chrono::seconds{3});
  const json told = result_of("audit.get");
  EXPECT_EQ(told.at("errors"), 0);
  EXPECT_EQ(told.at("warnings"), 0);
  EXPECT_EQ(told.at("rules"), json::array());
  EXPECT_GT(told.at("frames"), 5);
}

TEST_F(AuditedUnit, TellsTheRuleTheObjectAndTheFrames) {
  answer("605#2300100092010200");
  const json told = result_of("audit.get");
  ASSERT_EQ(told.at("rules").size(), 1U);
  const json rule = told.at("rules").at(0);
  EXPECT_EQ(rule.at("rule"), "object.read-only");
  EXPECT_EQ(rule.at("severity"), "error");
  EXPECT_EQ(rule.at("times"), 1);
  ASSERT_EQ(rule.at("findings").size(), 1U);
  const json finding = rule.at("findings").at(0);
  EXPECT_EQ(finding.at("node"), 5);
  EXPECT_TRUE(finding.at("text").get<std::string>().starts_with("1000h:00 (Device Type)")) << finding;
  ASSERT_EQ(finding.at("frames").size(), 2U);
  EXPECT_TRUE(finding.at("frames").at(0).get<std::string>().ends_with(" can0 605#2300100092010200")) << finding;
  EXPECT_TRUE(finding.at("frames").at(1).get<std::string>().ends_with(" can0 585#8000100002000106")) << finding;
}

TEST_F(AuditedUnit, ShowsTheFirstFindingOfEachRuleAndAllThatAreKeptOfOne) {
  for (int i = 0; i < 12; ++i) answer("605#2300100092010200");
  EXPECT_EQ(result_of("audit.get").at("rules").at(0).at("findings").size(), 1U);
  const json rules = result_of("audit.get", {{"rule", "object.read-only"}}).at("rules");
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules.at(0).at("times"), 12);
  EXPECT_EQ(rules.at(0).at("findings").size(), 10U);
  EXPECT_EQ(result_of("audit.get", {{"rule", "sdo.toggle"}}).at("rules"), json::array());
}

TEST_F(AuditedUnit, KnowsNoOtherRules) {
  const control::Error error = error_of("audit.get", {{"rule", "sdo.nothing"}});
  EXPECT_EQ(error.code, ErrorCode::NotFound);
  EXPECT_EQ(error.message, R"(rule: expected one of those of canopen-audit --list, got "sdo.nothing")");
}

TEST_F(AuditedUnit, JudgesByTheMappingThatWasNeverReadOverTheBus) {
  answer("000#0105");
  run(std::chrono::milliseconds{100});
  answer("205#06");  // RPDO 1 has the controlword, two bytes
  EXPECT_EQ(broken(), (std::map<std::string, int>{{"pdo.short", 1}}));
}

TEST_F(AuditedUnit, DoesNotJudgeWhatIsSaidToOtherNodesWhichItDoesNotHear) {
  answer("000#8109");
  answer("000#0109");
  answer("000#0109");
  for (int i = 0; i < 5; ++i) answer("000#0100");  // as further nodes boot
  answer("000#8100");
  answer("000#0109");
  run(std::chrono::seconds{3});
  EXPECT_EQ(broken(), (std::map<std::string, int>{}));
}

TEST_F(AuditedUnit, MentionsItInWhatItExplains) {
  const auto last_reason = [this] {
    return result_of("explain", {{"axis", 1}}).at("reasons").back().get<std::string>();
  };
  EXPECT_FALSE(last_reason().starts_with("The master")) << last_reason();
  answer("605#2300100092010200");
  EXPECT_EQ(last_reason(),
            "The master has broken rules of CANopen once since the start: axisctl audit shows which.");
  answer("605#2300100092010200");
  EXPECT_EQ(last_reason(),
            "The master has broken rules of CANopen 2 times since the start: axisctl audit shows which.");
}

}  // namespace
}  // namespace axisd
