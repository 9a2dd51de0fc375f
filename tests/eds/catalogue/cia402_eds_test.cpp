#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"

/// What the EDS files of the CiA 402 device say beyond its facts (facts_test.cpp) and CiA 306
/// (eds_rules_test.cpp).
namespace eds_test {
namespace {

constexpr std::int64_t kNode = 5;
constexpr unsigned kPdos = 8;

class Cia402Eds : public testing::TestWithParam<unsigned> {
 protected:
  const EdsFile& file = generated_eds(
      GetParam() == 1 ? "axisd-cia402.eds" : "axisd-cia402-" + std::to_string(GetParam()) + "-axes.eds");

  std::optional<std::int64_t> default_of(unsigned index, unsigned sub) const {
    const Section* const entry =
        find_entry(file, static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    return entry != nullptr ? number(entry->at("DefaultValue"), kNode) : std::nullopt;
  }
};

TEST_P(Cia402Eds, NamesTheDeviceAndWhatItSupports) {
  const std::string pdos = std::to_string(kPdos * GetParam());
  const std::map<std::string, std::string> expected{{"VendorName", "axisd"},
                                                    {"VendorNumber", "0x00000000"},
                                                    {"ProductName", "axisd CiA 402 axis"},
                                                    {"ProductNumber", "0x00000402"},
                                                    {"OrderCode", "axisd-cia402"},
                                                    {"RevisionNumber", "0x00010000"},
                                                    {"SimpleBootUpMaster", "0"},
                                                    {"SimpleBootUpSlave", "1"},
                                                    {"Granularity", "8"},
                                                    {"DynamicChannelsSupported", "0"},
                                                    {"GroupMessaging", "0"},
                                                    {"NrOfRXPDO", pdos},
                                                    {"NrOfTXPDO", pdos},
                                                    {"LSS_Supported", "1"},
                                                    {"CompactPDO", "0"},
                                                    {"BaudRate_10", "1"},
                                                    {"BaudRate_20", "1"},
                                                    {"BaudRate_50", "1"},
                                                    {"BaudRate_125", "1"},
                                                    {"BaudRate_250", "1"},
                                                    {"BaudRate_500", "1"},
                                                    {"BaudRate_800", "1"},
                                                    {"BaudRate_1000", "1"}};
  const Section& info = file.at("DeviceInfo");
  for (const auto& [key, value] : expected) EXPECT_EQ(info.at(key), value) << key;
  EXPECT_EQ(info.size(), expected.size());
}

TEST_P(Cia402Eds, LetsUnsignedDummiesBeMapped) {
  const std::map<std::string, std::string, std::less<>> expected{
      {"Dummy0001", "0"}, {"Dummy0002", "0"}, {"Dummy0003", "0"}, {"Dummy0004", "0"},
      {"Dummy0005", "1"}, {"Dummy0006", "1"}, {"Dummy0007", "1"}};
  EXPECT_EQ(file.at("DummyUsage"), expected);
}

TEST_P(Cia402Eds, SaysOfWhichProfileDeviceAndAxesAre) {
  EXPECT_EQ(default_of(0x1000, 0), GetParam() == 1 ? 0x00020192 : 0xFFFF0192);
  for (unsigned axis = 1; axis <= 8; ++axis)
    EXPECT_EQ(default_of(0x67FF + 0x800 * (axis - 1), 0),
              axis <= GetParam() ? std::optional{std::int64_t{0x00020192}} : std::nullopt)
        << axis;
}

TEST_P(Cia402Eds, GivesOnlyTheFirstAxisValidPdos) {
  for (unsigned axis = 1; axis <= GetParam(); ++axis)
    for (unsigned n = 0; n < kPdos; ++n) {
      const unsigned offset = 0x40 * (axis - 1) + n;
      const bool valid = axis == 1 && n < 4;
      EXPECT_EQ(default_of(0x1400 + offset, 1), valid ? 0x205 + 0x100 * n : 0x80000000) << axis << ", " << n;
      EXPECT_EQ(default_of(0x1800 + offset, 1), valid ? 0x40000185 + 0x100 * n : 0xC0000000) << axis << ", " << n;
    }
}

TEST_P(Cia402Eds, MapsTheObjectsOfEveryAxisIntoItsOwnPdos) {
  for (unsigned axis = 1; axis <= GetParam(); ++axis) {
    const unsigned pdos = 0x40 * (axis - 1);
    const std::int64_t objects = 0x08000000LL * (axis - 1);
    EXPECT_EQ(default_of(0x1602 + pdos, 1), 0x60400010 + objects);
    EXPECT_EQ(default_of(0x1602 + pdos, 2), 0x607A0020 + objects);
    EXPECT_EQ(default_of(0x1602 + pdos, 3), 0) << "an empty entry stays empty";
    EXPECT_EQ(default_of(0x1A05 + pdos, 2), 0x60440010 + objects);
    EXPECT_EQ(default_of(0x1802 + pdos, 3), 100) << "inhibit time of a moving position";
  }
}

TEST_P(Cia402Eds, HasOneSdoServer) {
  EXPECT_TRUE(file.contains("1200"));
  EXPECT_EQ(file.upper_bound("1200sub2")->first, "1400");
}

INSTANTIATE_TEST_SUITE_P(Axes, Cia402Eds, testing::Range(1U, 9U));

}  // namespace
}  // namespace eds_test
