#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/eds/eds_reader.hpp"

/// The facts of the real unit (data/objects.csv) against the EDS, without a word of the catalogue in between.
namespace eds_test {
namespace {

constexpr std::string_view kColumns =
    "scope,index,sub,object,type,access,pdo_mappable,default,low,high,obj_flags,name";
constexpr std::int64_t kAnyNode = 5;

using Fact = std::map<std::string, std::string>;

std::vector<std::string> split(std::string line) {
  std::vector<std::string> cells;
  line += ',';
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t comma = line.find(',', at);
    cells.push_back(line.substr(at, comma - at));
    at = comma + 1;
  }
  return cells;
}

std::vector<Fact> read_facts() {
  std::istringstream text{read_file(std::string{SOURCE_FOLDER} + "/tests/eds/data/objects.csv")};
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, kColumns);
  const std::vector<std::string> names = split(line);
  std::vector<Fact> facts;
  while (std::getline(text, line)) {
    const std::vector<std::string> cells = split(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    Fact& fact = facts.emplace_back();
    for (std::size_t n = 0; n < names.size() && n < cells.size(); ++n) fact[names[n]] = cells[n];
  }
  return facts;
}

unsigned hexadecimal(const std::string& text) {
  return static_cast<unsigned>(std::stoul(text, nullptr, 16));
}

const std::map<std::string, std::int64_t> kTypes{{"INTEGER8", 2},      {"INTEGER16", 3},  {"INTEGER32", 4},
                                                 {"UNSIGNED8", 5},     {"UNSIGNED16", 6}, {"UNSIGNED32", 7},
                                                 {"VISIBLE_STRING", 9}};
const std::map<std::string, std::int64_t> kObjects{{"VAR", 7}, {"ARRAY", 8}, {"RECORD", 9}};

/// The same value, however it is written; an empty cell means that the EDS has no such key.
void expect_value(const Section& section, const std::string& key, const std::string& fact) {
  const auto found = section.find(key);
  ASSERT_EQ(found != section.end(), !fact.empty()) << key;
  if (fact.empty()) return;
  EXPECT_EQ(fact.starts_with("$NODEID"), found->second.starts_with("$NODEID")) << key;
  const auto wanted = number(fact, kAnyNode);
  if (wanted) {
    EXPECT_EQ(number(found->second, kAnyNode), wanted) << key;
  } else {
    EXPECT_EQ(found->second, fact) << key;
  }
}

void expect_entry(const Section& section, const Fact& fact) {
  EXPECT_EQ(section.at("ParameterName"), fact.at("name"));
  EXPECT_EQ(number_at(section, "DataType"), kTypes.at(fact.at("type")));
  EXPECT_EQ(section.at("AccessType"), fact.at("access"));
  EXPECT_EQ(section.at("PDOMapping"), fact.at("pdo_mappable") == "yes" ? "1" : "0");
  expect_value(section, "DefaultValue", fact.at("default"));
  expect_value(section, "LowLimit", fact.at("low"));
  expect_value(section, "HighLimit", fact.at("high"));
  expect_value(section, "ObjFlags", fact.at("obj_flags"));
}

TEST(FactsOfTheUnit, AreWhatTheEdsSays) {
  for (const Fact& fact : read_facts()) {
    SCOPED_TRACE(fact.at("index") + ":" + fact.at("sub"));
    const bool head = fact.at("sub").empty();
    const auto index = static_cast<std::uint16_t>(hexadecimal(fact.at("index")));
    if (head) {
      const auto object = generated_eds().find(fact.at("index"));
      ASSERT_NE(object, generated_eds().end());
      EXPECT_EQ(number_at(object->second, "ObjectType"), kObjects.at(fact.at("object")));
      EXPECT_EQ(object->second.at("ParameterName"), fact.at("name"));
      continue;
    }
    const Section* const entry =
        find_entry(generated_eds(), index, static_cast<std::uint8_t>(hexadecimal(fact.at("sub"))));
    ASSERT_NE(entry, nullptr);
    expect_entry(*entry, fact);
  }
}

TEST(FactsOfTheUnit, CoverEveryObjectAndEntryOfTheEds) {
  const auto sections = std::ranges::count_if(generated_eds(), [](const auto& section) {
    return section.second.find("ObjectType") != section.second.end();
  });

  EXPECT_EQ(static_cast<std::size_t>(sections), read_facts().size());
}

}  // namespace
}  // namespace eds_test
