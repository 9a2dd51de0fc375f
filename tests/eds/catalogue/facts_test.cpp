#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"
#include "tests/eds/rules/objects_csv.hpp"

/// The facts of the real unit and of the CiA 402 device (data/) against the EDS files, without a word of the
/// catalogues in between.
namespace eds_test {
namespace {

constexpr std::int64_t kAnyNode = 5;

const std::map<std::string, std::int64_t> kTypes{{"INTEGER8", 2},  {"INTEGER16", 3},     {"INTEGER32", 4},
                                                 {"UNSIGNED8", 5}, {"UNSIGNED16", 6},    {"UNSIGNED32", 7},
                                                 {"REAL32", 8},    {"VISIBLE_STRING", 9}};
const std::map<std::string, std::int64_t> kObjects{{"VAR", 7}, {"ARRAY", 8}, {"RECORD", 9}};

/// An EDS, and the scopes of the facts of a file that it holds.
struct File {
  const char* name;
  std::vector<std::string> scopes;
  const char* facts = "objects.csv";
};
const File kUnit{"axisd.eds", {"unit", "axis"}};
const File kCia402{"axisd-cia402.eds", {"unit", "axis"}, "cia402-objects.csv"};
const File kFiles[] = {kUnit,
                       {"axisd-control-unit.eds", {"cu-parameter"}},
                       {"axisd-servo.eds", {"servo-parameter"}},
                       {"axisd-vector.eds", {"vector-parameter"}},
                       kCia402};
void PrintTo(const File& file, std::ostream* out) {
  *out << file.name;
}

std::vector<Fact> facts_of(const File& file) {
  std::vector<Fact> facts = read_facts(file.facts);
  std::erase_if(facts, [&](const Fact& fact) { return std::ranges::count(file.scopes, fact.at("scope")) == 0; });
  return facts;
}

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

void expect_head(const EdsFile& file, const Fact& fact) {
  const auto object = file.find(fact.at("index"));
  ASSERT_NE(object, file.end());
  EXPECT_EQ(number_at(object->second, "ObjectType"), kObjects.at(fact.at("object")));
  EXPECT_EQ(object->second.at("ParameterName"), fact.at("name"));
}

class FactsOfTheUnit : public testing::TestWithParam<File> {};

TEST_P(FactsOfTheUnit, AreWhatTheEdsSays) {
  const EdsFile& file = generated_eds(GetParam().name);
  for (const Fact& fact : facts_of(GetParam())) {
    SCOPED_TRACE(fact.at("index") + ":" + fact.at("sub"));
    if (is_head(fact)) {
      expect_head(file, fact);
      continue;
    }
    const Section* const entry = find_entry(file, index_of(fact), sub_index_of(fact));
    ASSERT_NE(entry, nullptr);
    expect_entry(*entry, fact);
  }
}

/// Sections of objects and of their entries.
std::size_t count_sections(const EdsFile& file) {
  return static_cast<std::size_t>(
      std::ranges::count_if(file, [](const auto& section) { return section.second.contains("ObjectType"); }));
}

// Those of the drive objects list more parameters than the vendor's: see served_parameters_test.cpp.
TEST(FactsOfTheWholeUnit, CoverEveryObjectAndEntryOfTheEds) {
  constexpr std::size_t kModules = 1;  // entries of the module list, which the facts do not list

  EXPECT_EQ(count_sections(generated_eds(kUnit.name)), facts_of(kUnit).size() + kModules);
}

TEST(FactsOfTheCia402Device, AreAllThatTheEdsHas) {
  EXPECT_EQ(facts_of(kCia402).size(), 507U);
  EXPECT_EQ(count_sections(generated_eds(kCia402.name)), facts_of(kCia402).size());
}

INSTANTIATE_TEST_SUITE_P(Eds, FactsOfTheUnit, testing::ValuesIn(kFiles), [](const auto& file) {
  std::string name = file.param.name;
  std::erase_if(name, [](char c) { return c == '-' || c == '.'; });
  return name;
});

TEST(FactsOfTheModules, AreThoseOfTheirAxes) {
  const EdsFile& file = generated_eds("axisd-unit.eds");
  std::size_t compared = 0;
  for (const Fact& fact : facts_of({"", {"axis"}})) {
    if (is_head(fact)) continue;
    SCOPED_TRACE(fact.at("index") + ":" + fact.at("sub"));
    const std::string name = "M1Fixed" + fact.at("index");
    const bool variable = !file.at(name).contains("SubNumber");
    const std::string sub = fact.at("sub").front() == '0' ? fact.at("sub").substr(1) : fact.at("sub");
    expect_entry(file.at(variable ? name : name + "sub" + sub), fact);
    ++compared;
  }
  EXPECT_EQ(compared, 237U);
}

}  // namespace
}  // namespace eds_test
