#include "tests/tools/canopen-audit/audit_run.hpp"

namespace audit_tool_test {
namespace {

using nlohmann::json;

json known(const char* rule) {
  return {{"rule", rule}, {"reason", "it is so"}, {"source", "its manual"}};
}

class CanopenAuditKnown : public AuditRun {
 protected:
  /// A run over a log with @p text and the known findings @p list.
  fakes::Finished judge(std::string_view text, const std::string& list, bool is_strict = false) const {
    std::vector<std::string> words{"--known", write("known.json", list)};
    if (is_strict) words.emplace_back("--strict");
    return audit(text, std::move(words));
  }
  fakes::Finished judge(std::string_view text, const json& one) const {
    return judge(text, json::array({one}).dump());
  }
};

TEST_F(CanopenAuditKnown, DoNotCount) {
  const fakes::Finished finished = judge(kOverlap, known("sdo.overlap"));
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_NE(finished.output.find("known    sdo.overlap "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find(" [known: it is so]\n"), std::string::npos) << finished.output;
  EXPECT_TRUE(finished.output.ends_with(": no rule is broken, known 1\n")) << finished.output;
}

TEST_F(CanopenAuditKnown, AreThoseOfTheNodeAndTheWordsThatTheyName) {
  json one = known("sdo.overlap");
  one["node"] = 5;
  EXPECT_EQ(judge(kOverlap, one).status, 0);
  one["node"] = 6;
  EXPECT_EQ(judge(kOverlap, one).status, 1);
  one["node"] = 5;
  one["text"] = "no such words";
  EXPECT_EQ(judge(kOverlap, one).status, 1);
}

TEST_F(CanopenAuditKnown, ThatAreNotFoundAreFailures) {
  const fakes::Finished finished = judge(kRight, known("sdo.overlap"));
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.output.find("unseen   sdo.overlap is known (it is so), and was not found\n"),
            std::string::npos)
      << finished.output;
  EXPECT_TRUE(finished.output.ends_with(": no rule is broken, known and not found 1\n")) << finished.output;
}

TEST_F(CanopenAuditKnown, StandForThoseThatAreCountedAloneIfAllThatAreKeptAreKnown) {
  const std::string log = aborts(12);
  json one = known("sdo.abort-alone");
  one["text"] = "protocol timed out";
  const fakes::Finished finished = judge(log, json::array({one}).dump(), true);
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_TRUE(finished.output.ends_with(": no rule is broken, known 12\n")) << finished.output;
}

TEST_F(CanopenAuditKnown, AreAllFoundThatFitOneFinding) {
  json general = known("sdo.abort-alone"), special = general;
  special["node"] = 5;
  const fakes::Finished finished = judge(aborts(1), json::array({general, special}).dump(), true);
  EXPECT_EQ(finished.status, 0) << finished.output;
}

struct BadList {
  const char* name;
  const char* list;
  const char* message;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
void PrintTo(const BadList& bad, std::ostream* out) {
  *out << bad.name;
}

class BadLists : public CanopenAuditKnown, public testing::WithParamInterface<BadList> {};

TEST_P(BadLists, AreRefusedWithPlaceAndWhatWasExpected) {
  const fakes::Finished finished = judge(kRight, std::string{GetParam().list});
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors, std::string{"canopen-audit: known.json: "} + GetParam().message + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    CanopenAuditKnown, BadLists,
    testing::Values(
        BadList{"NoJson", "{", "expected a JSON list of {rule, reason, source}"},
        BadList{"NoList", "{}", "expected a JSON list of {rule, reason, source}"},
        BadList{"NoObject", "[1]", "/0: expected an object, got 1"},
        BadList{"NoRule", R"([{"reason": "r", "source": "s"}])", "/0/rule: expected a text, got nothing"},
        BadList{"UnknownRule", R"([{"rule": "sdo.no-such", "reason": "r", "source": "s"}])",
                "/0/rule: expected a rule (see --list), got \"sdo.no-such\""},
        BadList{"EmptyReason", R"([{"rule": "sdo.overlap", "reason": "", "source": "s"}])",
                "/0/reason: expected a text, got \"\""},
        BadList{"NodeTooHigh", R"([{"rule": "sdo.overlap", "reason": "r", "source": "s", "node": 128}])",
                "/0/node: expected 0 (of no one) or a node-ID to 127, got 128"},
        BadList{"MisspelledKey", R"([{"rule": "sdo.overlap", "reason": "r", "source": "s", "nodes": 5}])",
                "/0: expected rule, reason, source, node or text, got the key \"nodes\""},
        BadList{"NoText", R"([{"rule": "sdo.overlap", "reason": "r", "source": "s", "text": 5}])",
                "/0/text: expected a text, got 5"}),
    [](const testing::TestParamInfo<BadList>& each) { return std::string{each.param.name}; });

}  // namespace
}  // namespace audit_tool_test
