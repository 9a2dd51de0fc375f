#include "eds/sheet/section_name.hpp"

#include <gtest/gtest.h>

namespace eds {
namespace {

TEST(SectionName, KnowsTheSectionsOfTheStandardInAnyLetterCase) {
  const auto kind = [](std::string_view name) { return parse_section_name(name).kind; };

  EXPECT_EQ(kind("FILEINFO"), SectionKind::FileInfo);
  EXPECT_EQ(kind("deviceinfo"), SectionKind::DeviceInfo);
  EXPECT_EQ(kind("DeviceComissioning"), SectionKind::DeviceCommissioning);
  EXPECT_EQ(kind("DeviceCommissioning"), SectionKind::DeviceCommissioning);
  EXPECT_EQ(kind("Tools"), SectionKind::Tools);
  EXPECT_EQ(kind("Tool12"), SectionKind::Tool);
}

TEST(SectionName, TakesObjectsAndEntriesApart) {
  using enum SectionKind;
  const auto name = parse_section_name;

  EXPECT_EQ(name("1018"), (SectionName{.kind = Object, .index = 0x1018}));
  EXPECT_EQ(name("60ff"), (SectionName{.kind = Object, .index = 0x60FF}));
  for (const char* const spelling : {"1018sub1", "1018Sub1", "1018SUB01", "1018sub001"})
    EXPECT_EQ(name(spelling), (SectionName{.kind = SubObject, .index = 0x1018, .sub_index = 1})) << spelling;
  EXPECT_EQ(name("1003subFE"), (SectionName{.kind = SubObject, .index = 0x1003, .sub_index = 0xFE}));
  EXPECT_EQ(name("1F81Value"), (SectionName{.kind = Values, .index = 0x1F81}));
  EXPECT_EQ(name("1F81NAME"), (SectionName{.kind = Names, .index = 0x1F81}));
  EXPECT_EQ(name("1F81Denotation"), (SectionName{.kind = Denotations, .index = 0x1F81}));
  EXPECT_EQ(name("1000ObjectLinks"), (SectionName{.kind = ObjectLinks, .index = 0x1000}));
}

TEST(SectionName, TakesModulesApart) {
  using enum SectionKind;
  const auto name = parse_section_name;

  EXPECT_EQ(name("M1ModuleInfo"), (SectionName{.kind = ModuleInfo, .module = 1}));
  EXPECT_EQ(name("m12comments"), (SectionName{.kind = Comments, .module = 12}));
  EXPECT_EQ(name("M2FixedObjects"), (SectionName{.kind = FixedObjects, .module = 2}));
  EXPECT_EQ(name("M2SubExtends"), (SectionName{.kind = SubExtends, .module = 2}));
  EXPECT_EQ(name("M2Fixed6000"), (SectionName{.kind = Object, .module = 2, .index = 0x6000}));
  EXPECT_EQ(name("M2FIXED6000SUB3"),
            (SectionName{.kind = SubObject, .module = 2, .index = 0x6000, .sub_index = 3}));
  EXPECT_EQ(name("M2SubExt6000"), (SectionName{.kind = SubExtension, .module = 2, .index = 0x6000}));
}

TEST(SectionName, DoesNotGuess) {
  for (const char* const name :
       {"", "100", "10188", "101G", "1018sub", "1018subG", "1018sub100", "1018sub1x", "1018subs1", "M0ModuleInfo",
        "MModuleInfo", "M1", "M1Fixed", "M1Fixed60", "M1SubExt6000sub1", "Tool", "Tool1x", "StandardDataTypes"})
    EXPECT_EQ(parse_section_name(name), SectionName{}) << name;
}

TEST(SectionName, IsWrittenAsTheStandardDoes) {
  EXPECT_EQ(entry_section(0, 0x10FF, 0x1A), "10FFsub1A");
  EXPECT_EQ(entry_section(3, 0x1400, 0), "M3Fixed1400sub0");
}

}  // namespace
}  // namespace eds
