#include <fstream>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

/// "Suite.Name" of every test of this program.
std::set<std::string> tests() {
  std::set<std::string> names;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int test = 0; test < suite.total_test_count(); ++test) {
      names.insert(std::string{suite.name()} + '.' + suite.GetTestInfo(test)->name());
    }
  }
  return names;
}

constexpr const char* kDocument = SOURCE_FOLDER "/docs/reference/cia301.md";

TEST(Cia301Document, NamesTestsThatExist) {
  static const std::regex last_cell{R"(.*\| ([^|]+) \|)"};
  static const std::regex name{R"(`(\w+\.\w+)`)"};
  const std::set<std::string> known = tests();
  std::ifstream file{kDocument};
  int named = 0;

  for (std::string line; std::getline(file, line);) {
    std::smatch cell;
    if (!std::regex_match(line, cell, last_cell)) continue;
    const std::string text = cell[1];
    for (std::sregex_iterator at{text.begin(), text.end(), name}; at != std::sregex_iterator{}; ++at, ++named) {
      EXPECT_TRUE(known.contains((*at)[1])) << (*at)[1];
    }
  }

  EXPECT_GT(named, 100) << "the tables have not been found";
}

TEST(Cia301Document, ProvesEveryRowOrSaysThatNothingIsOffered) {
  static const std::regex row{R"(\| (.+) \| (.+) \| (.*)\|)"};
  std::ifstream file{kDocument};
  int rows = 0;

  for (std::string line; std::getline(file, line);) {
    std::smatch cells;
    if (!std::regex_match(line, cells, row) || cells[3] == "proved by ") continue;
    ++rows;
    const std::string offer = cells[2];
    const bool offered = !offer.starts_with("not offered") && !offer.starts_with("no service");
    EXPECT_EQ(cells[3].length() != 0, offered) << cells[1];
  }

  EXPECT_GT(rows, 100) << "the tables have not been found";
}

TEST(Cia301Document, HasASectionForEveryService) {
  std::ifstream file{kDocument};
  std::set<std::string> sections;
  for (std::string line; std::getline(file, line);) sections.insert(line);

  for (const char* const service :
       {"Object dictionary", "SDO", "NMT and error control", "EMCY", "TIME", "Store and restore", "PDO", "SYNC"}) {
    EXPECT_TRUE(sections.contains(std::string{"## "} + service)) << service;
  }
}

}  // namespace
