#include "tests/eds/rules/eds_rules.hpp"

#include <array>

#include "tests/eds/rules/module_rules.hpp"

namespace eds_test {
namespace {

struct KnownSection {
  std::string_view name;
  std::set<std::string> keys;
};

const std::array<KnownSection, 3> kKnownSections{{
    {"FileInfo",
     {"FileName", "FileVersion", "FileRevision", "EDSVersion", "Description", "CreationTime", "CreationDate",
      "CreatedBy", "ModificationTime", "ModificationDate", "ModifiedBy"}},
    {"DeviceInfo",
     {"VendorName",   "VendorNumber",      "ProductName",    "ProductNumber", "RevisionNumber",
      "OrderCode",    "BaudRate_10",       "BaudRate_20",    "BaudRate_50",   "BaudRate_125",
      "BaudRate_250", "BaudRate_500",      "BaudRate_800",   "BaudRate_1000", "SimpleBootUpMaster",
      "Granularity",  "SimpleBootUpSlave", "GroupMessaging", "NrOfRXPDO",     "DynamicChannelsSupported",
      "NrOfTXPDO",    "LSS_Supported",     "CompactPDO"}},
    {"DummyUsage", {"Dummy0001", "Dummy0002", "Dummy0003", "Dummy0004", "Dummy0005", "Dummy0006", "Dummy0007"}},
}};

/// Which list an index belongs to.
struct IndexList {
  std::string name;
  bool (*contains)(unsigned index);
};
bool is_mandatory(unsigned index) {
  return index == 0x1000 || index == 0x1001 || index == 0x1018;
}
bool is_manufacturer(unsigned index) {
  return index >= 0x2000 && index < 0x6000;
}
bool is_optional(unsigned index) {
  return !is_mandatory(index) && !is_manufacturer(index);
}
const std::array<IndexList, 3> kIndexLists{{{"MandatoryObjects", is_mandatory},
                                            {"OptionalObjects", is_optional},
                                            {"ManufacturerObjects", is_manufacturer}}};

void check_known_sections(const EdsFile& file, std::set<std::string>& names, Breaches& breaches) {
  for (const KnownSection& known : kKnownSections) {
    const std::string name{known.name};
    names.insert(name);
    if (!file.contains(name)) {
      breaches.push_back(name + ": missing");
      continue;
    }
    const Section& section = file.at(name);
    for (const auto& [key, value] : section)
      if (!known.keys.contains(key) || value.empty()) breaches.push_back(name + ": key " + key);
    for (const std::string& key : known.keys)
      if (!section.contains(key)) breaches.push_back(name + ": no " + key);
  }
}

void check_comments(const EdsFile& file, const std::string& name, Breaches& breaches) {
  const auto comments = file.find(name);
  if (comments == file.end()) return breaches.push_back(name + ": missing");
  const std::int64_t lines = number_at(comments->second, "Lines");
  for (std::int64_t n = 1; n <= lines; ++n)
    if (!comments->second.contains("Line" + std::to_string(n))) breaches.push_back(name + ": a line is missing");
  if (comments->second.size() != static_cast<std::size_t>(lines) + 1) breaches.push_back(name + ": other keys");
}

void check_lists(const EdsFile& file, const ObjectSet& device, std::set<std::string>& names, Breaches& breaches) {
  for (const IndexList& list : kIndexLists) {
    std::set<unsigned> members;
    for (const auto& [index, object] : device)
      if (list.contains(index)) members.insert(index);
    names.insert(list.name);
    check_index_list(file, list.name, "SupportedObjects", members, breaches);
  }
  for (const unsigned index : {0x1000U, 0x1001U, 0x1018U})
    if (!device.contains(index)) breaches.push_back(section_name("", index) + ": missing");
}

/// What the device says of itself agrees with its objects.
void check_device_info(const EdsFile& file, const ObjectSet& device, const ObjectSet& all, Breaches& breaches) {
  const auto info = file.find("DeviceInfo");
  if (info == file.end()) return;
  const auto expect = [&](const std::string& key, std::int64_t wanted) {
    const auto found = info->second.find(key);
    if (found == info->second.end() || number(found->second) != wanted)
      breaches.push_back("DeviceInfo: " + key + " is not what the objects say");
  };
  const std::size_t rpdos = count_objects(all, 0x1400, 0x15FF), tpdos = count_objects(all, 0x1800, 0x19FF);
  expect("NrOfRXPDO", static_cast<std::int64_t>(rpdos));
  expect("NrOfTXPDO", static_cast<std::int64_t>(tpdos));
  expect("Granularity", rpdos + tpdos == 0 ? 0 : 8);
  const std::array identity{"VendorNumber", "ProductNumber", "RevisionNumber"};
  for (unsigned sub = 1; sub <= identity.size(); ++sub) {
    const Section* const entry = entry_of(device, 0x1018, sub);
    if (entry == nullptr || !entry->contains("DefaultValue")) continue;
    expect(identity[sub - 1], number_at(*entry, "DefaultValue"));
  }
}

}  // namespace

void check_index_list(const EdsFile& file, const std::string& name, const std::string& count_key,
                      const std::set<unsigned>& listed, Breaches& breaches) {
  const auto list = file.find(name);
  if (list == file.end()) return breaches.push_back(name + ": missing");
  Section expected{{count_key, std::to_string(listed.size())}};
  std::size_t position = 0;
  for (const unsigned index : listed) expected[std::to_string(++position)] = "0x" + section_name("", index);
  if (list->second != expected) breaches.push_back(name + ": does not count and list what is there");
}

Breaches breaches_of(const EdsFile& file) {
  Breaches breaches;
  std::set<std::string> names{"Comments"};
  check_known_sections(file, names, breaches);
  const ObjectSet device = objects_of(file, "", names);
  check_lists(file, device, names, breaches);
  check_objects(device, "", breaches);
  check_pdos(device, device, "", breaches);
  const ObjectSet all = check_modules(file, device, names, breaches);
  check_device_info(file, device, all, breaches);
  for (const auto& [name, section] : file) {
    if (!names.contains(name)) breaches.push_back(name + ": unknown section");
    if (name.ends_with("Comments")) check_comments(file, name, breaches);
  }
  if (!file.contains("Comments")) breaches.emplace_back("Comments: missing");
  return breaches;
}

}  // namespace eds_test
