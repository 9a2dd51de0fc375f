#include "eds/writer/reference_writer.hpp"

#include <array>

#include <fmt/format.h>

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

constexpr std::string_view kHead = R"(# Objects

Every object of the unit. This page is generated from `eds/catalogue.json`, as are the dictionary that the unit serves
and the EDS files, so that they agree.

Numbers of index and sub-index are hexadecimal. A default in parentheses is what the unit starts with where the
EDS states none. `$NODEID` stands for the node-ID. For COB-IDs the limits are those of the EDS; an identifier with
bit 31 set is accepted beyond them. The last column says what an object does in the simulation.

Objects of an axis are given for axis 1.
Axis n has them (n - 1) times the offset higher:

| Objects of axis 1 | Offset |
|---|---|
)";

constexpr std::string_view kVariantHead = R"(
Entries whose default depends on the axis; mapping entries of every axis name its own objects:

| Index | Sub | Name | Axis 1, servo | Axes 2 to 8 | Vector axis |
|---|---|---|---|---|---|
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

std::string variant_lines(const Catalogue& catalogue) {
  std::string text;
  for (const Object& object : catalogue.objects)
    for (const Entry& entry : object.entries)
      if (entry.other_axes || entry.vector)
        text += fmt::format("| {:04X} | {:02X} | {} | {} | {} | {} |\n", object.index, entry.sub_index, entry.name,
                            entry.initial.text, text_of(entry.other_axes), text_of(entry.vector));
  return text;
}

}  // namespace

std::string write_reference(const Catalogue& catalogue) {
  std::string page =
      std::string{kHead} + offset_lines(catalogue) + std::string{kVariantHead} + variant_lines(catalogue);
  const Group* current = nullptr;
  for (const Object& object : catalogue.objects) {
    const Group& group = group_of(object.index);
    if (&group != current) page += fmt::format("\n## {}\n\n{}", group.title, kTableHead);
    current = &group;
    page += object_lines(object);
  }
  page += kParameterHead;
  for (const Object& object : catalogue.parameters)
    page += entry_lines(
        object, [&](const Entry& entry) { return parameter_cells(object, entry); }, "");
  return page;
}

}  // namespace eds
