#include <algorithm>

#include <fmt/format.h>

#include "eds/lint/object/all_objects.hpp"
#include "eds/lint/object/standard_objects.hpp"
#include "eds/lint/rules.hpp"

namespace eds {
namespace {

constexpr std::uint8_t kStructure = 0xFF;  // sub-index that describes the object

Severity at_most_warning(const StandardEntry& row, Severity severity) {
  return row.framework ? Severity::Warning : severity;
}

bool is_structured(ObjectCode code) {
  return code == ObjectCode::Array || code == ObjectCode::Record;
}

std::string_view word_of(ObjectCode code) {
  return code == ObjectCode::Array ? "8 (ARRAY)" : code == ObjectCode::Record ? "9 (RECORD)" : "7 (VAR)";
}

/// Sub-indices of what is no array or record at all are another rule's.
void check_code(const SheetObject& object, const StandardEntry& row, Findings& findings) {
  if (!object.object_type || object.code() == row.code) return;
  const bool alike = is_structured(object.code()) && is_structured(row.code);
  if (!is_structured(object.code()) && object.has_subs) return;
  findings.add(at_most_warning(row, alike ? Severity::Warning : Severity::Error), "standard-code",
               object.object_type.place(), word_of(row.code), object.object_type.text());
}

std::string type_text(std::uint16_t number) {
  const DataTypeRow* const type = find_data_type(number);
  return fmt::format("0x{:04X} ({})", number, type == nullptr ? "" : type->name);
}

void check_type(const SheetEntry& entry, const StandardEntry& row, Findings& findings) {
  if (row.type == 0 || !entry.data_type || *entry.data_type == row.type) return;
  if (row.other_type != 0 && *entry.data_type == row.other_type) return;
  findings.add(at_most_warning(row, Severity::Error), "standard-type", place_of(entry, entry.data_type),
               type_text(row.type), entry.data_type.text());
}

void check_access(const SheetEntry& entry, const StandardEntry& row, Findings& findings) {
  if (!entry.access.stated() || !entry.access || row.access.allows(*entry.access)) return;
  findings.add(at_most_warning(row, row.access.severity), "standard-access", place_of(entry, entry.access),
               row.access.words, entry.access.text());
}

void check_value(const SheetEntry& entry, const Stated<Value>& value, const StandardEntry& row,
                 Findings& findings) {
  const bool number = value && (value->kind == ValueKind::Unsigned || value->kind == ValueKind::Signed);
  if (!number || value->node_relative || value->integer.negative) return;
  if (!row.values.allows(value->integer.magnitude))
    findings.add(at_most_warning(row, row.values.severity), "standard-value", place_of(entry, value),
                 row.values.words, value.text());
}

void check_default(const SheetEntry& entry, const StandardEntry& row, Findings& findings) {
  const Stated<Value>& value = entry.default_value;
  if (!row.standard_default || !value || value->integer == Integer{*row.standard_default}) return;
  findings.warning("standard-default", place_of(entry, value), fmt::format("{}", *row.standard_default),
                   value.text());
}

void check_entry(const SheetEntry& entry, const StandardEntry& row, Findings& findings) {
  check_type(entry, row, findings);
  check_access(entry, row, findings);
  if (entry.mappable.value_or(false) && !row.mappable && !row.framework)
    findings.warning("standard-mapping", place_of(entry, entry.mappable), "0", entry.mappable.text());
  check_value(entry, entry.parameter_value, row, findings);
  if (entry.compact && entry.sub_index == 0) return;  // its value is that of CompactSubObj
  check_value(entry, entry.default_value, row, findings);
  check_default(entry, row, findings);
}

/// The entries of an object, of those that CompactSubObj makes alike the first one.
void check_entries_of(const SheetObject& object, Findings& findings) {
  bool model_seen = false;
  for (const SheetEntry& entry : object.entries) {
    if (entry.sub_index == kStructure && object.has_subs) continue;
    const StandardEntry* const row = find_standard_entry(object.index, entry.sub_index);
    const bool alike = entry.compact && entry.sub_index != 0;
    if (alike && model_seen) {
      if (row != nullptr) check_value(entry, entry.parameter_value, *row, findings);
      continue;
    }
    model_seen = model_seen || alike;
    if (row != nullptr) {
      check_entry(entry, *row, findings);
    } else if (object.has_subs) {
      findings.warning("standard-sub", entry.section->place(),
                       fmt::format("no sub-index {:02X}h of {:04X}h", entry.sub_index, object.index), "one");
    }
  }
}

/// What PDOs and SDOs cannot do without is an error, the rest may be what a tool left out.
void check_needed(const SheetObject& object, const AllObjects& all, Findings& findings) {
  if (object.entries.empty()) return;
  for (const StandardEntry& row : standard_entries(object.index)) {
    if (!row.needed) continue;
    const bool only_one = row.code == ObjectCode::Array;
    for (unsigned sub = row.first_sub; sub <= (only_one ? row.first_sub : row.last_sub); ++sub) {
      if (all.entry(object.index, static_cast<std::uint8_t>(sub)) != nullptr) continue;
      findings.add(row.code == ObjectCode::Record ? Severity::Error : Severity::Warning, "standard-sub",
                   object.place(), fmt::format("sub-index {:02X}h", sub), "none");
    }
  }
}

}  // namespace

void check_standard_objects(const DataSheet& sheet, Findings& findings) {
  const AllObjects all{sheet};
  for_each_object(sheet, [&](const SheetObject& object) {
    const auto rows = standard_entries(object.index);
    if (rows.empty()) return;
    check_code(object, rows.front(), findings);
    const bool structured_wrongly = object.has_subs != is_structured(rows.front().code);
    if (structured_wrongly) return;
    check_entries_of(object, findings);
    check_needed(object, all, findings);
  });
  for (const auto& [number, module] : sheet.modules)
    for (const auto& [index, extension] : module.extensions)
      if (const StandardEntry* const row = find_standard_entry(index, 1))
        check_entry(extension.entry, *row, findings);
}

}  // namespace eds
