#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "eds/lint/rules.hpp"
#include "eds/sheet/info_reader.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

/// What a list of kObjectLists says in a file.
constexpr std::array kListed{&DataSheet::mandatory, &DataSheet::optional, &DataSheet::manufacturer};
static_assert(kListed.size() == kObjectLists.size());

std::string hexadecimal(std::uint64_t index) {
  return fmt::format("0x{:04X}", index);
}

/// What an object list says against the sections; @p listed are those that other lists have named.
void check_list(const DataSheet& sheet, std::size_t row, std::set<std::uint64_t>& listed, Findings& findings) {
  const NumberedList& list = sheet.*kListed[row];
  check_numbers(list, findings);
  std::set<std::uint64_t> own;
  for (const auto& item : list.items) {
    if (!item.number) continue;
    const auto index = static_cast<std::uint16_t>(*item.number);
    if (!sheet.objects.contains(index))
      findings.error("list-section", item.number.place(), fmt::format("a section [{:04X}]", index), "none");
    if (!kObjectLists[row].contains(index))
      findings.error("list-wrong", item.number.place(),
                     fmt::format("{} in {}", hexadecimal(index), list_of(index)), kObjectLists[row].section);
    if (own.insert(index).second && !listed.insert(index).second)
      findings.error("list-duplicate", item.number.place(), "each object in one list", hexadecimal(index));
  }
}

/// An entry without which a file describes no CANopen device (CiA 301, 7.5.2).
struct MandatoryEntry {
  std::uint16_t index;
  std::uint8_t sub_index;
};
constexpr std::array kMandatory{MandatoryEntry{0x1000, 0}, MandatoryEntry{0x1001, 0}, MandatoryEntry{0x1018, 0},
                                MandatoryEntry{0x1018, 1}};

void check_mandatory(const DataSheet& sheet, Findings& findings) {
  const Section* const list = sheet.mandatory.section;
  for (const MandatoryEntry& row : kMandatory) {
    if (find_entry(sheet.objects, row.index, row.sub_index) != nullptr) continue;
    const auto object = sheet.objects.find(row.index);
    const Place place = object != sheet.objects.end() ? object->second.place()
                        : list != nullptr             ? list->place()
                                                      : Place{};
    findings.error("mandatory-object", place, fmt::format("entry {:04X}h:{:02X}", row.index, row.sub_index),
                   "none");
  }
}

/// What other objects an object is linked with (CiA 306, ObjectLinks).
void check_links(const DataSheet& sheet, const Section& section, Findings& findings) {
  const NumberedList links = read_list(*sheet.document, section.name(), "ObjectLinks", findings);
  check_numbers(links, findings);
  for (const auto& item : links.items)
    if (item.number && !sheet.objects.contains(static_cast<std::uint16_t>(*item.number)))
      findings.error("list-section", item.number.place(), fmt::format("a section [{:04X}]", *item.number), "none");
}

}  // namespace

void check_numbers(const NumberedList& list, Findings& findings) {
  std::map<std::uint64_t, const NumberedList::Item*> known;
  std::set<std::uint64_t> positions;
  for (const auto& item : list.items) {
    positions.insert(item.position);
    if (!item.number) continue;
    const auto [first, added] = known.emplace(*item.number, &item);
    if (!added)
      findings.error(
          "list-duplicate", item.number.place(),
          fmt::format("each object once, it stands in line {} already", first->second->number.place().line),
          item.number.text());
  }
  if (!list.count) return;
  if (*list.count != list.items.size())
    return findings.error("list-count", list.count.place(),
                          fmt::format("{}, as many as follow", list.items.size()), list.count.text());
  std::uint64_t expected = 1;
  for (const std::uint64_t position : positions)
    if (position != expected++)
      return findings.error("list-gap", list.count.place(), fmt::format("key {} next", expected - 1),
                            fmt::format("{}", position));
}

void check_lists(const DataSheet& sheet, Findings& findings) {
  std::set<std::uint64_t> listed;
  for (std::size_t row = 0; row < kObjectLists.size(); ++row) check_list(sheet, row, listed, findings);
  for (const auto& [index, object] : sheet.objects)
    if (!listed.contains(index))
      findings.error("list-missing", object.place(), fmt::format("{} in {}", hexadecimal(index), list_of(index)),
                     "it is in no list");
  check_mandatory(sheet, findings);
  for (const Section& section : sheet.document->sections())
    if (parse_section_name(section.name()).kind == SectionKind::ObjectLinks &&
        parse_section_name(section.name()).module == 0 && sheet.document->find(section.name()) == &section)
      check_links(sheet, section, findings);
}

}  // namespace eds
