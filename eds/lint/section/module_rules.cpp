#include <fmt/format.h>

#include "eds/lint/rules.hpp"

namespace eds {
namespace {

constexpr std::uint16_t kModuleList = 0x1027;

/// A list of a module against the sections that it names.
template <class Sections>
void check_list(const NumberedList& list, const Sections& sections, std::string_view prefix, Findings& findings) {
  check_numbers(list, findings);
  for (const auto& item : list.items)
    if (item.number && !sections.contains(static_cast<std::uint16_t>(*item.number)))
      findings.error("list-section", item.number.place(),
                     fmt::format("a section [{}{:04X}]", prefix, *item.number), "none");
}

void check_listed(const NumberedList& list, std::uint16_t index, const Place& place, std::string_view list_name,
                  Findings& findings) {
  if (!list.contains(index))
    findings.error("list-missing", place, fmt::format("0x{:04X} in {}", index, list_name), "it is in no list");
}

/// What is not there at all, or of a module that SupportedModules does not count.
void check_info(const DataSheet& sheet, const SheetModule& module, const Place& place, Findings& findings) {
  const std::string name = fmt::format("M{}ModuleInfo", module.number);
  if (module.info == nullptr) findings.error("module-count", place, fmt::format("a section [{}]", name), "none");
  if (module.number > sheet.module_count.value_or(0))
    findings.error(
        "module-count", place,
        fmt::format("a module 1 to {}, the NrOfEntries of SupportedModules", sheet.module_count.value_or(0)),
        fmt::format("{}", module.number));
}

/// Some section of @p module, to have a place.
Place place_of(const DataSheet& sheet, const SheetModule& module) {
  if (module.info != nullptr) return module.info->place();
  for (const Section& section : sheet.document->sections())
    if (parse_section_name(section.name()).module == module.number) return section.place();
  return {};
}

void check_extension(const DataSheet& sheet, const SheetModule& module, const SubExtension& extension,
                     Findings& findings) {
  const Place place = extension.entry.section->place();
  check_listed(module.extended, extension.index, place, fmt::format("M{}SubExtends", module.number), findings);
  const auto object = sheet.objects.find(extension.index);
  if (object != sheet.objects.end() && !object->second.has_subs)
    findings.error("extension-object", place, "an object with sub-indices", object_section(0, extension.index));
  if (module.objects.contains(extension.index))
    findings.error("module-overlap", place, "an object that the module does not bring itself",
                   object_section(module.number, extension.index));
}

bool same_attributes(const SheetObject& one, const SheetObject& other) {
  if (one.entries.size() != other.entries.size()) return false;
  for (std::size_t n = 0; n < one.entries.size(); ++n) {
    const SheetEntry &a = one.entries[n], &b = other.entries[n];
    if (a.sub_index != b.sub_index || a.data_type.value != b.data_type.value || a.access.value != b.access.value)
      return false;
  }
  return true;
}

/// Modules that bring the same object describe it alike.
void check_agreement(const SheetObject& object, SheetObjects& known, Findings& findings) {
  const auto [first, added] = known.try_emplace(object.index, object);
  if (added || same_attributes(object, first->second)) return;
  findings.warning(
      "module-agreement", object.place(),
      fmt::format("the entries, types and access of [{}]", object_section(first->second.module, object.index)),
      "others");
}

void check_module(const DataSheet& sheet, const SheetModule& module, SheetObjects& known, Findings& findings) {
  check_info(sheet, module, place_of(sheet, module), findings);
  check_list(module.fixed, module.objects, fmt::format("M{}Fixed", module.number), findings);
  check_list(module.extended, module.extensions, fmt::format("M{}SubExt", module.number), findings);
  for (const auto& [index, object] : module.objects) {
    check_listed(module.fixed, index, object.place(), fmt::format("M{}FixedObjects", module.number), findings);
    check_agreement(object, known, findings);
    if (sheet.objects.contains(index))
      findings.error("module-overlap", object.place(), "an object that the device does not have itself",
                     object_section(0, index));
  }
  for (const auto& [index, extension] : module.extensions) check_extension(sheet, module, extension, findings);
}

}  // namespace

void check_modules(const DataSheet& sheet, Findings& findings) {
  SheetObjects known;
  for (const auto& [number, module] : sheet.modules) check_module(sheet, module, known, findings);
  if (sheet.module_count && *sheet.module_count > sheet.modules.size())
    findings.error("module-count", sheet.module_count.place(),
                   fmt::format("{}, as there are", sheet.modules.size()), sheet.module_count.text());
  const Section* const supported = sheet.document->find("SupportedModules");
  const auto list = sheet.objects.find(kModuleList);
  if (supported != nullptr && list == sheet.objects.end())
    findings.error("module-list", supported->place(), "the module list, object 1027h", "none");
  if (supported == nullptr && list != sheet.objects.end())
    findings.error("module-list", list->second.place(), "a section SupportedModules", "none");
  for (const auto& item : sheet.connected_modules.items)
    if (item.number && (*item.number == 0 || *item.number > sheet.module_count.value_or(0)))
      findings.error("module-number", item.number.place(),
                     fmt::format("a module 1 to {}", sheet.module_count.value_or(0)), item.number.text());
}

}  // namespace eds
