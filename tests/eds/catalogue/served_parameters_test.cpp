#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "drive/catalogue/table.hpp"
#include "tests/eds/rules/eds_reader.hpp"
#include "tests/eds/rules/objects_csv.hpp"

/// The EDS files of the drive objects against the parameters that the unit serves.
namespace eds_test {
namespace {

constexpr unsigned kFirstObject = 0x2000;
constexpr unsigned kLastObject = 0x470F;
/// Sub-indices of an object that an EDS has; further indices p8630[1] shows.
constexpr unsigned kMostSubIndices = 0xFF;

/// A kind of drive object, its EDS, and the scope of what the vendor's EDS lists of it.
struct File {
  drive::ObjectKind kind;
  const char* name;
  const char* scope;
};
void PrintTo(const File& file, std::ostream* out) {
  *out << file.name;
}

/// The code of CiA 301.
std::int64_t type_of(drive::DataType type) {
  constexpr std::array kCodes{2, 5, 3, 6, 4, 7, 8, 7, 7};
  return kCodes.at(static_cast<std::size_t>(type));
}

struct ServedParameters : testing::TestWithParam<File> {
  const EdsFile& file = generated_eds(GetParam().name);

  /// The parameters of the kind whose numbers are those of objects.
  static std::vector<drive::PlacedRow> parameters() {
    std::vector<drive::PlacedRow> shown;
    for (const drive::PlacedRow& placed : drive::parameters_of(GetParam().kind))
      if (kFirstObject + placed.row->number <= kLastObject) shown.push_back(placed);
    return shown;
  }
};

TEST_P(ServedParameters, StandInTheEdsOfTheirDriveObjectWithEveryIndex) {
  for (const drive::PlacedRow& placed : parameters()) {
    const drive::ParameterRow& row = *placed.row;
    const unsigned shown = std::min<unsigned>(row.count, kMostSubIndices);
    for (unsigned index = 0; index <= shown; ++index) {
      SCOPED_TRACE(drive::parameter_text(row) + "[" + std::to_string(index) + "]");
      const Section* const entry = find_entry(file, static_cast<std::uint16_t>(kFirstObject + row.number),
                                              static_cast<std::uint8_t>(index));
      ASSERT_EQ(entry != nullptr, index < shown);
      if (entry == nullptr) break;
      EXPECT_EQ(number_at(*entry, "DataType"), type_of(row.type));
      EXPECT_EQ(entry->at("AccessType"), row.is_writable() ? "rw" : "ro");
    }
  }
}

TEST_P(ServedParameters, AreAllThatTheEdsHas) {
  std::set<unsigned> served;
  for (const drive::PlacedRow& placed : parameters()) served.insert(kFirstObject + placed.row->number);
  std::set<unsigned> listed;
  for (const auto& [name, section] : file)
    if (name.size() == 4 && section.contains("ObjectType"))
      if (const auto index = static_cast<unsigned>(std::stoul(name, nullptr, 16)); index >= kFirstObject)
        listed.insert(index);

  EXPECT_EQ(listed, served);
}

TEST_P(ServedParameters, HaveTheirLimitsAndDefaults) {
  for (const drive::PlacedRow& placed : parameters()) {
    const drive::ParameterRow& row = *placed.row;
    const Section& entry = *find_entry(file, static_cast<std::uint16_t>(kFirstObject + row.number), 0);
    SCOPED_TRACE(drive::parameter_text(row));
    const drive::Range limits = drive::limits_of(row);
    const auto expect = [&](const char* key, double value) {
      if (!entry.contains(key)) return;
      EXPECT_NEAR(std::stod(entry.at(key)), value, 1e-8) << key;
    };
    if (!row.is_writable()) continue;
    expect("LowLimit", limits.minimum);
    expect("HighLimit", limits.maximum);
    if (const auto* const value = std::get_if<double>(&row.factory)) expect("DefaultValue", *value);
  }
}

/// What docs/reference/deviations.md says of the vendor's EDS files.
TEST_P(ServedParameters, AreMoreThanTheVendorLists) {
  std::set<std::uint16_t> vendors;
  for (const Fact& fact : read_facts())
    if (fact.at("scope") == GetParam().scope) vendors.insert(index_of(fact));
  const std::string page = read_file(std::string{SOURCE_FOLDER} + "/docs/reference/deviations.md");

  EXPECT_NE(page.find(" " + std::to_string(vendors.size()) + " in `" + GetParam().name + "`"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Eds, ServedParameters,
                         testing::Values(File{drive::ObjectKind::ControlUnit, "axisd-control-unit.eds",
                                              "cu-parameter"},
                                         File{drive::ObjectKind::Servo, "axisd-servo.eds", "servo-parameter"},
                                         File{drive::ObjectKind::Vector, "axisd-vector.eds", "vector-parameter"}),
                         [](const auto& file) {
                           return file.param.kind == drive::ObjectKind::ControlUnit ? "ControlUnit"
                                  : file.param.kind == drive::ObjectKind::Servo     ? "Servo"
                                                                                    : "Vector";
                         });

}  // namespace
}  // namespace eds_test
