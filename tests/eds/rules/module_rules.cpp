#include "tests/eds/rules/module_rules.hpp"

#include "tests/eds/rules/eds_rules.hpp"

namespace eds_test {
namespace {

constexpr unsigned kModuleList = 0x1027;
const std::set<std::string> kInfoKeys{"ProductName", "ProductVersion", "ProductRevision", "OrderCode"};

/// One module of the file.
struct Module {
  std::string prefix;  ///< "M1"
  ObjectSet fixed;
  ObjectSet extensions;
};

std::set<unsigned> indices_of(const ObjectSet& objects) {
  std::set<unsigned> indices;
  for (const auto& [index, object] : objects) indices.insert(index);
  return indices;
}

void check_info(const EdsFile& file, const Module& module, Breaches& breaches) {
  const std::string name = module.prefix + "ModuleInfo";
  const auto info = file.find(name);
  if (info == file.end()) return breaches.push_back(name + ": missing");
  for (const std::string& key : kInfoKeys)
    if (!info->second.contains(key)) breaches.push_back(name + ": no " + key);
  if (info->second.size() != kInfoKeys.size()) breaches.push_back(name + ": unknown keys");
}

void check_extension(const Module& module, unsigned index, const ObjectSections& extension,
                     const ObjectSet& device, Breaches& breaches) {
  const std::string name = section_name(module.prefix + "SubExt", index);
  check_entry(name, *extension.head, {"Count", "ObjExtend"}, breaches);
  const auto extended = device.find(index);
  if (extended == device.end() || extended->second.subs.empty())
    breaches.push_back(name + ": extends what has no sub-indices");
  const auto count = extension.head->find("Count");
  if (count == extension.head->end() || number(count->second).value_or(0) < 1)
    breaches.push_back(name + ": Count is not 1 or more");
  if (module.fixed.contains(index)) breaches.push_back(name + ": fixed and extended");
}

/// The attributes of fixed objects that stand in several modules agree; only the default tells the modules apart.
void check_agreement(const Module& module, ObjectSet& known, Breaches& breaches) {
  for (const auto& [index, object] : module.fixed) {
    const auto [other, added] = known.emplace(index, object);
    if (added) continue;
    const auto attributes = [](const Section* section) {
      Section rest = section != nullptr ? *section : Section{};
      rest.erase("DefaultValue");
      return rest;
    };
    bool agree = attributes(object.head) == attributes(other->second.head) &&
                 object.subs.size() == other->second.subs.size();
    for (const auto& [sub, entry] : object.subs)
      agree =
          agree && other->second.subs.contains(sub) && attributes(entry) == attributes(other->second.subs.at(sub));
    if (!agree)
      breaches.push_back(section_name(module.prefix + "Fixed", index) + ": other than in another module");
  }
}

void check_module(const EdsFile& file, const Module& module, const ObjectSet& device, Breaches& breaches) {
  check_info(file, module, breaches);
  check_index_list(file, module.prefix + "FixedObjects", "NrOfEntries", indices_of(module.fixed), breaches);
  check_index_list(file, module.prefix + "SubExtends", "NrOfEntries", indices_of(module.extensions), breaches);
  check_objects(module.fixed, module.prefix + "Fixed", breaches);
  for (const auto& [index, object] : module.fixed)
    if (device.contains(index))
      breaches.push_back(section_name(module.prefix + "Fixed", index) + ": stands outside the modules too");
  ObjectSet all = device;
  all.insert(module.fixed.begin(), module.fixed.end());
  check_pdos(module.fixed, all, module.prefix + "Fixed", breaches);
  for (const auto& [index, object] : module.extensions) check_extension(module, index, object, device, breaches);
  if (!module.extensions.contains(kModuleList))
    breaches.push_back(module.prefix + ": no entry of the module list");
}

}  // namespace

ObjectSet check_modules(const EdsFile& file, const ObjectSet& device, std::set<std::string>& names,
                        Breaches& breaches) {
  ObjectSet all = device;
  const auto supported = file.find("SupportedModules");
  if ((supported != file.end()) != device.contains(kModuleList))
    breaches.emplace_back("SupportedModules: without module list 1027h, or the other way round");
  if (supported == file.end()) return all;
  names.insert("SupportedModules");
  const std::int64_t count = number_at(supported->second, "NrOfEntries");
  ObjectSet fixed;
  std::set<std::string> identifiers;
  for (std::int64_t n = 1; n <= count; ++n) {
    Module module{.prefix = "M" + std::to_string(n), .fixed = {}, .extensions = {}};
    module.fixed = objects_of(file, module.prefix + "Fixed", names);
    module.extensions = objects_of(file, module.prefix + "SubExt", names);
    for (const char* name : {"ModuleInfo", "Comments", "FixedObjects", "SubExtends"})
      names.insert(module.prefix + name);
    check_module(file, module, device, breaches);
    check_agreement(module, fixed, breaches);
    const Section* const listed = entry_of(module.extensions, kModuleList, 0);
    if (listed != nullptr && !identifiers.insert(listed->at("DefaultValue")).second)
      breaches.push_back(module.prefix + ": the module list tells it from no other one");
  }
  all.insert(fixed.begin(), fixed.end());
  return all;
}

}  // namespace eds_test
