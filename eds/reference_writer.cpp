#include "eds/reference_writer.hpp"

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
    Group{0x1000, "Communication and identity"}, Group{0x1200, "SDO server"},
    Group{0x1400, "RPDO communication"},         Group{0x1600, "RPDO mapping"},
    Group{0x1800, "TPDO communication"},         Group{0x1A00, "TPDO mapping"},
    Group{0x2000, "Manufacturer specific"},      Group{0x6000, "Drive profile"},
};

constexpr std::string_view kHead = R"(# Objects

Every object of the unit with one axis. This page is generated from `eds/catalogue.json`, as are the dictionary
that the unit serves and the EDS file, so the three agree.

Numbers of index and sub-index are hexadecimal. A default in parentheses is what the unit starts with where the
EDS states none. `$NODEID` stands for the node-ID. For COB-IDs the limits are those of the EDS; an identifier with
bit 31 set is accepted beyond them.
)";

constexpr std::string_view kTableHead =
    "| Index | Sub | Name | Type | Access | PDO | Default | Low | High |\n"
    "|---|---|---|---|---|---|---|---|---|\n";

const Group& group_of(std::uint16_t index) {
  const Group* found = &kGroups.front();
  for (const Group& group : kGroups)
    if (group.first <= index) found = &group;
  return *found;
}

std::string cells(const Entry& entry) {
  const auto limit = [](const std::optional<Number>& number) { return number ? number->text : std::string{}; };
  const std::string initial = entry.default_stated ? entry.initial.text : "(" + entry.initial.text + ")";
  return fmt::format("{} | {} | {} | {} | {} | {} | {} |", entry.name, name_of(kDataTypes, entry.type).text,
                     name_of(kAccesses, entry.access).text, entry.pdo_mappable ? "yes" : "", initial,
                     limit(entry.low), limit(entry.high));
}

/// One line for neighbouring entries that differ in nothing but the sub-index.
std::string lines(const Object& object) {
  std::string text;
  if (object.code != ObjectCode::Variable)
    text += fmt::format("| {:04X} | | **{}** | {} | | | | | |\n", object.index, object.name,
                        name_of(kObjectCodes, object.code).text);
  for (std::size_t n = 0; n < object.entries.size();) {
    const std::string shown = cells(object.entries[n]);
    std::size_t last = n;
    while (last + 1 < object.entries.size() && cells(object.entries[last + 1]) == shown) ++last;
    const std::string to = last == n ? "" : fmt::format("–{:02X}", object.entries[last].sub_index);
    text += fmt::format("| {:04X} | {:02X}{} | {}\n", object.index, object.entries[n].sub_index, to, shown);
    n = last + 1;
  }
  return text;
}

}  // namespace

std::string write_reference(const Catalogue& catalogue) {
  std::string page{kHead};
  const Group* current = nullptr;
  for (const Object& object : catalogue.objects) {
    const Group& group = group_of(object.index);
    if (&group != current) page += fmt::format("\n## {}\n\n{}", group.title, kTableHead);
    current = &group;
    page += lines(object);
  }
  return page;
}

}  // namespace eds
