#include "eds/writer/module_writer.hpp"

#include <array>

#include "eds/catalogue/axes.hpp"

namespace eds {
namespace {

constexpr std::string_view kModulesSection = "SupportedModules";

/// One type of module; numbers of modules count from 1.
struct Module {
  unsigned number;
  unsigned axis;
  DriveType type;
  std::string_view type_name;
};

struct TypeName {
  DriveType type;
  std::string_view name;
};
constexpr std::array kTypeNames{TypeName{DriveType::Servo, "Servo"}, TypeName{DriveType::Vector, "Vector"}};

std::string section_of(const Module& module, std::string_view name) {
  return fmt::format("M{}{}", module.number, name);
}

void write_info(Lines& lines, const Module& module, const Entry& listed) {
  lines.section(section_of(module, "ModuleInfo"));
  lines.add("ProductName", fmt::format("{} axis {}", module.type_name, module.axis));
  lines.add("ProductVersion", 1);
  lines.add("ProductRevision", 0);
  lines.add("OrderCode", listed.initial.text);
}

void write_comments(Lines& lines, const Module& module) {
  lines.section(section_of(module, "Comments"));
  lines.add("Lines", 1);
  lines.add("Line1",
            fmt::format("Only for place {} of the module list, after every place before it.", module.axis));
}

void write_fixed_objects(Lines& lines, const Module& module, std::span<const Object> objects) {
  std::vector<const Object*> fixed;
  for (const Object& object : objects) fixed.push_back(&object);
  write_index_list(lines, section_of(module, "FixedObjects"), "NrOfEntries", fixed);
  for (const Object& object : objects) write_object(lines, section_of(module, "Fixed"), object);
}

/// The module's entry of the module list: one sub-index behind those of the modules before it.
void write_extension(Lines& lines, const Module& module, const Object& list, const Entry& listed) {
  const std::array extended{&list};
  write_index_list(lines, section_of(module, "SubExtends"), "NrOfEntries", extended);
  lines.section(section_of(module, fmt::format("SubExt{:04X}", list.index)));
  write_entry(lines, listed);
  lines.add("Count", 1);
  lines.add("ObjExtend", 0);
}

void write_module(Lines& lines, const Catalogue& catalogue, const Object& list, const Module& module) {
  const std::vector<DriveType> axes(module.axis, module.type);
  const Entry listed = module_list(list, axes).entries.back();
  write_info(lines, module, listed);
  write_comments(lines, module);
  write_fixed_objects(lines, module, axis_objects(catalogue, module.axis, module.type));
  write_extension(lines, module, list, listed);
}

}  // namespace

void write_modules(Lines& lines, const Catalogue& catalogue) {
  const auto list = std::ranges::find(catalogue.objects, kModuleList, &Object::index);
  if (list == catalogue.objects.end()) return write_no_modules(lines);
  lines.section(kModulesSection);
  lines.add("NrOfEntries", kTypeNames.size() * kMostAxes);
  unsigned number = 0;
  for (const TypeName& row : kTypeNames)
    for (unsigned axis = 1; axis <= kMostAxes; ++axis)
      write_module(lines, catalogue, *list,
                   {.number = ++number, .axis = axis, .type = row.type, .type_name = row.name});
}

void write_no_modules(Lines& lines) {
  lines.section(kModulesSection);
  lines.add("NrOfEntries", 0);
}

}  // namespace eds
