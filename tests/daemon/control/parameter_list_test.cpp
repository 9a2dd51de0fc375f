// Lists of parameters over the control socket: in pages that a line has room for, complete, and what they leave
// out.
#include <set>

#include <gtest/gtest.h>

#include "control/protocol.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct ParameterLists : ControlledUnit {
  /// All entries that @p method has, page by page.
  std::vector<json> all(const char* method, json params) {
    std::vector<json> entries;
    for (bool more = true; more;) {
      const json result = result_of(method, params);
      EXPECT_LE(control::result_line(1, result).size(), control::kMaximumLine) << params;
      for (const json& entry : result.at("parameters")) entries.push_back(entry);
      more = result.contains("next");
      if (more) params["from"] = result.at("next");
    }
    return entries;
  }
  static std::vector<std::string> names(const std::vector<json>& entries) {
    std::vector<std::string> names;
    for (const json& entry : entries) names.push_back(entry.at("parameter"));
    return names;
  }
  void write(const char* name, const json& value, const json& axis = nullptr) {
    result_of("parameter.write", {{"axis", axis}, {"parameter", name}, {"value", value}});
  }
};

TEST_F(ParameterLists, HaveEveryParameterOfADriveObject) {
  Configuration configuration = unit_of(8);
  configuration.infeed.emplace();
  switch_on(configuration);

  for (const json& place : {json(0), json("infeed"), json(1), json(8)}) {
    const std::vector<json> entries = all("parameter.list", {{"axis", place}});
    ASSERT_FALSE(entries.empty()) << place;
    EXPECT_EQ(entries.size(), result_of("parameter.list", {{"axis", place}}).at("total"));
    std::set<std::string> names;
    for (const json& entry : entries) {
      EXPECT_EQ(entry.at("axis"), place);
      names.insert(entry.at("parameter").get<std::string>());
    }
    EXPECT_EQ(names.size(), entries.size()) << "each once";
  }
}

TEST_F(ParameterLists, OfANewUnitHaveNoDifferences) {
  EXPECT_EQ(names(all("parameter.diff", {})), Lines{});
  EXPECT_EQ(names(all("parameter.diff", {{"against", "stored"}})), Lines{});
  EXPECT_EQ(result_of("parameter.diff", {{"against", "stored"}}).at("is_stored"), false);
}

TEST_F(ParameterLists, TellWhatDiffersFromANewUnitAndFromWhatWasStored) {
  write("p1120", 3);
  write("p0728", 0x100);
  write("p0977", 1);
  await_write();
  write("p1121", 4);

  EXPECT_EQ(names(all("parameter.diff", {})), (Lines{"p0728", "p1120", "p1121"}));
  const std::vector<json> unsaved = all("parameter.diff", {{"against", "stored"}});
  ASSERT_EQ(names(unsaved), Lines{"p1121"});
  EXPECT_EQ(unsaved.front().at("value"), 4.0);
  EXPECT_EQ(unsaved.front().at("reference"), 10.0);
  EXPECT_EQ(names(all("parameter.list", {{"axis", 1}, {"filter", "changed"}})), (Lines{"p1120", "p1121"}));
  EXPECT_EQ(names(all("parameter.list", {{"axis", 1}, {"filter", "unsaved"}})), Lines{"p1121"});
  EXPECT_EQ(names(all("parameter.diff", {{"axis", 0}})), Lines{"p0728"});

  switch_on(unit_of(1));
  EXPECT_EQ(names(all("parameter.diff", {{"against", "stored"}})), Lines{});
  EXPECT_EQ(names(all("parameter.diff", {})), (Lines{"p0728", "p1120"}));
}

TEST_F(ParameterLists, OfBicoInputsTellWhatEachTakes) {
  const std::vector<json> inputs = all("parameter.list", {{"axis", 1}, {"filter", "inputs"}});

  ASSERT_GT(inputs.size(), 20U);
  for (const json& input : inputs) {
    EXPECT_TRUE(input.at("value").is_string());
    EXPECT_EQ(input.contains("source"), input.at("value") != "0" && input.at("value") != "1") << input;
  }
}

TEST_F(ParameterLists, OfWhatCanBeWrittenChangeWithTheState) {
  const std::size_t before = all("parameter.list", {{"axis", 1}, {"filter", "writable"}}).size();

  write("p0010", 1);

  EXPECT_NE(all("parameter.list", {{"axis", 1}, {"filter", "writable"}}).size(), before);
}

TEST_F(ParameterLists, AreSearchedByNumberAndByWords) {
  const auto by_number = names(all("parameter.search", {{"text", "p112"}}));
  ASSERT_FALSE(by_number.empty());
  for (const std::string& name : by_number) EXPECT_TRUE(name.starts_with("p112")) << name;
  EXPECT_EQ(by_number.front(), "p1120");

  const std::vector<json> by_words = all("parameter.search", {{"text", "RAMP-UP time"}});
  ASSERT_FALSE(by_words.empty());
  EXPECT_EQ(by_words.front().at("parameter"), "p1120");
  EXPECT_EQ(by_words.front().at("axes"), json::array({1}));
  EXPECT_EQ(names(all("parameter.search", {{"text", "no such words at all"}})), Lines{});
  EXPECT_EQ(all("parameter.search", {{"axis", 1}, {"text", "1120"}}).front().at("value"), 10.0);
}

TEST_F(ParameterLists, RefuseWhatIsNoPage) {
  EXPECT_EQ(error_of("parameter.list", {{"axis", 1}, {"count", 0}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("parameter.list", {{"axis", 1}, {"from", -1}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("parameter.list", {{"axis", 1}, {"filter", "odd"}}).message,
            "filter: expected all, changed, unsaved, writable, inputs or outputs, got \"odd\"");
  EXPECT_EQ(error_of("parameter.list").code, ErrorCode::BadParameter);
  EXPECT_TRUE(result_of("parameter.list", {{"axis", 1}, {"from", 1000000}}).at("parameters").empty());
}

}  // namespace
}  // namespace axisd
