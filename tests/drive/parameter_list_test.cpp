/// The lists of parameters (data/parameters.csv, data/interfaces-parameters.csv) against a unit with a servo and a
/// vector axis.
#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "drive/drive_unit.hpp"
#include "tests/drive/csv.hpp"

namespace drive {
namespace {

using drive_test::CsvRow;

constexpr std::uint8_t kNodeId = 5;
constexpr std::uint8_t kServoAxis = 2;
constexpr std::uint8_t kVectorAxis = 3;

UnitConfiguration servo_and_vector() {
  return {.axes = {{}, {.kind = ObjectKind::Vector}}, .node_id = kNodeId};
}

std::uint16_t number_of(const CsvRow& row) {
  return static_cast<std::uint16_t>(std::stoi(row.at("number").substr(1)));
}

std::vector<std::uint8_t> objects_of(const CsvRow& row) {
  const std::string& kind = row.at("do");
  if (kind == "CU") return {kControlUnitNumber};
  if (kind == "AXIS") return {kServoAxis, kVectorAxis};
  return {kControlUnitNumber, kServoAxis, kVectorAxis};
}

/// A number as the list writes it: 10.00, 800006DFh, or a BICO source 1520[0] or 2526.3.
std::optional<double> number_in(const std::string& text, bool is_source) {
  static const std::regex kSource{R"((\d+)[\[.](\d+)\]?)"};
  static const std::regex kHexadecimal{"[0-9A-F]+h"};
  static const std::regex kDecimal{R"(-?\d+(\.\d+)?)"};
  std::smatch match;
  if (is_source && std::regex_match(text, match, kSource))
    return own_source(static_cast<std::uint16_t>(std::stoi(match[1])),
                      static_cast<std::uint16_t>(std::stoi(match[2])));
  if (std::regex_match(text, kHexadecimal)) return static_cast<double>(std::stoul(text, nullptr, 16));
  if (std::regex_match(text, kDecimal)) return std::stod(text);
  return std::nullopt;
}

/// What a new unit has instead of the list's value, because it is commissioned and connected.
const std::map<std::uint16_t, double> kOfANewUnit{{9, 0.0},
                                                  {10, 0.0},
                                                  {26, 540.0},
                                                  {70, 540.0},
                                                  {300, 2.0},
                                                  {304, 330.0},
                                                  {305, 5.6},
                                                  {307, 7.3 * 3000.0 * kRpm / 1000.0},
                                                  {310, 200.0},
                                                  {311, 3000.0},
                                                  {312, 7.3},
                                                  {314, 4.0},
                                                  {316, 1.37},
                                                  {322, 7200.0},
                                                  {323, 28.0},
                                                  {338, 28.0},
                                                  {341, 0.00151},
                                                  {350, 0.55},
                                                  {356, 5.5},
                                                  {400, 2002.0},
                                                  {640, 28.0},
                                                  {840, own_source(8890, 0)},
                                                  {844, own_source(8890, 1)},
                                                  {848, own_source(8890, 2)},
                                                  {852, own_source(8890, 3)},
                                                  {1070, own_source(8860, 1)},
                                                  {1082, 7200.0},
                                                  {1503, own_source(8850, 3)},
                                                  {1520, 35.0},
                                                  {1521, -35.0},
                                                  {1900, 0.0},
                                                  {2000, 3000.0},
                                                  {2003, 7.3},
                                                  {2151, own_source(1119, 0)},
                                                  {2162, 720.0},
                                                  {8603, 0x85},
                                                  {8620, kNodeId},
                                                  {8744, 1.0},
                                                  {8790, 1.0}};
/// Words that a vector axis has more of, as the notes of the list say.
const std::map<std::uint16_t, int> kCountsOfAVector{{2050, 32}, {2051, 32}, {2053, 32},
                                                    {2060, 31}, {2061, 31}, {2063, 31}};
/// Computed: see the control's own tests, or of the axes only and shown on the control unit too.
const std::set<std::uint16_t> kTestedElsewhere{1460, 1462, 1470, 1472, 1530, 1531, 2103, 8851, 8861};
/// Any COB-ID with bit 31 is taken, so the limits are those of the type.
bool is_cob_id(std::uint16_t number) {
  return (number >= 8700 && number <= 8707) || (number >= 8720 && number <= 8727);
}

bool is_mapping(std::uint16_t number) {
  return (number >= 8710 && number <= 8717) || (number >= 8730 && number <= 8737);
}

/// The rows of both lists.
std::vector<CsvRow> both_lists() {
  std::vector<CsvRow> rows = drive_test::read_csv("parameters.csv");
  for (const CsvRow& row : drive_test::read_csv("interfaces-parameters.csv")) rows.push_back(row);
  return rows;
}

class ParameterList : public testing::Test {
 protected:
  DriveUnit unit_{servo_and_vector()};
  const std::vector<CsvRow> list_ = both_lists();

  /// Calls @p check(row of the list, row of the table, drive object) for every parameter of every drive object.
  template <class Check>
  int for_each(Check check) {
    int count = 0;
    for (const CsvRow& listed : list_)
      for (const std::uint8_t object : objects_of(listed)) {
        SCOPED_TRACE(listed.at("number") + " of drive object " + std::to_string(object));
        const PlacedRow* const placed = find_parameter(unit_.object(object)->kind(), number_of(listed));
        if (placed == nullptr) {
          ADD_FAILURE() << "missing";
          continue;
        }
        check(listed, *placed->row, object);
        ++count;
      }
    return count;
  }
};

TEST_F(ParameterList, IsCompleteAndReadableInEveryIndex) {
  const int found = for_each([&](const CsvRow& listed, const ParameterRow& row, std::uint8_t object) {
    const auto own = kCountsOfAVector.find(row.number);
    const bool is_listed = object != kVectorAxis || own == kCountsOfAVector.end();
    const int listed_count = row.number == 1801 && object == kServoAxis ? 1 : std::stoi(listed.at("index_count"));
    EXPECT_EQ(row.count, is_listed ? listed_count : own->second);
    for (std::size_t i = 0; i < row.count; ++i) EXPECT_TRUE(unit_.read(object, row.number, i));
    const Refusal beyond = row.count == 1 ? Refusal::NotIndexed : Refusal::NoIndex;
    EXPECT_EQ(unit_.read(object, row.number, row.count).error().reason, beyond);
  });

  EXPECT_GE(found, 1284);
}

TEST_F(ParameterList, HasItsTypesAndAccess) {
  for_each([&](const CsvRow& listed, const ParameterRow& row, std::uint8_t object) {
    const std::string& type = listed.at("type");
    EXPECT_EQ(row_of(row.type).text, type == "U32/I16" || type == "U32/I32" ? "CI" : type);
    EXPECT_EQ(row.is_writable(), listed.at("access") == "rw");
    EXPECT_EQ(parameter_text(row), listed.at("number"));
    if (row.is_writable()) return;
    EXPECT_EQ(unit_.write(object, row.number, 0, {row.type, 0}).error().reason, Refusal::ReadOnly);
  });
}

TEST_F(ParameterList, HasItsLimits) {
  int compared = 0;
  for_each([&](const CsvRow& listed, const ParameterRow& row, std::uint8_t) {
    if (!row.is_writable() || is_cob_id(row.number)) return;
    const auto minimum = number_in(listed.at("min"), false);
    const auto maximum = number_in(listed.at("max"), false);
    if (!minimum || !maximum) return;
    EXPECT_EQ(limits_of(row).minimum, *minimum);
    EXPECT_EQ(limits_of(row).maximum, *maximum);
    ++compared;
  });
  EXPECT_GT(compared, 400);
}

TEST_F(ParameterList, HasItsFactoryValuesOrThoseOfACommissionedUnit) {
  int compared = 0;
  for_each([&](const CsvRow& listed, const ParameterRow& row, std::uint8_t object) {
    if (kTestedElsewhere.count(row.number) != 0) return;
    const auto own = kOfANewUnit.find(row.number);
    const auto expected =
        own != kOfANewUnit.end() ? own->second : number_in(listed.at("default"), is_bico_input(row.type));
    if (!expected) return;
    const bool is_of_the_kind = is_mapping(row.number) || row.number == 107;  // objects, type of that axis
    if (is_of_the_kind && object == kVectorAxis) return;
    const double value = decode(unit_.read(object, row.number, 0).value());
    EXPECT_NEAR(value, *expected, 1e-6 * std::abs(*expected));
    ++compared;
  });
  EXPECT_GT(compared, 700);
}

TEST_F(ParameterList, TakesBothLimitsOfEveryWritableNumber) {
  for_each([&](const CsvRow&, const ParameterRow& row, std::uint8_t object) {
    if (!row.is_writable() || is_bico_input(row.type) || row.range == kWhole) return;
    DriveObject& owner = *unit_.object(object);
    if (row.keep == Keep::No) return;  // commands and filters
    for (const double limit : {row.range.minimum, row.range.maximum}) {
      EXPECT_TRUE(owner.load(row.number, 0, limit)) << limit;
      EXPECT_NEAR(owner.read(row.number).value(), limit, 1e-6 * std::abs(limit));
    }
    const double beyond = std::max({1.0, 1e-6 * std::abs(row.range.maximum), -1e-6 * row.range.minimum});
    EXPECT_EQ(owner.load(row.number, 0, row.range.minimum - beyond).error().reason, Refusal::BelowMinimum);
    EXPECT_EQ(owner.load(row.number, 0, row.range.maximum + beyond).error().reason, Refusal::AboveMaximum);
  });
}

TEST_F(ParameterList, GivesTheFirstAxisThePredefinedConnectionSet) {
  const auto value = [&](std::uint8_t object, std::uint16_t number, std::size_t index) {
    return unit_.read(object, number, index).value().bits;
  };

  EXPECT_EQ(value(kServoAxis, 8700, 0), 0x205u);
  EXPECT_EQ(value(kServoAxis, 8703, 0), 0x505u);
  EXPECT_EQ(value(kServoAxis, 8704, 0), 0x800006DFu);
  EXPECT_EQ(value(kServoAxis, 8721, 0), 0x40000285u);
  EXPECT_EQ(value(kServoAxis, 8724, 0), 0xC00006DFu);
  EXPECT_EQ(value(kServoAxis, 8713, 2), 0x60710010u);
  EXPECT_EQ(value(kServoAxis, 8733, 1), 0x60630020u);
  EXPECT_EQ(value(kVectorAxis, 8700, 0), 0x800006DFu);
  EXPECT_EQ(value(kVectorAxis, 8720, 0), 0xC00006DFu);
  EXPECT_EQ(value(kVectorAxis, 8711, 1), 0x68FF0020u);
  EXPECT_EQ(value(kVectorAxis, 8711, 2), 0u);
  EXPECT_EQ(value(kServoAxis, 2103, 0), pack({8890, kOwnObject, 7}));
  EXPECT_EQ(value(kServoAxis, 8851, 0), pack({8784, kOwnObject, 0}));
  EXPECT_EQ(value(kServoAxis, 8861, 1), pack({63, kOwnObject, 0}));
  EXPECT_EQ(value(kControlUnitNumber, 8851, 0), 0u);
}

TEST_F(ParameterList, NamesTheDriveObjectsOfTheUnit) {
  const auto value = [&](std::uint16_t number, std::size_t index) {
    return decode(unit_.read(kControlUnitNumber, number, index).value());
  };

  EXPECT_EQ(value(102, 0), 3.0);
  EXPECT_EQ(value(101, 2), 3.0);
  EXPECT_EQ(value(101, 3), 0.0);
  EXPECT_EQ(value(107, 1), 11.0);
  EXPECT_EQ(value(107, 2), 12.0);
  EXPECT_EQ(value(8743, 0), 2.0);
  EXPECT_EQ(value(8743, 1), 3.0);
  EXPECT_EQ(value(8743, 2), 0.0);
}

}  // namespace
}  // namespace drive
