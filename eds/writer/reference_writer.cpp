#include "eds/writer/reference_writer.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

/// A section of the page: the objects from `first` to the next group.
struct Group {
  std::uint16_t first;
  std::string_view title;
};

constexpr std::array kGroups{
    Group{0x1000, "Communication and identity"}, Group{0x1200, "SDO servers"},
    Group{0x1400, "RPDO communication"},         Group{0x1600, "RPDO mapping"},
    Group{0x1800, "TPDO communication"},         Group{0x1A00, "TPDO mapping"},
    Group{0x5800, "Free process data"},          Group{0x6000, "Drive profile"},
};

constexpr std::string_view kHead = R"(# {title}

Every object of {device}. This page is generated from `{source}`, as are the dictionary that {device} serves
and the EDS files, so that they agree.

Numbers of index and sub-index are hexadecimal. A default in parentheses is what {device} starts with where the
EDS states none. `$NODEID` stands for the node-ID.{cob_ids} The last column says what an object does in the simulation.

Objects of an axis are given for axis 1.
Axis n has them (n - 1) times the offset higher:

| Objects of axis 1 | Offset |
|---|---|
)";

constexpr std::string_view kCobIds = R"( For COB-IDs the limits are those of the EDS; an identifier with
bit 31 set is accepted beyond them.)";

/// Other defaults than that of axis 1; a column each, where an entry has one.
struct Variant {
  std::string_view title;
  std::optional<Number> Entry::*value;
};
constexpr std::array kVariants{Variant{"Axes 2 to 8", &Entry::other_axes}, Variant{"Vector axis", &Entry::vector},
                               Variant{"Several axes", &Entry::several_axes}};

constexpr std::string_view kVariantHead = R"(
Entries whose default depends on the axis; mapping entries of every axis name its own objects:

)";

constexpr std::string_view kTableHead =
    "| Index | Sub | Name | Type | Access | PDO | Default | Low | High | Unit | In the simulation |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n";

constexpr std::string_view kParameterHead = R"(
## Parameters of the drive objects

Objects 2000h + parameter number, which the EDS files of the drive objects list; the sub-index is the parameter index,
from 0. The default SDO server shows those of the drive object p8630[0] (41B6h:00), of every parameter in parameters.md; the
servers 1201h to 1209h show those of their own drive object.

| Index | Sub | Of | Name | Type | Access | Default | Low | High | Unit |
|---|---|---|---|---|---|---|---|---|---|
)";

std::string text_of(const std::optional<Number>& number) {
  return number ? number->text : std::string{};
}

const Group& group_of(std::uint16_t index) {
  const Group* found = &kGroups.front();
  for (const Group& group : kGroups)
    if (group.first <= index) found = &group;
  return *found;
}

std::string default_of(const Entry& entry) {
  if (!entry.start.empty()) return "(" + entry.start + ")";
  return entry.default_stated || entry.initial.text.empty() ? entry.initial.text : "(" + entry.initial.text + ")";
}

std::string_view type_of(const Entry& entry) {
  return name_of(kDataTypes, entry.type).text;
}

std::string object_cells(const Entry& entry) {
  return fmt::format("{} | {} | {} | {} | {} | {} | {} | {} |", entry.name, type_of(entry),
                     name_of(kAccesses, entry.access).text, entry.pdo_mappable ? "yes" : "", default_of(entry),
                     text_of(entry.low), text_of(entry.high), entry.unit);
}

std::string parameter_cells(const Object& object, const Entry& entry) {
  return fmt::format("{} | {} | {} | {} | {} | {} | {} | {} |", name_of(kParameterScopes, object.scope).text,
                     entry.name, type_of(entry), name_of(kAccesses, entry.access).text, default_of(entry),
                     text_of(entry.low), text_of(entry.high), entry.unit);
}

/// One line for neighbouring entries that differ in nothing but the sub-index; @p cells gives the columns after
/// it,
/// @p ending the last one.
template <class Cells>
std::string entry_lines(const Object& object, const Cells& cells, std::string_view ending) {
  std::string text;
  for (std::size_t n = 0; n < object.entries.size();) {
    const std::string shown = cells(object.entries[n]);
    std::size_t last = n;
    while (last + 1 < object.entries.size() && cells(object.entries[last + 1]) == shown) ++last;
    const std::string to = last == n ? "" : fmt::format("–{:02X}", object.entries[last].sub_index);
    text +=
        fmt::format("| {:04X} | {:02X}{} | {}{}\n", object.index, object.entries[n].sub_index, to, shown, ending);
    n = last + 1;
  }
  return text;
}

std::string object_lines(const Object& object) {
  const bool variable = object.code == ObjectCode::Variable;
  std::string text;
  if (!variable)
    text = fmt::format("| {:04X} | | **{}** | {} | | | | | | | {} |\n", object.index, object.name,
                       name_of(kObjectCodes, object.code).text, object.does);
  return text + entry_lines(object, object_cells, variable ? fmt::format(" {} |", object.does) : "  |");
}

std::string offset_lines(const Catalogue& catalogue) {
  std::string text;
  for (const AxisOffset& row : catalogue.axis_offsets)
    text += fmt::format("| {:04X}–{:04X} | {:X} |\n", row.first, row.last, row.offset);
  return text;
}

bool any_entry(const Catalogue& catalogue, const auto& holds) {
  return std::ranges::any_of(catalogue.objects, [&](const Object& object) {
    return std::ranges::any_of(object.entries, [&](const Entry& entry) { return holds(object, entry); });
  });
}

std::string head(const Catalogue& catalogue, std::string_view source) {
  const bool owned = any_entry(catalogue, [](const Object& object, const Entry& entry) {
    return entry.limit_check == canopen::LimitCheck::Owner &&
           find_cob_id(object.index, entry.sub_index) != nullptr;
  });
  return fmt::format(kHead, fmt::arg("title", catalogue.header.page_title),
                     fmt::arg("device", catalogue.header.device), fmt::arg("source", source),
                     fmt::arg("cob_ids", owned ? kCobIds : ""));
}

/// The variants that entries have.
std::vector<Variant> variants_of(const Catalogue& catalogue) {
  std::vector<Variant> variants;
  std::ranges::copy_if(kVariants, std::back_inserter(variants), [&](const Variant& variant) {
    return any_entry(catalogue,
                     [&](const Object&, const Entry& entry) { return (entry.*variant.value).has_value(); });
  });
  return variants;
}

std::string variant_head(std::span<const Variant> variants) {
  const bool of_types =
      std::ranges::any_of(variants, [](const Variant& variant) { return variant.value == &Entry::vector; });
  std::string head = fmt::format("| Index | Sub | Name | {} |", of_types ? "Axis 1, servo" : "Default");
  std::string rule = "|---|---|---|---|";
  for (const Variant& variant : variants) {
    head += fmt::format(" {} |", variant.title);
    rule += "---|";
  }
  return fmt::format("{}{}\n{}\n", kVariantHead, head, rule);
}

std::string variant_lines(const Catalogue& catalogue) {
  const std::vector<Variant> variants = variants_of(catalogue);
  std::string text = variant_head(variants);
  for (const Object& object : catalogue.objects)
    for (const Entry& entry : object.entries) {
      if (std::ranges::none_of(variants, [&](const Variant& v) { return (entry.*v.value).has_value(); })) continue;
      text += fmt::format("| {:04X} | {:02X} | {} | {} |", object.index, entry.sub_index, entry.name,
                          entry.initial.text);
      for (const Variant& variant : variants) text += fmt::format(" {} |", text_of(entry.*variant.value));
      text += "\n";
    }
  return text;
}

std::string parameter_lines(const Catalogue& catalogue) {
  if (catalogue.parameters.empty()) return {};
  std::string text{kParameterHead};
  for (const Object& object : catalogue.parameters)
    text += entry_lines(
        object, [&](const Entry& entry) { return parameter_cells(object, entry); }, "");
  return text;
}

}  // namespace

std::string write_reference(const Catalogue& catalogue, std::string_view source) {
  std::string page = head(catalogue, source) + offset_lines(catalogue) + variant_lines(catalogue);
  const Group* current = nullptr;
  for (const Object& object : catalogue.objects) {
    const Group& group = group_of(object.index);
    if (&group != current) page += fmt::format("\n## {}\n\n{}", group.title, kTableHead);
    current = &group;
    page += object_lines(object);
  }
  return page + parameter_lines(catalogue);
}

}  // namespace eds
