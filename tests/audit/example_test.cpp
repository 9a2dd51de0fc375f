#include <cctype>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "audit/catalogue.hpp"
#include "tests/audit/heard_log.hpp"

namespace audit_test {
namespace {

std::vector<const audit::Rule*> all_rules() {
  std::vector<const audit::Rule*> rules;
  for (const audit::RuleGroup& group : audit::rule_groups())
    rules.insert(rules.end(), group.rules.begin(), group.rules.end());
  return rules;
}

/// @p count frames, one each @p interval seconds.
std::string frames_each(double interval, int count) {
  std::string log;
  for (int i = 0; i < count; ++i) log += fmt::format("({:.6f}) can0 185#0000000000000000\n", i * interval);
  return log;
}

/// The examples that are too long for the docs, at 125 kbit/s: a line that is nearly full for two seconds, and one
/// that has no gap for 60 ms.
std::string long_example(std::string_view rule) {
  return rule == "bus.load" ? frames_each(0.00105, 1900) : frames_each(0.00096, 63);
}

class ExampleTest : public testing::TestWithParam<const audit::Rule*> {};

TEST_P(ExampleTest, BreaksThisRuleAndNoOther) {
  const audit::Rule& rule = *GetParam();
  const std::string example = rule.example.empty() ? long_example(rule.id) : std::string{rule.example};
  EXPECT_EQ(rules_of(findings_of(example, {.bit_rate = 125'000})), std::vector{rule.id});
}

std::string name_of(const testing::TestParamInfo<const audit::Rule*>& info) {
  std::string name{info.param->id};
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Rules, ExampleTest, testing::ValuesIn(all_rules()), name_of);

TEST(Rules, HaveIdsOfTheirOwn) {
  std::set<std::string_view> ids;
  for (const audit::Rule* const rule : all_rules()) {
    EXPECT_TRUE(ids.insert(rule->id).second) << rule->id;
    EXPECT_EQ(audit::find_rule(rule->id), rule);
  }
  EXPECT_GE(ids.size(), 50u);
}

TEST(Rules, BeginWithTheWordOfTheirGroup) {
  for (const audit::RuleGroup& group : audit::rule_groups())
    for (const audit::Rule* const rule : group.rules)
      EXPECT_TRUE(rule->id.starts_with(std::string{group.word} + ".")) << rule->id;
}

}  // namespace
}  // namespace audit_test
