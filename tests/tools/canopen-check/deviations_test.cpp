#include "tools/canopen-check/core/run/deviations.hpp"

#include <gtest/gtest.h>

namespace conformance_test {
namespace {

using conformance::Check;
using conformance::CheckResult;
using conformance::Deviations;
using conformance::Outcome;

constexpr Check kCheck{.id = "sdo.some-check", .name = "Something is right", .clause = "CiA 301"};

/// The result of kCheck with a finding for each of @p subjects.
CheckResult result_of(std::initializer_list<conformance::Subject> subjects) {
  CheckResult result{.check = &kCheck};
  for (const conformance::Subject& subject : subjects)
    result.findings.push_back({.subject = subject, .expected = "this", .found = "that"});
  if (!result.findings.empty()) result.outcome = Outcome::Failed;
  return result;
}

Outcome judged(const char* list, CheckResult result) {
  tl::expected<Deviations, std::string> deviations = Deviations::parse(list);
  if (!deviations) throw std::runtime_error{deviations.error()};
  deviations->judge(result);
  return result.outcome;
}

constexpr const char* kOfOneObject =
    R"([{"check": "sdo.some-check", "reason": "it is so", "source": "manual", "object": "1003h:01-03"}])";

TEST(Deviations, MakeKnownWhatTheyList) {
  EXPECT_EQ(judged(kOfOneObject, result_of({{0x1003, 2}})), Outcome::Deviates);
}

TEST(Deviations, LeaveOtherObjectsAlone) {
  EXPECT_EQ(judged(kOfOneObject, result_of({{0x1003, 2}, {0x1003, 4}})), Outcome::Failed);
  EXPECT_EQ(judged(kOfOneObject, result_of({{0x1003, 2}, {0x1005, 2}})), Outcome::Failed);
}

TEST(Deviations, ThatAreNotThereAnyMoreAreAFinding) {
  EXPECT_EQ(judged(kOfOneObject, result_of({})), Outcome::Failed);
}

TEST(Deviations, WithoutAnObjectMeanTheWholeCheck) {
  constexpr const char* kWhole = R"([{"check": "sdo.some-check", "reason": "it is so", "source": "manual"}])";
  EXPECT_EQ(judged(kWhole, result_of({{}, {0x1003, 4}})), Outcome::Deviates);
}

TEST(Deviations, OfAnAxisAreThoseOfEveryAxis) {
  constexpr const char* kAxis =
      R"([{"check": "sdo.some-check", "reason": "it is so", "source": "manual", "object": "6060h"}])";
  EXPECT_EQ(judged(kAxis, result_of({{0x6060, 0}, {0x6860, 0}, {0x9860, 0}})), Outcome::Deviates);
  EXPECT_EQ(judged(kAxis, result_of({{0x6861, 0}})), Outcome::Failed);
}

TEST(Deviations, OfOtherChecksDoNotMatter) {
  constexpr const char* kOther = R"([{"check": "sdo.other", "reason": "it is so", "source": "manual"}])";
  EXPECT_EQ(judged(kOther, result_of({})), Outcome::Passed);
  EXPECT_EQ(judged(kOther, result_of({{}})), Outcome::Failed);
}

TEST(Deviations, AreNotMissedInACheckThatWasSkipped) {
  CheckResult skipped{.check = &kCheck, .outcome = Outcome::Skipped, .reason = "object 1003h is not in the EDS"};
  EXPECT_EQ(judged(kOfOneObject, skipped), Outcome::Skipped);
}

struct BadList {
  const char* text;
  const char* message;
};

class BadLists : public testing::TestWithParam<BadList> {};

TEST_P(BadLists, AreRefusedWithAMessageThatSaysWhere) {
  const tl::expected<Deviations, std::string> deviations = Deviations::parse(GetParam().text);
  ASSERT_FALSE(deviations.has_value());
  EXPECT_EQ(deviations.error(), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadLists,
    testing::Values(BadList{"{", "expected a JSON list of {check, reason, source}"},
                    BadList{"{}", "expected a JSON list of {check, reason, source}"},
                    BadList{"[1]", "/0: expected an object, got 1"},
                    BadList{R"([{"check": "a", "reason": "b"}])", "/0/source: expected a text, got nothing"},
                    BadList{R"([{"check": 1, "reason": "b", "source": "c"}])", "/0/check: expected a text, got 1"},
                    BadList{R"([{"check": "a", "reason": "b", "source": "c", "object": "1003"}])",
                            R"(/0/object: expected objects such as "1400h-15C7h:02", got "1003")"}));

}  // namespace
}  // namespace conformance_test
