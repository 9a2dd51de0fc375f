#pragma once

#include <string_view>

#include "eds/document/finding.hpp"
#include "eds/sheet/data_sheet.hpp"

/// The rules that a data sheet is held against, a group a function. What is malformed has been reported by the
/// reader and is passed over here.
namespace eds {

/// Sections and keys: what is missing, what is unknown, form of names and dates. @p file as in lint().
void check_sections(const DataSheet& sheet, std::string_view file, Findings& findings);
/// Lists of objects against the sections, mandatory objects.
void check_lists(const DataSheet& sheet, Findings& findings);
/// Object types, sub-indices, CompactSubObj.
void check_objects(const DataSheet& sheet, Findings& findings);
/// Data types, access, limits and defaults, PDO mapping of entries.
void check_entries(const DataSheet& sheet, Findings& findings);
/// Objects 1000h to 1FFFh against the table of what CiA 301 and CiA 302 say of them.
void check_standard_objects(const DataSheet& sheet, Findings& findings);
/// PDOs: pairs of parameters, default mappings.
void check_pdos(const DataSheet& sheet, Findings& findings);
/// COB-IDs: restricted ones, collisions, the predefined connection set.
void check_cob_ids(const DataSheet& sheet, Findings& findings);
/// What DeviceInfo says against the objects.
void check_device_info(const DataSheet& sheet, Findings& findings);
/// Modules: numbers, objects, extensions.
void check_modules(const DataSheet& sheet, Findings& findings);
/// What makes a DCF: commissioning, values of parameters.
void check_configuration(const DataSheet& sheet, Findings& findings);

/// A list of objects or modules against its count: no gap, nothing twice.
void check_numbers(const NumberedList& list, Findings& findings);

/// Calls @p visit with each entry and its object, those of the modules too.
template <class Visit>
void for_each_object(const DataSheet& sheet, Visit visit) {
  for (const auto& [index, object] : sheet.objects) visit(object);
  for (const auto& [number, module] : sheet.modules)
    for (const auto& [index, object] : module.objects) visit(object);
}

/// Where the value of @p entry that @p stated holds stands; the section of the entry where it is implied.
template <class T>
[[nodiscard]] Place place_of(const SheetEntry& entry, const Stated<T>& stated) {
  return stated.stated() ? stated.place() : entry.section->place();
}

}  // namespace eds
