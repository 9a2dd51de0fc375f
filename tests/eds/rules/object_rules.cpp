#include "tests/eds/rules/object_rules.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>

namespace eds_test {
namespace {

constexpr std::int64_t kUnsigned8 = 5, kReal32 = 8, kVisibleString = 9;
constexpr unsigned kModuleList = 0x1027;

/// Width in bits of the integers by data type.
const std::map<std::int64_t, int> kIntegers{{1, 1}, {2, 8}, {3, 16}, {4, 32}, {5, 8}, {6, 16}, {7, 32}};

const std::set<std::string> kEntryKeys{"ParameterName", "ObjectType",   "DataType",   "LowLimit", "HighLimit",
                                       "AccessType",    "DefaultValue", "PDOMapping", "ObjFlags"};
const std::set<std::string> kHeadKeys{"ParameterName", "ObjectType", "SubNumber"};

constexpr unsigned kCompatibilityEntry = 4;

/// CiA 301 lets the communication parameters of PDOs do without their compatibility entry.
bool may_lack_entry(unsigned index) {
  return (index >= 0x1400 && index < 0x1600) || (index >= 0x1800 && index < 0x1A00);
}

bool is_parameter(unsigned index) {
  return index >= 0x2000 && index <= 0x470F;
}

/// Upper-case hexadecimal digits without anything else; -1 where @p text is something else.
int hexadecimal(std::string_view text) {
  const auto digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'); };
  if (text.empty() || text.size() > 4 || !std::ranges::all_of(text, digit)) return -1;
  return static_cast<int>(std::strtol(std::string{text}.c_str(), nullptr, 16));
}

std::string value_of(const Section& section, const std::string& key) {
  const auto found = section.find(key);
  return found == section.end() ? "" : found->second;
}

int type_of(const Section& entry) {
  return static_cast<int>(number(value_of(entry, "DataType")).value_or(0));
}

int bits_of(const Section& entry) {
  const auto found = kIntegers.find(type_of(entry));
  return found != kIntegers.end() ? found->second : type_of(entry) == kReal32 ? 32 : 0;
}

/// A value of an entry as a number that orders; nothing where it is not one of the type.
std::optional<double> ranked(const std::string& text, int type, std::int64_t node) {
  if (type == kReal32) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional{value};
  }
  const auto value = number(text, node);
  if (!value || !kIntegers.contains(type)) return std::nullopt;
  const std::int64_t values = std::int64_t{1} << kIntegers.at(type);
  const bool is_signed = type >= 2 && type <= 4;
  const std::int64_t low = is_signed ? -values / 2 : 0;
  if (*value < low || *value >= low + values) return std::nullopt;
  return static_cast<double>(*value);
}

void check_values(const std::string& name, const Section& entry, std::int64_t node, Breaches& breaches) {
  std::optional<double> previous;
  for (const char* key : {"LowLimit", "DefaultValue", "HighLimit"}) {
    if (!entry.contains(key)) continue;
    const auto value = ranked(value_of(entry, key), type_of(entry), node);
    if (!value) {
      breaches.push_back(name + ": " + key + " is no value of the type");
    } else if (previous && *previous > *value) {
      breaches.push_back(name + ": " + key + " is below the one before");
    }
    previous = value;
  }
}

void check_subs(unsigned index, const std::string& name, const ObjectSections& object, Breaches& breaches) {
  const Section& head = *object.head;
  for (const auto& [key, value] : head)
    if (!kHeadKeys.contains(key)) breaches.push_back(name + ": key " + key);
  if (number(value_of(head, "SubNumber")) != static_cast<std::int64_t>(object.subs.size()))
    breaches.push_back(name + ": SubNumber is not the number of sub-indices");
  if (!object.subs.contains(0)) return breaches.push_back(name + ": no sub-index 0");
  const bool is_array = value_of(head, "ObjectType") == "0x8";
  const unsigned first_equal = is_parameter(index) ? 0 : 1;
  const unsigned last = object.subs.rbegin()->first;
  const bool lacks_entry =
      may_lack_entry(index) && last > kCompatibilityEntry && !object.subs.contains(kCompatibilityEntry);
  if (last + 1 != object.subs.size() + (lacks_entry ? 1 : 0))
    breaches.push_back(name + ": a gap between the sub-indices");
  for (const auto& [sub, entry] : object.subs)
    if (is_array && sub > first_equal && type_of(*entry) != type_of(*object.subs.rbegin()->second))
      breaches.push_back(name + ": an array of two types");
  if (is_parameter(index)) return;
  const Section& first = *object.subs.at(0);
  const auto stated = number(value_of(first, "DefaultValue"));
  if (type_of(first) != kUnsigned8) breaches.push_back(name + ": sub-index 0 is not UNSIGNED8");
  const bool fixed = value_of(first, "AccessType") == "ro" && index != kModuleList;
  if ((fixed && stated != last) || stated.value_or(0) > last)
    breaches.push_back(name + ": sub-index 0 does not tell the highest one");
}

void check_object(unsigned index, std::string_view prefix, const ObjectSections& object, Breaches& breaches) {
  const std::string name = section_name(prefix, index);
  if (object.head == nullptr) return breaches.push_back(name + ": sub-indices without their object");
  const std::string code = value_of(*object.head, "ObjectType");
  if (code == "0x7") {
    check_entry(name, *object.head, {}, breaches);
    if (!object.subs.empty()) breaches.push_back(name + ": a variable with sub-indices");
    return;
  }
  if (code != "0x8" && code != "0x9") breaches.push_back(name + ": ObjectType " + code);
  check_subs(index, name, object, breaches);
  for (const auto& [sub, entry] : object.subs)
    check_entry(section_name(prefix, index, static_cast<int>(sub)), *entry, {}, breaches);
}

struct Direction {
  unsigned communication, mapping;
  std::array<const char*, 2> accesses;
};
constexpr unsigned kPdos = 0x200;
const std::array<Direction, 2> kDirections{{{0x1400, 0x1600, {"rww", "wo"}}, {0x1800, 0x1A00, {"ro", "rwr"}}}};

void check_mapping(const ObjectSections& mapping, const ObjectSet& all, const Direction& direction,
                   const std::string& name, Breaches& breaches) {
  std::int64_t bits = 0;
  const auto first = mapping.subs.find(0);
  const std::int64_t count =
      first == mapping.subs.end() ? 0 : number(value_of(*first->second, "DefaultValue")).value_or(0);
  for (unsigned sub = 1; sub <= count; ++sub) {
    const auto entry = mapping.subs.find(sub);
    const std::int64_t mapped =
        entry == mapping.subs.end() ? 0 : number(value_of(*entry->second, "DefaultValue")).value_or(0);
    const Section* const target =
        entry_of(all, static_cast<unsigned>(mapped >> 16), static_cast<unsigned>(mapped >> 8 & 0xFF));
    const bool fits = target != nullptr && value_of(*target, "PDOMapping") == "1" &&
                      std::ranges::count(direction.accesses, value_of(*target, "AccessType")) == 1 &&
                      (mapped & 0xFF) == bits_of(*target);
    if (!fits) breaches.push_back(name + ": maps what cannot be mapped");
    bits += mapped & 0xFF;
  }
  if (bits > 64) breaches.push_back(name + ": more than 64 bits");
}

}  // namespace

std::string section_name(std::string_view prefix, unsigned index, int sub_index) {
  std::array<char, 16> text{};
  if (sub_index < 0) {
    std::snprintf(text.data(), text.size(), "%04X", index);
  } else {
    std::snprintf(text.data(), text.size(), "%04Xsub%X", index, static_cast<unsigned>(sub_index));
  }
  return std::string{prefix} + text.data();
}

ObjectSet objects_of(const EdsFile& file, std::string_view prefix, std::set<std::string>& names) {
  ObjectSet objects;
  for (const auto& [name, section] : file) {
    if (!name.starts_with(prefix)) continue;
    const std::string rest = name.substr(prefix.size());
    const int index = hexadecimal(rest.substr(0, 4));
    if (index < 0) continue;
    const int sub = rest.size() > 7 && rest.substr(4, 3) == "sub" ? hexadecimal(rest.substr(7)) : -1;
    if (section_name(prefix, static_cast<unsigned>(index), sub) != name) continue;
    ObjectSections& object = objects[static_cast<unsigned>(index)];
    (sub < 0 ? object.head : object.subs[static_cast<unsigned>(sub)]) = &section;
    names.insert(name);
  }
  return objects;
}

const Section* entry_of(const ObjectSet& objects, unsigned index, unsigned sub_index) {
  const auto object = objects.find(index);
  if (object == objects.end()) return nullptr;
  if (object->second.subs.empty()) return sub_index == 0 ? object->second.head : nullptr;
  const auto entry = object->second.subs.find(sub_index);
  return entry == object->second.subs.end() ? nullptr : entry->second;
}

void check_entry(const std::string& name, const Section& entry, const std::set<std::string>& more_keys,
                 Breaches& breaches) {
  const std::set<std::string> accesses{"ro", "wo", "rw", "rwr", "rww", "const"};
  for (const auto& [key, value] : entry)
    if (!kEntryKeys.contains(key) && !more_keys.contains(key)) breaches.push_back(name + ": key " + key);
  if (value_of(entry, "ParameterName").empty()) breaches.push_back(name + ": no name");
  if (value_of(entry, "ObjectType") != "0x7") breaches.push_back(name + ": ObjectType is not VAR");
  const int type = type_of(entry);
  if (!kIntegers.contains(type) && type != kReal32 && type != kVisibleString)
    return breaches.push_back(name + ": unknown data type");
  const std::string access = value_of(entry, "AccessType");
  if (!accesses.contains(access)) breaches.push_back(name + ": unknown access " + access);
  const std::string mapping = value_of(entry, "PDOMapping");
  if (mapping != "0" && mapping != "1") breaches.push_back(name + ": PDOMapping is neither 0 nor 1");
  if (mapping == "1" && (access == "rw" || access == "const" || bits_of(entry) == 0))
    breaches.push_back(name + ": mappable without a direction or length");
  if (type == kVisibleString) return;
  for (const std::int64_t node : {1, 127}) check_values(name, entry, node, breaches);
}

void check_objects(const ObjectSet& objects, std::string_view prefix, Breaches& breaches) {
  for (const auto& [index, object] : objects) check_object(index, prefix, object, breaches);
}

void check_pdos(const ObjectSet& pdos, const ObjectSet& all, std::string_view prefix, Breaches& breaches) {
  for (const Direction& direction : kDirections)
    for (unsigned n = 0; n < kPdos; ++n) {
      const auto mapping = pdos.find(direction.mapping + n);
      const std::string name = section_name(prefix, direction.mapping + n);
      if (pdos.contains(direction.communication + n) != (mapping != pdos.end()))
        breaches.push_back(name + ": communication without mapping, or the other way round");
      if (mapping != pdos.end()) check_mapping(mapping->second, all, direction, name, breaches);
    }
}

std::size_t count_objects(const ObjectSet& objects, unsigned first, unsigned last) {
  return static_cast<std::size_t>(std::distance(objects.lower_bound(first), objects.upper_bound(last)));
}

}  // namespace eds_test
