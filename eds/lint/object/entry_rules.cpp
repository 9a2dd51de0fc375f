#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/lint/rules.hpp"

namespace eds {
namespace {

constexpr std::uint64_t kFirstRecord = 0x20;  // PDO parameters and so on, no simple type
constexpr std::uint64_t kLastType = 0x25F;    // of device profiles, CiA 301, table 44
constexpr std::uint64_t kKnownFlags = 0x3;
constexpr std::size_t kLongestMapped = 8;  // bytes of a PDO

/// DataType and AccessType are needed, except by what only counts or names others.
void check_presence(const SheetEntry& entry, Findings& findings) {
  if (entry.compact) return;
  if (!entry.data_type.stated()) findings.error("key-missing", entry.section->place("DataType"), "a value", "");
  if (!entry.access.stated()) findings.error("key-missing", entry.section->place("AccessType"), "a value", "");
}

void check_type(const SheetEntry& entry, Findings& findings) {
  if (!entry.data_type || entry.type != nullptr || !entry.data_type.stated()) return;
  if (*entry.data_type < kFirstRecord || *entry.data_type > kLastType)
    findings.error("data-type", entry.data_type.place(), "a data type of CiA 301", entry.data_type.text());
}

/// Two values of which the first must not be above the second.
struct Order {
  Stated<Value> SheetEntry::*low;
  Stated<Value> SheetEntry::*high;
  Stated<Value> SheetEntry::*wrong;  ///< of which the finding tells
  std::string_view check;
};
constexpr std::array kOrders{
    Order{&SheetEntry::low, &SheetEntry::high, &SheetEntry::low, "limit-order"},
    Order{&SheetEntry::low, &SheetEntry::default_value, &SheetEntry::default_value, "default-limits"},
    Order{&SheetEntry::default_value, &SheetEntry::high, &SheetEntry::default_value, "default-limits"},
    Order{&SheetEntry::low, &SheetEntry::parameter_value, &SheetEntry::parameter_value, "parameter-limits"},
    Order{&SheetEntry::parameter_value, &SheetEntry::high, &SheetEntry::parameter_value, "parameter-limits"},
};

/// Entries of CompactSubObj have their values alone, the rest is that of the model.
void check_limits(const SheetEntry& entry, NodeRange nodes, Findings& findings) {
  for (const Order& order : kOrders) {
    if (entry.compact && order.wrong != &SheetEntry::parameter_value) continue;
    const Stated<Value>& low = entry.*order.low;
    const Stated<Value>& high = entry.*order.high;
    const Stated<Value>& wrong = entry.*order.wrong;
    if (!low || !high || !wrong.stated() || ordered(*low, *high, nodes)) continue;
    const bool at_most = &wrong == &low;
    const Stated<Value>& limit = at_most ? high : low;
    findings.error(order.check, wrong.place(),
                   fmt::format("at {} {}", at_most ? "most" : "least", with_sign(limit.text(), *limit)),
                   with_sign(wrong.text(), *wrong));
  }
}

void check_node_id(const Stated<Value>& value, Findings& findings) {
  if (!value || !value->node_relative) return;
  const auto number = parse_integer(value.text());
  if (!number || !number->sum || !trimmed(value.text()).starts_with('$'))
    findings.warning("node-id-form", value.place(), "$NODEID+NUMBER", value.text());
}

/// Which PDOs an entry may travel in follows from its access (CiA 306, AccessType).
void check_mapping(const SheetEntry& entry, Findings& findings) {
  if (!entry.mappable.value_or(false) || entry.compact) return;
  const auto access = entry.access_or_default();
  if (entry.access && (access == canopen::Access::ReadWrite || access == canopen::Access::Constant))
    findings.warning("mapping-access", entry.access.place(), "ro, wo, rwr or rww of an entry with PDOMapping=1",
                     entry.access.text());
  if (entry.type == nullptr || entry.type->bits != 0) return;
  const bool fits = entry.type->kind == ValueKind::Text && entry.default_value &&
                    entry.default_value->text.size() <= kLongestMapped;
  if (!fits)
    findings.error("mapping-type", place_of(entry, entry.mappable),
                   fmt::format("0 for {} of any length", entry.type->name), entry.mappable.text());
}

void check_flags(const SheetEntry& entry, Findings& findings) {
  if (entry.flags && (*entry.flags & ~kKnownFlags) != 0)
    findings.warning("object-flags", entry.flags.place(), "bits 0 and 1 only", entry.flags.text());
}

void check_entry(const SheetEntry& entry, NodeRange nodes, Findings& findings) {
  check_limits(entry, nodes, findings);
  if (entry.compact) return;
  check_presence(entry, findings);
  check_type(entry, findings);
  check_mapping(entry, findings);
  check_flags(entry, findings);
  for (const auto* value : {&entry.low, &entry.high, &entry.default_value, &entry.parameter_value})
    check_node_id(*value, findings);
}

/// What the entries of CompactSubObj have in common is checked once.
void check_model(const SheetObject& object, NodeRange nodes, Findings& findings) {
  const auto found = std::ranges::find_if(
      object.entries, [](const SheetEntry& entry) { return entry.compact && entry.sub_index != 0; });
  if (found == object.entries.end()) return;
  SheetEntry model = *found;
  model.compact = false;
  model.parameter_value = {};
  check_entry(model, nodes, findings);
}

}  // namespace

void check_entries(const DataSheet& sheet, Findings& findings) {
  const NodeRange nodes = sheet.nodes();
  for_each_object(sheet, [&](const SheetObject& object) {
    check_model(object, nodes, findings);
    for (const SheetEntry& entry : object.entries) check_entry(entry, nodes, findings);
  });
  for (const auto& [number, module] : sheet.modules)
    for (const auto& [index, extension] : module.extensions) check_entry(extension.entry, nodes, findings);
}

}  // namespace eds
