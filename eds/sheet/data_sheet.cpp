#include "eds/sheet/data_sheet.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "eds/sheet/field_reader.hpp"
#include "eds/sheet/info_reader.hpp"
#include "eds/sheet/object_reader.hpp"

namespace eds {
namespace {

/// Every object of a file by module and index, and where its sections are.
using AllSections = std::map<std::pair<unsigned, std::uint16_t>, ObjectSections>;

/// The place for a section of @p kind; null where it belongs to no object.
const Section** place_for(ObjectSections& sections, const SectionName& name) {
  switch (name.kind) {
    case SectionKind::Object:
      return &sections.object;
    case SectionKind::SubObject:
      return &sections.subs[name.sub_index];
    case SectionKind::Names:
      return &sections.names;
    case SectionKind::Values:
      return &sections.values;
    case SectionKind::Denotations:
      return &sections.denotations;
    default:
      return nullptr;
  }
}

bool belongs_to_object(SectionKind kind) {
  return kind == SectionKind::Object || kind == SectionKind::SubObject || kind == SectionKind::Names ||
         kind == SectionKind::Values || kind == SectionKind::Denotations;
}

/// The document reports what stands twice under one name; this one what stands twice under two, "1018sub1" and
/// "1018sub01".
AllSections sections_of(const Document& document, Findings& findings) {
  AllSections all;
  for (const Section& section : document.sections()) {
    const SectionName name = parse_section_name(section.name());
    if (!belongs_to_object(name.kind) || document.find(section.name()) != &section) continue;
    const Section** const place = place_for(all[{name.module, name.index}], name);
    if (*place != nullptr)
      findings.error("duplicate-section", section.place(),
                     fmt::format("the entry once, it stands in line {} already", (*place)->header().number()),
                     section.name());
    else
      *place = &section;
  }
  return all;
}

/// The section @p suffix of module @p number.
std::string module_section(unsigned number, std::string_view suffix) {
  return fmt::format("M{}{}", number, suffix);
}

SheetModule& module_of(DataSheet& sheet, unsigned number) {
  return sheet.modules.try_emplace(number, SheetModule{.number = number}).first->second;
}

void read_modules(DataSheet& sheet, ObjectReader& objects, Findings& findings) {
  const Document& document = *sheet.document;
  for (const Section& section : document.sections()) {
    const SectionName name = parse_section_name(section.name());
    if (name.module == 0 || document.find(section.name()) != &section) continue;
    SheetModule& module = module_of(sheet, name.module);
    if (name.kind == SectionKind::ModuleInfo) module.info = &section;
    if (name.kind == SectionKind::SubExtension)
      module.extensions.try_emplace(name.index, objects.extension(name, section));
  }
  for (auto& [number, module] : sheet.modules) {
    module.fixed = read_list(document, module_section(number, "FixedObjects"), "NrOfEntries", findings);
    module.extended = read_list(document, module_section(number, "SubExtends"), "NrOfEntries", findings);
  }
}

}  // namespace

const SheetEntry* SheetObject::find(std::uint8_t sub_index) const noexcept {
  const auto found = std::ranges::find(entries, sub_index, &SheetEntry::sub_index);
  return found == entries.end() ? nullptr : &*found;
}

Place SheetObject::place() const noexcept {
  if (section != nullptr) return section->place();
  return entries.empty() ? Place{} : entries.front().section->place();
}

const SheetEntry* find_entry(const SheetObjects& objects, std::uint16_t index, std::uint8_t sub_index) noexcept {
  const auto found = objects.find(index);
  return found == objects.end() ? nullptr : found->second.find(sub_index);
}

bool NumberedList::contains(std::uint64_t number) const noexcept {
  return std::ranges::any_of(items, [number](const Item& item) { return item.number.value == number; });
}

NodeRange DataSheet::nodes() const noexcept {
  const std::uint64_t node = commissioning.node_id.value_or(0);
  if (node < kAnyNode.first || node > kAnyNode.last) return kAnyNode;
  return {.first = static_cast<unsigned>(node), .last = static_cast<unsigned>(node)};
}

DataSheet read_data_sheet(const Document& document, Findings& findings) {
  DataSheet sheet{.document = &document};
  read_info(sheet, findings);
  sheet.mandatory = read_list(document, "MandatoryObjects", "SupportedObjects", findings);
  sheet.optional = read_list(document, "OptionalObjects", "SupportedObjects", findings);
  sheet.manufacturer = read_list(document, "ManufacturerObjects", "SupportedObjects", findings);
  ObjectReader objects{findings, sheet.nodes()};
  read_modules(sheet, objects, findings);
  for (const auto& [key, sections] : sections_of(document, findings)) {
    const auto [module, index] = key;
    if (sections.object == nullptr && sections.subs.empty()) continue;
    SheetObject object = objects.object({.kind = SectionKind::Object, .module = module, .index = index}, sections);
    (module == 0 ? sheet.objects : module_of(sheet, module).objects).emplace(index, std::move(object));
  }
  return sheet;
}

}  // namespace eds
