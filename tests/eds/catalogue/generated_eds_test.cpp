#include <array>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"

/// What the EDS files say of this unit in particular; the rules of CiA 306 are in eds_rules_test.cpp.
namespace eds_test {
namespace {

const Section& section(const std::string& name) {
  return generated_eds().at(name);
}

TEST(GeneratedEds, NamesTheUnitAndWhatItSupports) {
  const std::map<std::string, std::string> expected{{"VendorNumber", "0x06000053"},
                                                    {"ProductNumber", "0x00005000"},
                                                    {"RevisionNumber", "0x00010000"},
                                                    {"SimpleBootUpSlave", "1"},
                                                    {"SimpleBootUpMaster", "0"},
                                                    {"Granularity", "8"},
                                                    {"GroupMessaging", "0"},
                                                    {"NrOfRXPDO", "8"},
                                                    {"NrOfTXPDO", "8"},
                                                    {"LSS_Supported", "0"},
                                                    {"BaudRate_10", "1"},
                                                    {"BaudRate_20", "1"},
                                                    {"BaudRate_50", "1"},
                                                    {"BaudRate_125", "1"},
                                                    {"BaudRate_250", "1"},
                                                    {"BaudRate_500", "1"},
                                                    {"BaudRate_800", "1"},
                                                    {"BaudRate_1000", "1"}};
  for (const auto& [key, value] : expected) EXPECT_EQ(section("DeviceInfo").at(key), value) << key;
}

TEST(GeneratedEds, SaysThatItDescribesTheSimulatedUnit) {
  EXPECT_NE(section("FileInfo").at("Description").find("axisd"), std::string::npos);
  EXPECT_EQ(section("FileInfo").at("FileName"), "axisd.eds");
}

TEST(GeneratedEds, MapsNoDummies) {
  EXPECT_EQ(section("DummyUsage").size(), 7U);
  for (const auto& [key, value] : section("DummyUsage")) EXPECT_EQ(value, "0") << key;
}

TEST(GeneratedEds, StartsWithThePredefinedConnectionSet) {
  const auto cob_id = [](std::uint16_t index, std::uint8_t sub) {
    return number(find_entry(generated_eds(), index, sub)->at("DefaultValue"), 5);
  };
  for (std::uint16_t n = 0; n < 4; ++n) {
    EXPECT_EQ(cob_id(static_cast<std::uint16_t>(0x1400 + n), 1), 0x205 + 0x100 * n);
    EXPECT_EQ(cob_id(static_cast<std::uint16_t>(0x1800 + n), 1), 0x40000185 + 0x100 * n) << "without RTR";
  }
  EXPECT_EQ(cob_id(0x1005, 0), 0x80);
  EXPECT_EQ(cob_id(0x1014, 0), 0x85);
  EXPECT_EQ(cob_id(0x1200, 1), 0x605);
  EXPECT_EQ(cob_id(0x1200, 2), 0x585);
}

TEST(GeneratedEds, StatesNoDefaultForWhatTheRealUnitLeavesOpen) {
  for (const char* name :
       {"100A", "1018sub3", "1018sub4", "6060", "6061", "6502", "6083", "1027sub0", "1010sub1", "6046sub2"})
    EXPECT_FALSE(section(name).contains("DefaultValue")) << name;
}

TEST(GeneratedEds, KeepsSetpointsOutOfADownloadOfTheWholeFile) {
  for (const char* name : {"6040", "6060", "6071", "60FF"}) EXPECT_EQ(section(name).at("ObjFlags"), "0x1") << name;
}

/// COB-ID of @p index on node 5 in the EDS of eight axes.
std::optional<std::int64_t> cob_id_of_eight(unsigned index) {
  const Section* const entry = find_entry(generated_eds("axisd-8-axes.eds"), static_cast<std::uint16_t>(index), 1);
  return entry != nullptr ? number(entry->at("DefaultValue"), 5) : std::nullopt;
}

TEST(GeneratedEds, GivesOnlyTheFirstAxisValidPdos) {
  for (unsigned axis = 1; axis <= 8; ++axis)
    for (unsigned n = 0; n < 8; ++n) {
      const unsigned offset = 0x40 * (axis - 1) + n;
      const bool valid = axis == 1 && n < 4;
      EXPECT_EQ(cob_id_of_eight(0x1400 + offset), valid ? 0x205 + 0x100 * n : 0x800006DF) << axis << ", " << n;
      EXPECT_EQ(cob_id_of_eight(0x1800 + offset), valid ? 0x40000185 + 0x100 * n : 0xC00006DF)
          << axis << ", " << n;
    }
}

TEST(GeneratedEds, MapsTheObjectsOfEveryAxisIntoItsOwnPdos) {
  for (unsigned axis = 1; axis <= 8; ++axis) {
    const auto mapping = static_cast<std::uint16_t>(0x1600 + 0x40 * (axis - 1) + 1);
    const EdsFile& file = generated_eds("axisd-8-axes.eds");
    EXPECT_EQ(number_at(*find_entry(file, mapping, 1), "DefaultValue"), 0x60400010 + 0x08000000LL * (axis - 1));
    EXPECT_EQ(number_at(*find_entry(file, mapping, 2), "DefaultValue"), 0x60FF0020 + 0x08000000LL * (axis - 1));
    EXPECT_EQ(number_at(*find_entry(file, mapping, 3), "DefaultValue"), 0) << "an empty entry stays empty";
  }
}

TEST(GeneratedEds, OffersEveryPlaceAServoAndAVectorModule) {
  const EdsFile& file = generated_eds("axisd-unit.eds");

  EXPECT_EQ(file.at("SupportedModules").at("NrOfEntries"), "16");
  for (int place = 1; place <= 8; ++place) {
    const std::string servo = "M" + std::to_string(place), vector = "M" + std::to_string(place + 8);
    EXPECT_EQ(file.at(servo + "ModuleInfo").at("ProductName"), "Servo axis " + std::to_string(place));
    EXPECT_EQ(file.at(vector + "ModuleInfo").at("ProductName"), "Vector axis " + std::to_string(place));
    EXPECT_EQ(number_at(file.at(servo + "SubExt1027"), "DefaultValue"), (place - 1) << 8 | 0x0B);
    EXPECT_EQ(number_at(file.at(vector + "SubExt1027"), "DefaultValue"), (place - 1) << 8 | 0x0C);
  }
  EXPECT_EQ(file.at("M8Fixed9FFF").at("DefaultValue"), "0x20192");
  EXPECT_EQ(file.at("M16Fixed9FFF").at("DefaultValue"), "0x2010192");
  EXPECT_EQ(file.at("DeviceInfo").at("NrOfRXPDO"), "64");
}

}  // namespace
}  // namespace eds_test
