#include "tests/eds/rules/eds_rules.hpp"

#include <algorithm>
#include <functional>
#include <ostream>

#include <gtest/gtest.h>

namespace eds_test {
namespace {

const std::string kUnit = "axisd-unit.eds";

class EveryEds : public testing::TestWithParam<const char*> {};

TEST_P(EveryEds, KeepsTheRulesOfTheStandard) {
  EXPECT_EQ(breaches_of(generated_eds(GetParam())), Breaches{});
}

TEST_P(EveryEds, BearsTheNameOfItsFile) {
  EXPECT_EQ(generated_eds(GetParam()).at("FileInfo").at("FileName"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Generated, EveryEds,
                         testing::Values("axisd.eds", "axisd-2-axes.eds", "axisd-3-axes.eds", "axisd-4-axes.eds",
                                         "axisd-5-axes.eds", "axisd-6-axes.eds", "axisd-7-axes.eds",
                                         "axisd-8-axes.eds", "axisd-unit.eds", "axisd-control-unit.eds",
                                         "axisd-servo.eds", "axisd-vector.eds", "axisd-cia402.eds",
                                         "axisd-cia402-2-axes.eds", "axisd-cia402-3-axes.eds",
                                         "axisd-cia402-4-axes.eds", "axisd-cia402-5-axes.eds",
                                         "axisd-cia402-6-axes.eds", "axisd-cia402-7-axes.eds",
                                         "axisd-cia402-8-axes.eds"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::erase_if(name, [](char c) { return c == '-' || c == '.'; });
                           return name;
                         });

/// A change of an EDS and the breach that it must bring.
struct Case {
  const char* name;
  std::string file;
  std::function<void(EdsFile&)> change;
  std::string breach;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

void set(EdsFile& file, const std::string& section, const std::string& key, const std::string& value) {
  file.find(section)->second[key] = value;
}
auto setting(const std::string& section, const std::string& key, const std::string& value) {
  return [=](EdsFile& file) { set(file, section, key, value); };
}
auto erasing(const std::string& section) {
  return [=](EdsFile& file) { file.erase(file.find(section)); };
}

class BrokenEds : public testing::TestWithParam<Case> {};

TEST_P(BrokenEds, IsNoticed) {
  EdsFile file = generated_eds(GetParam().file);
  GetParam().change(file);

  const Breaches breaches = breaches_of(file);

  EXPECT_NE(std::ranges::find(breaches, GetParam().breach), breaches.end()) << testing::PrintToString(breaches);
}

const Case kBroken[] = {
    {"UnknownSection", "axisd.eds", [](EdsFile& f) { f["Tools"]; }, "Tools: unknown section"},
    {"LeadingZeroOfASubIndex", "axisd.eds", [](EdsFile& f) { f["1018sub01"]; }, "1018sub01: unknown section"},
    {"MissingSection", "axisd.eds", erasing("DummyUsage"), "DummyUsage: missing"},
    {"UnknownKey", "axisd.eds", setting("FileInfo", "Author", "x"), "FileInfo: key Author"},
    {"EmptyValue", "axisd.eds", setting("DeviceInfo", "OrderCode", ""), "DeviceInfo: key OrderCode"},
    {"Comments", "axisd.eds", setting("Comments", "Lines", "2"), "Comments: other keys"},
    {"ListTooShort", "axisd.eds", setting("OptionalObjects", "SupportedObjects", "1"),
     "OptionalObjects: does not count and list what is there"},
    {"ObjectNotListed", "axisd.eds", [](EdsFile& f) { f["1009"] = f.at("1008"); },
     "OptionalObjects: does not count and list what is there"},
    {"SubNumber", "axisd.eds", setting("1018", "SubNumber", "0x4"),
     "1018: SubNumber is not the number of sub-indices"},
    {"MissingSubIndex", "axisd.eds", erasing("1018sub2"), "1018: a gap between the sub-indices"},
    {"HighestSubIndex", "axisd.eds", setting("1018sub0", "DefaultValue", "0x3"),
     "1018: sub-index 0 does not tell the highest one"},
    {"ArrayOfTwoTypes", "axisd.eds", setting("1003sub5", "DataType", "0x0006"), "1003: an array of two types"},
    {"DataType", "axisd.eds", setting("6040", "DataType", "0x0020"), "6040: unknown data type"},
    {"Access", "axisd.eds", setting("6040", "AccessType", "r"), "6040: unknown access r"},
    {"LimitOutsideTheType", "axisd.eds", setting("6040", "HighLimit", "0x10000"),
     "6040: HighLimit is no value of the type"},
    {"DefaultBelowTheLimit", "axisd.eds", setting("605D", "DefaultValue", "-2"),
     "605D: DefaultValue is below the one before"},
    {"MappedWithoutDirection", "axisd.eds", setting("6040", "AccessType", "rw"),
     "6040: mappable without a direction or length"},
    {"MappedObjectMissing", "axisd.eds", setting("1600sub1", "DefaultValue", "0x60450010"),
     "1600: maps what cannot be mapped"},
    {"MappedLength", "axisd.eds", setting("1600sub1", "DefaultValue", "0x60400008"),
     "1600: maps what cannot be mapped"},
    {"MappingWithoutCommunication", "axisd.eds", erasing("1401"), "1401: sub-indices without their object"},
    {"NumberOfPdos", "axisd.eds", setting("DeviceInfo", "NrOfRXPDO", "4"),
     "DeviceInfo: NrOfRXPDO is not what the objects say"},
    {"Identity", "axisd.eds", setting("DeviceInfo", "ProductNumber", "0x5001"),
     "DeviceInfo: ProductNumber is not what the objects say"},
    {"NoModuleSection", "axisd.eds", erasing("SupportedModules"),
     "SupportedModules: without module list 1027h, or the other way round"},
    {"RealLimit", "axisd-servo.eds", setting("28D1", "LowLimit", "2.00"),
     "28D1: DefaultValue is below the one before"},
    {"RealForm", "axisd-servo.eds", setting("28D1", "LowLimit", "low"), "28D1: LowLimit is no value of the type"},
    {"ParameterArray", "axisd-servo.eds", erasing("23B3sub0"), "23B3: no sub-index 0"},
    {"ModuleInfo", kUnit, erasing("M3ModuleInfo"), "M3ModuleInfo: missing"},
    {"ModuleBeyondTheCount", kUnit, setting("SupportedModules", "NrOfEntries", "15"),
     "M16ModuleInfo: unknown section"},
    {"ModuleObjectNotListed", kUnit, erasing("M2Fixed6840"),
     "M2FixedObjects: does not count and list what is there"},
    {"ModuleObjectInTheDevice", kUnit, [](EdsFile& f) { f["6040"] = f.at("M1Fixed6040"); },
     "M1Fixed6040: stands outside the modules too"},
    {"ModuleMapsAnotherAxis", kUnit, setting("M2Fixed1640sub1", "DefaultValue", "0x60400010"),
     "M2Fixed1640: maps what cannot be mapped"},
    {"ModulesDisagree", kUnit, setting("M9Fixed6040", "DataType", "0x0003"),
     "M9Fixed6040: other than in another module"},
    {"ModuleWithoutExtension", kUnit, erasing("M1SubExt1027"), "M1: no entry of the module list"},
    {"ExtensionCount", kUnit, setting("M1SubExt1027", "Count", "0"), "M1SubExt1027: Count is not 1 or more"},
    {"ModuleIdentifierTwice", kUnit, setting("M2SubExt1027", "DefaultValue", "0x000B"),
     "M2: the module list tells it from no other one"},
};

INSTANTIATE_TEST_SUITE_P(EdsRules, BrokenEds, testing::ValuesIn(kBroken),
                         [](const auto& broken) { return std::string{broken.param.name}; });

}  // namespace
}  // namespace eds_test
