#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"

/// The table of docs/reference/deviations.md that tools read: its form, and that it speaks of objects that the
/// unit has.
namespace eds_test {
namespace {

const std::vector<std::string> kColumns{"id", "clause", "object", "standard says", "unit does", "source"};

using Row = std::vector<std::string>;

/// The cells of a line of a pipe table, without the space around them.
Row cells_of(const std::string& line) {
  Row cells;
  for (std::size_t at = 1; at < line.size();) {
    const std::size_t bar = std::min(line.find('|', at), line.size());
    const std::string cell = line.substr(at, bar - at);
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    at = bar + 1;
  }
  return cells;
}

/// The lines of the table, its header first, found as the page tells a tool to find it.
std::vector<Row> table() {
  std::istringstream page{read_file(std::string{SOURCE_FOLDER} + "/docs/reference/deviations.md")};
  std::vector<Row> rows;
  for (std::string line; std::getline(page, line);) {
    if (rows.empty() && !line.starts_with("| id |")) continue;
    if (!line.starts_with('|')) break;
    rows.push_back(cells_of(line));
  }
  return rows;
}

/// The deviations alone, without header and rule.
std::vector<Row> deviations() {
  std::vector<Row> rows = table();
  rows.erase(rows.begin(), rows.begin() + std::min<std::ptrdiff_t>(2, std::ssize(rows)));
  return rows;
}

/// What "1400h-15C7h:01-02" says; a single number is a range of one.
struct Place {
  unsigned first_index, last_index;
  bool names_sub_indices;
  unsigned first_sub, last_sub;
};

Place parse_place(const std::string& text) {
  static const std::regex form{"([0-9A-F]{4})h(-([0-9A-F]{4})h)?(:([0-9A-F]{2})(-([0-9A-F]{2}))?)?"};
  std::smatch found;
  if (!std::regex_match(text, found, form)) throw std::runtime_error{text + ": no object"};
  const auto hex = [&](std::size_t group, std::size_t otherwise) {
    const std::string digits = found[found[group].matched ? group : otherwise].str();
    return digits.empty() ? 0U : static_cast<unsigned>(std::stoul(digits, nullptr, 16));
  };
  return {hex(1, 1), hex(3, 1), found[4].matched, hex(5, 5), hex(7, 5)};
}

std::vector<Place> places_of(const Row& row) {
  std::vector<Place> places;
  if (row.at(2) == "-") return places;
  const std::string text = row.at(2) + ", ";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t comma = text.find(", ", at);
    places.push_back(parse_place(text.substr(at, comma - at)));
    at = comma + 2;
  }
  return places;
}

bool is_manufacturer_specific(unsigned index) {
  return index >= 0x2000 && index < 0x6000;
}

/// Whether the unit of eight axes has the object; with @p sub_index, whether it has that entry.
bool exists(unsigned index, std::optional<unsigned> sub_index) {
  std::ostringstream section;
  section << std::uppercase << std::hex << index;
  const EdsFile& unit = generated_eds("axisd-8-axes.eds");
  if (!sub_index) return unit.contains(section.str());
  return find_entry(unit, static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(*sub_index)) != nullptr;
}

TEST(Deviations, HaveTheColumnsThatThePagePromises) {
  const std::vector<Row> rows = table();

  ASSERT_GE(rows.size(), 3U);
  EXPECT_EQ(rows.front(), kColumns);
}

TEST(Deviations, FillEveryColumn) {
  for (const Row& row : deviations()) {
    ASSERT_EQ(row.size(), kColumns.size()) << row.front();
    for (const std::string& cell : row) EXPECT_NE(cell, "") << row.front();
  }
}

TEST(Deviations, HaveAnIdOfTheirOwn) {
  static const std::regex form{"D(301|402)-[0-9]{2}"};
  std::set<std::string> ids;

  for (const Row& row : deviations()) {
    EXPECT_TRUE(std::regex_match(row.at(0), form)) << row.at(0);
    EXPECT_TRUE(ids.insert(row.at(0)).second) << row.at(0) << " stands there twice";
  }
}

TEST(Deviations, NameAClauseOfTheStandardOfTheirId) {
  static const std::regex clause_301{"CiA 301( [0-9]+(\\.[0-9]+)+)"};
  static const std::regex clause_402{"CiA 402-[23] ([0-9A-F]{4}h|FSA)"};

  for (const Row& row : deviations()) {
    const std::regex& form = row.at(0).starts_with("D301") ? clause_301 : clause_402;
    EXPECT_TRUE(std::regex_match(row.at(1), form)) << row.at(0) << ": " << row.at(1);
  }
}

TEST(Deviations, SpeakOfObjectsThatTheUnitHas) {
  for (const Row& row : deviations())
    for (const Place& place : places_of(row)) {
      EXPECT_LE(place.first_index, place.last_index) << row.at(0);
      EXPECT_LE(place.first_sub, place.last_sub) << row.at(0);
      for (const unsigned index : {place.first_index, place.last_index}) {
        if (is_manufacturer_specific(index)) continue;
        EXPECT_TRUE(exists(index, std::nullopt)) << row.at(0) << ": " << std::hex << index;
        if (!place.names_sub_indices) continue;
        EXPECT_TRUE(exists(index, place.first_sub)) << row.at(0) << ": " << row.at(2);
        EXPECT_TRUE(exists(index, place.last_sub)) << row.at(0) << ": " << row.at(2);
      }
    }
}

}  // namespace
}  // namespace eds_test
