#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/eds/eds_reader.hpp"

/// The static rules of CiA 306 over the EDS that the build made.
namespace eds_test {
namespace {

const Section& section(const std::string& name) {
  return generated_eds().at(name);
}

bool is_object(const std::string& name) {
  return name.size() == 4 && name.find_first_not_of("0123456789ABCDEF") == std::string::npos;
}

/// Objects and sub-indices: the sections with an ObjectType.
template <class Check>
void for_each_entry(Check check) {
  for (const auto& [name, keys] : generated_eds()) {
    if (keys.find("DataType") == keys.end()) continue;
    SCOPED_TRACE(name);
    check(keys);
  }
}

/// Width in bits by data type.
const std::map<std::int64_t, int> kIntegers{{1, 1}, {2, 8}, {3, 16}, {4, 32}, {5, 8}, {6, 16}, {7, 32}};
constexpr std::int64_t kVisibleString = 9;
bool is_signed(std::int64_t type) {
  return type >= 2 && type <= 4;
}

bool representable(std::int64_t value, std::int64_t type) {
  const int bits = kIntegers.at(type);
  const std::int64_t values = std::int64_t{1} << bits;
  return is_signed(type) ? value >= -values / 2 && value < values / 2 : value >= 0 && value < values;
}

TEST(GeneratedEds, HasEverySectionOfTheStandard) {
  for (const char* name : {"FileInfo", "DeviceInfo", "DummyUsage", "Comments", "MandatoryObjects",
                           "OptionalObjects", "ManufacturerObjects"})
    EXPECT_TRUE(generated_eds().contains(name)) << name;
}

TEST(GeneratedEds, NamesTheUnitAndWhatItSupports) {
  const std::map<std::string, std::string> expected{{"VendorNumber", "0x06000053"},
                                                    {"ProductNumber", "0x00005000"},
                                                    {"RevisionNumber", "0x00010000"},
                                                    {"SimpleBootUpSlave", "1"},
                                                    {"SimpleBootUpMaster", "0"},
                                                    {"Granularity", "8"},
                                                    {"GroupMessaging", "0"},
                                                    {"NrOfRXPDO", "4"},
                                                    {"NrOfTXPDO", "4"},
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

TEST(GeneratedEds, NumbersItsCommentsWithoutGaps) {
  const Section& comments = section("Comments");
  const std::int64_t lines = number_at(comments, "Lines");

  EXPECT_EQ(comments.size(), static_cast<std::size_t>(lines) + 1);
  for (std::int64_t n = 1; n <= lines; ++n) EXPECT_TRUE(comments.contains("Line" + std::to_string(n))) << n;
}

TEST(GeneratedEds, ListsEveryObjectOnceInItsList) {
  std::set<std::string> listed;
  for (const char* list : {"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"}) {
    const std::int64_t count = number_at(section(list), "SupportedObjects");
    EXPECT_EQ(section(list).size(), static_cast<std::size_t>(count) + 1) << list;
    for (std::int64_t n = 1; n <= count; ++n) {
      const std::string index = section(list).at(std::to_string(n)).substr(2);
      EXPECT_TRUE(listed.insert(index).second) << index;
      const bool mandatory = index == "1000" || index == "1001" || index == "1018";
      const bool manufacturer = index >= "2000" && index < "6000";
      EXPECT_STREQ(list, mandatory      ? "MandatoryObjects"
                         : manufacturer ? "ManufacturerObjects"
                                        : "OptionalObjects");
    }
  }
  std::set<std::string> present;
  for (const auto& [name, keys] : generated_eds())
    if (is_object(name)) present.insert(name);
  EXPECT_EQ(listed, present);
}

TEST(GeneratedEds, HasTheMandatoryObjects) {
  EXPECT_NE(find_entry(generated_eds(), 0x1000, 0), nullptr);
  EXPECT_NE(find_entry(generated_eds(), 0x1001, 0), nullptr);
  EXPECT_NE(find_entry(generated_eds(), 0x1018, 0), nullptr);
  EXPECT_NE(find_entry(generated_eds(), 0x1018, 1), nullptr);
}

TEST(GeneratedEds, CountsTheSubIndicesOfEveryObject) {
  std::size_t subs = 0;
  for (const auto& [name, keys] : generated_eds()) {
    if (!is_object(name)) {
      subs += name.find("sub") != std::string::npos && is_object(name.substr(0, 4)) ? 1U : 0U;
      continue;
    }
    const bool variable = keys.at("ObjectType") == "0x7";
    EXPECT_EQ(keys.contains("SubNumber"), !variable) << name;
    EXPECT_EQ(keys.contains("DataType"), variable) << name;
    if (variable) continue;
    const auto index = static_cast<std::uint16_t>(std::stoul(name, nullptr, 16));
    std::int64_t found = 0;
    for (unsigned sub = 0; sub < 0xFF; ++sub)
      found += find_entry(generated_eds(), index, static_cast<std::uint8_t>(sub)) != nullptr ? 1 : 0;
    EXPECT_EQ(found, number_at(keys, "SubNumber")) << name;
    subs -= static_cast<std::size_t>(found);
  }
  EXPECT_EQ(subs, 0U) << "a sub-index without its object, or with a name of another form";
}

TEST(GeneratedEds, GivesEveryEntryAKnownTypeAndAccess) {
  const std::set<std::string> accesses{"ro", "wo", "rw", "rwr", "rww", "const"};
  for_each_entry([&](const Section& keys) {
    const std::int64_t type = number_at(keys, "DataType");
    EXPECT_TRUE(type == kVisibleString || kIntegers.contains(type));
    EXPECT_TRUE(accesses.contains(keys.at("AccessType")));
    EXPECT_EQ(keys.at("ObjectType"), "0x7");
    EXPECT_FALSE(keys.at("ParameterName").empty());
  });
}

TEST(GeneratedEds, UsesOnlyTheKeysOfTheStandard) {
  const std::set<std::string> known{"ParameterName", "ObjectType",   "DataType",   "LowLimit", "HighLimit",
                                    "AccessType",    "DefaultValue", "PDOMapping", "ObjFlags"};
  for_each_entry([&](const Section& keys) {
    for (const auto& [key, value] : keys) EXPECT_TRUE(known.contains(key)) << key;
  });
}

TEST(GeneratedEds, KeepsLimitsAndDefaultsInOrderAndWithinTheType) {
  for (const std::int64_t node : {1, 127})
    for_each_entry([node](const Section& keys) {
      const std::int64_t type = number_at(keys, "DataType");
      std::optional<std::int64_t> previous;
      for (const char* key : {"LowLimit", "DefaultValue", "HighLimit"}) {
        const auto found = keys.find(key);
        if (found == keys.end() || type == kVisibleString) continue;
        const auto value = number(found->second, node);
        ASSERT_TRUE(value) << key;
        EXPECT_TRUE(representable(*value, type)) << key;
        if (previous) {
          EXPECT_LE(*previous, *value) << key;
        }
        previous = value;
      }
    });
}

TEST(GeneratedEds, TellsTheHighestSubIndexWhereItIsFixed) {
  for (const auto& [name, keys] : generated_eds()) {
    if (!is_object(name) || !keys.contains("SubNumber")) continue;
    const Section& first = section(name + "sub0");
    const std::int64_t highest = number_at(keys, "SubNumber") - 1;
    if (first.at("AccessType") == "ro") {
      EXPECT_EQ(number_at(first, "DefaultValue"), highest) << name;
    }
    EXPECT_LE(number_at(first, "DefaultValue"), highest) << name;
  }
}

TEST(GeneratedEds, GivesEveryMappableEntryADirection) {
  const std::set<std::string> directed{"ro", "wo", "rwr", "rww"};
  for_each_entry([&](const Section& keys) {
    if (keys.at("PDOMapping") == "1") {
      EXPECT_TRUE(directed.contains(keys.at("AccessType")));
    }
  });
}

struct Direction {
  std::uint16_t communication;
  std::uint16_t mapping;
  std::array<const char*, 2> accesses;
};
const std::array<Direction, 2> kDirections{{{0x1400, 0x1600, {"rww", "wo"}}, {0x1800, 0x1A00, {"ro", "rwr"}}}};

/// Bits of mapping @p index; every mapped entry is checked on the way.
std::int64_t mapped_bits(std::uint16_t index, const std::array<const char*, 2>& accesses) {
  const std::int64_t count = number_at(*find_entry(generated_eds(), index, 0), "DefaultValue");
  std::int64_t sum = 0;
  for (std::int64_t sub = 1; sub <= count; ++sub) {
    const Section& entry = *find_entry(generated_eds(), index, static_cast<std::uint8_t>(sub));
    const std::int64_t mapped = number_at(entry, "DefaultValue");
    const Section* const target = find_entry(generated_eds(), static_cast<std::uint16_t>(mapped >> 16),
                                             static_cast<std::uint8_t>(mapped >> 8 & 0xFF));
    if (target == nullptr) {
      ADD_FAILURE() << std::hex << index << ":" << sub << " maps " << mapped << ", which does not exist";
      continue;
    }
    EXPECT_EQ(target->at("PDOMapping"), "1") << std::hex << mapped;
    EXPECT_TRUE(std::ranges::count(accesses, target->at("AccessType")) == 1) << std::hex << mapped;
    EXPECT_EQ(mapped & 0xFF, kIntegers.at(number_at(*target, "DataType"))) << std::hex << mapped;
    sum += mapped & 0xFF;
  }
  return sum;
}

TEST(GeneratedEds, MapsExistingEntriesOfTheRightLengthInto64BitsAtMost) {
  for (const Direction& direction : kDirections)
    for (std::uint16_t n = 0; n < 4; ++n) {
      const auto index = static_cast<std::uint16_t>(direction.mapping + n);
      const std::int64_t bits = mapped_bits(index, direction.accesses);
      EXPECT_TRUE(bits > 0 && bits <= 64) << std::hex << index;
    }
}

TEST(GeneratedEds, PairsCommunicationAndMappingOfEveryPdo) {
  for (const Direction& direction : kDirections)
    for (std::uint16_t n = 0; n < 0x200; ++n) {
      const auto communication = static_cast<std::uint16_t>(direction.communication + n);
      const auto mapping = static_cast<std::uint16_t>(direction.mapping + n);
      EXPECT_EQ(find_entry(generated_eds(), communication, 0) != nullptr, n < 4) << std::hex << communication;
      EXPECT_EQ(find_entry(generated_eds(), mapping, 0) != nullptr, n < 4) << std::hex << mapping;
    }
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
  for (const char* name : {"100A", "1018sub3", "1018sub4", "6060", "6061", "6502", "6083"})
    EXPECT_FALSE(section(name).contains("DefaultValue")) << name;
}

TEST(GeneratedEds, KeepsSetpointsOutOfADownloadOfTheWholeFile) {
  for (const char* name : {"6040", "6060", "6071", "60FF"}) EXPECT_EQ(section(name).at("ObjFlags"), "0x1") << name;
}

}  // namespace
}  // namespace eds_test
