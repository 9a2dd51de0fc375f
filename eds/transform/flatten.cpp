#include "eds/transform/flatten.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "eds/sheet/data_sheet.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

constexpr unsigned kHighestSub = 0xFE;
constexpr std::uint16_t kModuleList = 0x1027;  // with it goes the section SupportedModules

/// The name that a section of a module's object has in a plain file; empty for what goes.
std::string plain_name(std::string_view name) {
  const SectionName taken = parse_section_name(name);
  switch (taken.kind) {
    case SectionKind::Object:
      return object_section(0, taken.index);
    case SectionKind::SubObject:
      return entry_section(0, taken.index, taken.sub_index);
    case SectionKind::Names:
      return object_section(0, taken.index) + "Name";
    case SectionKind::Values:
      return object_section(0, taken.index) + "Value";
    case SectionKind::Denotations:
      return object_section(0, taken.index) + "Denotation";
    case SectionKind::ObjectLinks:
      return object_section(0, taken.index) + "ObjectLinks";
    default:
      return {};
  }
}

/// What the entries of one object that modules extend have come to.
struct Growth {
  unsigned next_sub = 1;
  unsigned free_bits = 0;  ///< of the last entry, for modules that bring single bits
};

class Flattener {
 public:
  Flattener(const DataSheet& sheet, Findings& findings)
      : sheet_{sheet}, findings_{findings}, result_{*sheet.document} {
    for (const auto& [index, object] : sheet.objects) {
      indices_.insert(index);
      if (!object.entries.empty()) growth_[index].next_sub = object.entries.back().sub_index + 1U;
    }
  }

  void plug(unsigned number) {
    const auto found = sheet_.modules.find(number);
    if (found == sheet_.modules.end() || found->second.info == nullptr) return refuse(number);
    const SheetModule& module = found->second;
    if (plugged_.insert(number).second) add_fixed(module);
    for (const auto& [index, extension] : module.extensions) extend(extension);
  }

  Document take() {
    for (const std::uint16_t index : extended_) count_subs(index);
    write_lists();
    write_pdo_counts();
    const bool listed = indices_.contains(kModuleList);
    if (listed) result_.section("SupportedModules").set("NrOfEntries", "0");
    result_.remove_sections([listed](std::string_view name) {
      const SectionName taken = parse_section_name(name);
      return taken.module != 0 || (taken.kind == SectionKind::SupportedModules && !listed) ||
             taken.kind == SectionKind::ConnectedModules;
    });
    return std::move(result_);
  }

 private:
  void refuse(unsigned number) {
    const Place place{.section = "SupportedModules", .key = {}, .line = 0};
    const std::uint64_t modules = sheet_.module_count.value_or(0);
    if (modules == 0) return findings_.error("module-number", place, "the modules of a modular file", "none");
    findings_.error("module-number", place, fmt::format("a module 1 to {}", modules), fmt::format("{}", number));
  }

  void copy(const Section& from, const std::string& name) {
    Section& to = result_.section(name);
    for (const Line& line : from.lines()) to.append(Line{line.text(), line.ending(), 0});
  }

  void add_fixed(const SheetModule& module) {
    std::set<std::uint16_t> added;
    for (const auto& [index, object] : module.objects)
      if (indices_.insert(index).second) {
        added.insert(index);
        if (!object.entries.empty()) growth_[index].next_sub = object.entries.back().sub_index + 1U;
      }
    for (const Section& section : sheet_.document->sections()) {
      const SectionName name = parse_section_name(section.name());
      const std::string plain = plain_name(section.name());
      if (name.module == module.number && !plain.empty() && added.contains(name.index) &&
          sheet_.document->find(section.name()) == &section)
        copy(section, plain);
    }
  }

  /// How many new entries @p extension makes.
  static unsigned new_entries(const SubExtension& extension, Growth& growth) {
    if (extension.bits == 0) return extension.entries;
    const unsigned size =
        extension.entry.type != nullptr && extension.entry.type->bits != 0 ? extension.entry.type->bits : 8U;
    unsigned entries = 0;
    for (; growth.free_bits < extension.bits; growth.free_bits += size) ++entries;
    growth.free_bits -= extension.bits;
    return entries;
  }

  void extend(const SubExtension& extension) {
    std::uint16_t index = extension.index;
    const unsigned entries = new_entries(extension, growth_[index]);
    const auto most = static_cast<unsigned>(extension.last_sub.value_or(0));
    for (unsigned n = 0; n < entries; ++n) {
      while (most != 0 && growth_[index].next_sub > most && index < 0xFFFF) ++index;
      if (growth_[index].next_sub > kHighestSub)
        return findings_.error("extension-object", extension.entry.section->place(),
                               fmt::format("at most {} sub-indices", kHighestSub),
                               fmt::format("no room for another one in {:04X}h", index));
      add_entry(extension, index);
    }
  }

  void add_entry(const SubExtension& extension, std::uint16_t index) {
    if (indices_.insert(index).second) add_object(extension, index);
    extended_.insert(index);
    const std::string name = entry_section(0, index, static_cast<std::uint8_t>(growth_[index].next_sub++));
    copy(*extension.entry.section, name);
    Section& section = *result_.find(name);
    section.remove("Count");
    section.remove("ObjExtend");
    section.set("ObjectType", "0x7");
  }

  /// An object that only modules fill.
  void add_object(const SubExtension& extension, std::uint16_t index) {
    Section& object = result_.section(object_section(0, index));
    object.set("ParameterName", extension.entry.name);
    object.set("ObjectType", "0x8");
    Section& count = result_.section(entry_section(0, index, 0));
    constexpr std::array<std::array<std::string_view, 2>, 6> kCount{{{"ParameterName", "Number of entries"},
                                                                     {"ObjectType", "0x7"},
                                                                     {"DataType", "0x0005"},
                                                                     {"AccessType", "ro"},
                                                                     {"DefaultValue", "0"},
                                                                     {"PDOMapping", "0"}}};
    for (const auto& [key, value] : kCount) count.set(key, value);
  }

  /// Lets SubNumber, and sub-index 0 where it says a number, tell of the entries that have come.
  void count_subs(std::uint16_t index) {
    unsigned subs = 0, highest = 0;
    for (unsigned sub = 0; sub <= kHighestSub; ++sub)
      if (result_.find(entry_section(0, index, static_cast<std::uint8_t>(sub))) != nullptr) ++subs, highest = sub;
    result_.section(object_section(0, index)).set("SubNumber", fmt::format("0x{:X}", subs));
    Section& count = result_.section(entry_section(0, index, 0));
    if (!count.value("DefaultValue").empty()) count.set("DefaultValue", fmt::format("0x{:X}", highest));
  }

  void write_lists() {
    std::map<std::string_view, std::set<std::uint16_t>> lists;
    for (const std::uint16_t index : indices_) lists[list_of(index)].insert(index);
    for (const auto& [name, indices] : lists) {
      Section& section = result_.section(name);
      section.set("SupportedObjects", fmt::format("{}", indices.size()));
      std::size_t position = 0;
      for (const std::uint16_t index : indices)
        section.set(fmt::format("{}", ++position), fmt::format("0x{:04X}", index));
    }
  }

  void write_pdo_counts() {
    const auto count = [this](std::uint16_t first, std::uint16_t last) {
      return fmt::format("{}", std::distance(indices_.lower_bound(first), indices_.upper_bound(last)));
    };
    Section& info = result_.section("DeviceInfo");
    info.set("NrOfRXPDO", count(0x1400, 0x15FF));
    info.set("NrOfTXPDO", count(0x1800, 0x19FF));
  }

  const DataSheet& sheet_;
  Findings& findings_;
  Document result_;
  std::set<unsigned> plugged_;
  std::set<std::uint16_t> indices_;
  std::set<std::uint16_t> extended_;
  std::map<std::uint16_t, Growth> growth_;
};

}  // namespace

Document flatten(const Document& document, std::span<const unsigned> modules, Findings& findings) {
  Findings reading{""};
  const DataSheet sheet = read_data_sheet(document, reading);
  const std::size_t before = findings.all().size();
  Flattener flattener{sheet, findings};
  for (const unsigned module : modules) flattener.plug(module);
  return findings.all().size() == before ? flattener.take() : document;
}

}  // namespace eds
