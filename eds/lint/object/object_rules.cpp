#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/lint/object/standard_objects.hpp"
#include "eds/lint/rules.hpp"
#include "eds/sheet/field_reader.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

constexpr std::uint8_t kStructure = 0xFF;  // sub-index that describes the object; not counted
constexpr std::uint16_t kErrorField = 0x1003;
constexpr std::uint16_t kUnsigned8 = 5;
constexpr std::array kObjectCodeNumbers{0, 2, 5, 6, 7, 8, 9};

bool is_structured(const SheetObject& object) {
  const ObjectCode code = object.code();
  return code == ObjectCode::Array || code == ObjectCode::Record || code == ObjectCode::DefStruct;
}

/// Objects of the manufacturer may use sub-index 0 as they like.
bool is_standard(const SheetObject& object) {
  return !is_manufacturer(object.index);
}

void check_code(const SheetObject& object, Findings& findings) {
  if (!object.object_type) return;
  if (std::ranges::count(kObjectCodeNumbers, static_cast<int>(*object.object_type)) == 0)
    return findings.error("object-type", object.object_type.place(), "0, 2, 5, 6, 7, 8 or 9",
                          object.object_type.text());
  const bool compact = object.compact_count.value_or(0) != 0;
  if (!is_structured(object) && object.has_subs && !compact)
    findings.error("object-type", object.object_type.place(), "8 or 9, since it has sub-indices",
                   object.object_type.text());
}

void check_sub_number(const SheetObject& object, Findings& findings) {
  const bool compact = object.compact_count.value_or(0) != 0;
  const auto subs = static_cast<std::uint64_t>(
      std::ranges::count_if(object.entries, [](const SheetEntry& e) { return e.sub_index != kStructure; }));
  if (compact) {
    if (object.sub_number.value_or(0) != 0)
      findings.error("compact-form", object.sub_number.place(), "0 or nothing beside CompactSubObj",
                     object.sub_number.text());
    if (!is_structured(object))
      findings.error("compact-form", object.compact_count.place(), "object type 8 or 9", "another one");
    return;
  }
  if (!object.has_subs) {
    if (object.sub_number.value_or(0) != 0)
      findings.error("sub-count", object.sub_number.place(), "0, since it has no sub-indices",
                     object.sub_number.text());
    return;
  }
  const bool malformed = object.sub_number.stated() && !object.sub_number;
  if (subs == 0)
    return findings.error("sub-count", object.section->place("SubNumber"), "sub-indices, or CompactSubObj",
                          "none");
  if (!malformed && object.sub_number.value != subs)
    findings.error("sub-count", object.section->place("SubNumber"), fmt::format("{}, its sub-indices", subs),
                   object.sub_number.text());
}

/// Sub-index 0 of a structured object is the highest sub-index (CiA 301, 7.4.3).
void check_first_sub(const SheetObject& object, Findings& findings) {
  const SheetEntry* const first = object.find(0);
  if (first == nullptr) return findings.error("sub-zero", object.place(), "sub-index 0", "none");
  if (!is_standard(object) && first->data_type.value != kUnsigned8) return;
  if (first->data_type && *first->data_type != kUnsigned8)
    return findings.error("sub-zero", place_of(*first, first->data_type), "data type 0x0005",
                          first->data_type.text());
  if (!first->default_value || first->compact || !is_standard(object) || is_mapping_parameter(object.index))
    return;
  std::uint64_t highest = 0;
  for (const SheetEntry& entry : object.entries)
    if (entry.sub_index != kStructure) highest = entry.sub_index;
  const std::uint64_t stated = first->default_value->integer.magnitude;
  const auto access = first->access_or_default();
  const bool fixed = access == canopen::Access::ReadOnly || access == canopen::Access::Constant;
  if (stated > highest || (fixed && stated != highest && object.index != kErrorField))
    findings.error("sub-highest", first->default_value.place(),
                   fmt::format("{}{}", fixed ? "" : "at most ", highest), first->default_value.text());
}

/// Entries of standard objects are held against the type of the standard instead.
void check_array(const SheetObject& object, Findings& findings) {
  if (object.code() != ObjectCode::Array || !standard_entries(object.index).empty()) return;
  const SheetEntry* model = nullptr;
  for (const SheetEntry& entry : object.entries) {
    if (entry.sub_index == 0 || entry.sub_index == kStructure || !entry.data_type) continue;
    if (model == nullptr) model = &entry;
    if (*entry.data_type != *model->data_type)
      findings.error("array-type", place_of(entry, entry.data_type),
                     fmt::format("{}, the type of the entries before", model->data_type.text()),
                     entry.data_type.text());
  }
}

void check_subs(const SheetObject& object, Findings& findings) {
  constexpr auto kVariable = static_cast<std::uint64_t>(ObjectCode::Variable);
  constexpr auto kDomain = static_cast<std::uint64_t>(ObjectCode::Domain);
  for (const SheetEntry& entry : object.entries) {
    if (entry.compact || !entry.object_type) continue;
    if (*entry.object_type != kVariable && *entry.object_type != kDomain)
      findings.error("object-type", entry.object_type.place(), "7 of a sub-index", entry.object_type.text());
  }
}

void check_object(const SheetObject& object, Findings& findings) {
  if (object.section == nullptr)
    return findings.error("sub-parent", object.place(),
                          fmt::format("a section [{}]", object_section(object.module, object.index)), "none");
  check_code(object, findings);
  check_sub_number(object, findings);
  if (!object.has_subs) return;
  check_subs(object, findings);
  if (object.entries.empty()) return;
  check_first_sub(object, findings);
  check_array(object, findings);
}

/// xxxxName and its likes: for compact objects, counted, within the sub-indices.
void check_compact_list(const DataSheet& sheet, const Section& section, const SectionName& name,
                        Findings& findings) {
  const SheetObjects* objects = &sheet.objects;
  if (name.module != 0) objects = &sheet.modules.at(name.module).objects;
  const auto object = objects->find(name.index);
  const std::uint64_t most = object == objects->end() ? 0 : object->second.compact_count.value_or(0);
  if (most == 0)
    return findings.error("compact-form", section.place(), "an object with CompactSubObj",
                          object_section(name.module, name.index));
  std::uint64_t count = 0;
  for (const Line& line : section.lines()) {
    const auto number = entry_number(line.key());
    count += number ? 1U : 0U;
    if (number && *number > most)
      findings.error("compact-form", {.section = section.name(), .key = line.key(), .line = line.number()},
                     fmt::format("a sub-index 1 to {}", most), line.key());
  }
  const auto stated = FieldReader{section, findings}.number("NrOfEntries", 0xFF);
  if (stated && *stated != count)
    findings.error("list-count", stated.place(), fmt::format("{}, as many as follow", count), stated.text());
}

}  // namespace

void check_objects(const DataSheet& sheet, Findings& findings) {
  for_each_object(sheet, [&](const SheetObject& object) { check_object(object, findings); });
  for (const Section& section : sheet.document->sections()) {
    const SectionName name = parse_section_name(section.name());
    const bool list = name.kind == SectionKind::Names || name.kind == SectionKind::Values ||
                      name.kind == SectionKind::Denotations;
    if (list && sheet.document->find(section.name()) == &section)
      check_compact_list(sheet, section, name, findings);
  }
}

}  // namespace eds
