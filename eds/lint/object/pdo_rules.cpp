#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/lint/object/all_objects.hpp"
#include "eds/lint/rules.hpp"

namespace eds {
namespace {

using canopen::Access;

/// One direction of PDOs: their parameters, and what may travel in them (CiA 301, 7.5.2.35 to 38).
struct Direction {
  std::string_view name;
  std::uint16_t communication;
  std::uint16_t mapping;
  std::array<Access, 4> accesses;
};
constexpr std::uint16_t kPdos = 512;
constexpr std::array kDirections{
    Direction{"RPDO",
              0x1400,
              0x1600,
              {Access::WriteOnly, Access::ReadWrite, Access::ReadWriteWrite, Access::ReadWriteWrite}},
    Direction{
        "TPDO", 0x1800, 0x1A00, {Access::ReadOnly, Access::ReadWrite, Access::ReadWriteRead, Access::Constant}},
};
constexpr unsigned kMostBits = 64;
constexpr std::uint64_t kMostEntries = 64;
constexpr std::uint16_t kLastDummy = 0x1B;

/// What one entry of a mapping parameter says: index, sub-index and length in bits.
struct Mapped {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint8_t bits;
};

Mapped mapped_by(std::uint64_t value) {
  return {.index = static_cast<std::uint16_t>(value >> 16U),
          .sub_index = static_cast<std::uint8_t>(value >> 8U),
          .bits = static_cast<std::uint8_t>(value)};
}

/// Holds the mapping of one PDO, by default or of a DCF, against the objects.
class MappingRules {
 public:
  MappingRules(const DataSheet& sheet, const AllObjects& all, const Direction& direction, Findings& findings)
      : sheet_{sheet}, all_{all}, direction_{direction}, findings_{findings} {}

  void check(const SheetObject& mapping) {
    const SheetEntry* const count = mapping.find(0);
    if (count == nullptr || !count->effective() || count->effective()->integer.magnitude > kMostEntries) return;
    const std::uint64_t entries = count->effective()->integer.magnitude;
    unsigned bits = 0;
    for (std::uint64_t sub = 1; sub <= entries; ++sub) {
      const SheetEntry* const entry = mapping.find(static_cast<std::uint8_t>(sub));
      if (entry == nullptr)
        return findings_.error("mapping-count", place_of(*count, count->effective()),
                               fmt::format("at most {} entries, as there are", sub - 1),
                               count->effective().text());
      if (!entry->effective()) continue;
      const Mapped mapped = mapped_by(entry->effective()->integer.magnitude);
      bits += mapped.bits;
      check_entry(*entry, mapped);
    }
    if (bits > kMostBits)
      findings_.error("mapping-bits", mapping.place(), fmt::format("at most {} bits", kMostBits),
                      fmt::format("{}", bits));
  }

 private:
  void check_entry(const SheetEntry& entry, Mapped mapped) {
    if (mapped.index <= kLastDummy) return check_dummy(entry, mapped);
    const SheetEntry* const object = all_.entry(mapped.index, mapped.sub_index);
    if (object == nullptr) return report("mapping-object", entry, "an entry of the file");
    if (!object->mappable.value_or(false)) return report("mapping-object", entry, "an entry with PDOMapping=1");
    if (object->access && std::ranges::count(direction_.accesses, *object->access) == 0)
      report("mapping-direction", entry, fmt::format("an entry that a {} may have", direction_.name));
    const unsigned wanted = object->type != nullptr ? object->type->bits : 0;
    const bool boolean_as_byte = wanted == 1 && mapped.bits == 8;
    if (wanted != 0 && mapped.bits != wanted && !boolean_as_byte)
      report("mapping-length", entry, fmt::format("{} bits, the length of the entry", wanted));
  }

  void check_dummy(const SheetEntry& entry, Mapped mapped) {
    const auto dummy = sheet_.dummies.find(mapped.index);
    const bool used = dummy != sheet_.dummies.end() && dummy->second.value_or(false);
    if (direction_.mapping != kDirections[0].mapping || !used)
      return report("mapping-dummy", entry, "a dummy of DummyUsage, in an RPDO");
    const DataTypeRow* const type = find_data_type(mapped.index);
    if (type != nullptr && type->bits != mapped.bits)
      report("mapping-length", entry, fmt::format("{} bits, the length of the dummy", type->bits));
  }

  void report(std::string_view check, const SheetEntry& entry, std::string_view expected) {
    const Mapped mapped = mapped_by(entry.effective()->integer.magnitude);
    findings_.error(check, place_of(entry, entry.effective()), expected,
                    fmt::format("{:04X}h:{:02X}, {} bits", mapped.index, mapped.sub_index, mapped.bits));
  }

  const DataSheet& sheet_;
  const AllObjects& all_;
  const Direction& direction_;
  Findings& findings_;
};

void check_pair(const AllObjects& all, std::uint16_t index, std::uint16_t other, Findings& findings) {
  const SheetObject* const object = all.object(index);
  if (object == nullptr || all.object(other) != nullptr) return;
  findings.error("pdo-pair", object->place(), fmt::format("object {:04X}h beside it", other), "none");
}

}  // namespace

void check_pdos(const DataSheet& sheet, Findings& findings) {
  const AllObjects all{sheet};
  const bool compact = sheet.device_info.compact_pdo.value_or(0) != 0;  // some PDOs are described by number only
  for (const Direction& direction : kDirections) {
    for (std::uint16_t n = 0; n < kPdos && !compact; ++n) {
      const auto communication = static_cast<std::uint16_t>(direction.communication + n);
      const auto mapping = static_cast<std::uint16_t>(direction.mapping + n);
      check_pair(all, communication, mapping, findings);
      check_pair(all, mapping, communication, findings);
    }
    MappingRules rules{sheet, all, direction, findings};
    for_each_object(sheet, [&](const SheetObject& object) {
      if (object.index >= direction.mapping && object.index < direction.mapping + kPdos) rules.check(object);
    });
  }
}

}  // namespace eds
