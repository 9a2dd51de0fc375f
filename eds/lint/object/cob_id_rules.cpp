#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "eds/lint/object/all_objects.hpp"
#include "eds/lint/rules.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

constexpr std::uint64_t kInvalid = 0x80000000;
constexpr std::uint64_t kExtended = 0x20000000;
constexpr std::uint64_t kIdentifier = 0x7FF;

/// Identifiers that no configurable object may have (CiA 301, 7.3.5), but for 0, which stands for none yet.
struct Identifiers {
  std::uint64_t first, last;
};
constexpr std::array kRestricted{Identifiers{0x000, 0x07F}, Identifiers{0x101, 0x180}, Identifiers{0x581, 0x5FF},
                                 Identifiers{0x601, 0x67F}, Identifiers{0x6E0, 0x6FF}, Identifiers{0x701, 0x7FF}};

bool is_restricted(std::uint64_t identifier) {
  return std::ranges::any_of(kRestricted,
                             [=](const Identifiers& r) { return identifier >= r.first && identifier <= r.last; });
}

/// The predefined connection set (CiA 301, 7.3.3): the node-ID is added to all but SYNC and TIME.
struct Predefined {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint64_t base;
  bool node_relative;
};
constexpr std::array kPredefined{
    Predefined{0x1005, 0, 0x080, false}, Predefined{0x1012, 0, 0x100, false}, Predefined{0x1014, 0, 0x080, true},
    Predefined{0x1200, 1, 0x600, true},  Predefined{0x1200, 2, 0x580, true},  Predefined{0x1400, 1, 0x200, true},
    Predefined{0x1401, 1, 0x300, true},  Predefined{0x1402, 1, 0x400, true},  Predefined{0x1403, 1, 0x500, true},
    Predefined{0x1800, 1, 0x180, true},  Predefined{0x1801, 1, 0x280, true},  Predefined{0x1802, 1, 0x380, true},
    Predefined{0x1803, 1, 0x480, true},
};

/// One COB-ID of the file that is in use.
struct CobId {
  const SheetObject* object;
  const SheetEntry* entry;
  const CobIdObjects* row;

  [[nodiscard]] std::uint64_t at(unsigned node) const {
    const auto value = entry->effective()->at(node);
    return (value ? value->magnitude : 0) & kIdentifier;
  }
  [[nodiscard]] std::string name() const { return fmt::format("{:04X}h:{:02X}", object->index, entry->sub_index); }
};

bool is_used(const CobIdObjects& row, const Value& value) {
  const std::uint64_t bits = value.integer.magnitude;
  const bool valid = !row.bit31_is_invalid || (bits & kInvalid) == 0;
  return valid && (bits & kExtended) == 0;
}

/// COB-IDs in the order of their objects; what is disabled, has 29 bits or no default is left out.
std::vector<CobId> cob_ids_of(const DataSheet& sheet) {
  std::vector<CobId> list;
  const AllObjects all{sheet};
  for (const auto& [index, object] : all.all())
    for (const SheetEntry& entry : object->entries) {
      const CobIdObjects* const row = find_cob_id(index, entry.sub_index);
      if (row != nullptr && entry.effective() && is_used(*row, *entry.effective()))
        list.push_back({object, &entry, row});
    }
  return list;
}

void check_restricted(const CobId& id, NodeRange nodes, Findings& findings) {
  if (id.row->may_be_restricted) return;
  for (unsigned node = nodes.first; node <= nodes.last; ++node) {
    if (!is_restricted(id.at(node))) continue;
    return findings.error("cob-id-restricted", place_of(*id.entry, id.entry->effective()),
                          "an identifier that is not restricted",
                          fmt::format("{:03X}h on node {}", id.at(node), node));
  }
}

void check_predefined(const CobId& id, Findings& findings) {
  const auto* const row = std::ranges::find_if(kPredefined, [&id](const Predefined& p) {
    return p.index == id.object->index && p.sub_index == id.entry->sub_index;
  });
  if (row == kPredefined.end()) return;
  const Value& value = *id.entry->effective();
  if ((value.integer.magnitude & kIdentifier) == row->base && value.node_relative == row->node_relative) return;
  findings.warning("cob-id-predefined", place_of(*id.entry, id.entry->effective()),
                   fmt::format("{}0x{:X}", row->node_relative ? "$NODEID+" : "", row->base),
                   id.entry->effective().text());
}

void check_collisions(const std::vector<CobId>& ids, NodeRange nodes, Findings& findings) {
  std::map<const SheetEntry*, bool> reported;
  for (unsigned node = nodes.first; node <= nodes.last; ++node) {
    std::map<std::uint64_t, const CobId*> users;
    for (const CobId& id : ids) {
      const auto [first, added] = users.emplace(id.at(node), &id);
      if (added || !reported.emplace(id.entry, true).second) continue;
      findings.error("cob-id-collision", place_of(*id.entry, id.entry->effective()),
                     fmt::format("another identifier than {}", first->second->name()),
                     fmt::format("{:03X}h on node {}", id.at(node), node));
    }
  }
}

}  // namespace

void check_cob_ids(const DataSheet& sheet, Findings& findings) {
  const std::vector<CobId> ids = cob_ids_of(sheet);
  for (const CobId& id : ids) {
    check_restricted(id, sheet.nodes(), findings);
    if (!sheet.is_configuration()) check_predefined(id, findings);
  }
  check_collisions(ids, sheet.nodes(), findings);
}

}  // namespace eds
