#include "tests/fuzz/table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace fuzz {
namespace {

using canopen::Access;
using canopen::DataType;
using canopen::EntryDescription;
using canopen::LimitCheck;
using enum canopen::DataType;

using Table = std::vector<EntryDescription>;

constexpr auto kRw = Access::ReadWrite;
constexpr auto kRo = Access::ReadOnly;
constexpr auto kConst = Access::Constant;
constexpr std::int64_t kOff = 0x80000000;

constexpr std::int64_t real(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

/// One entry of the communication profile: index, sub-index, type, access, initial value, $NODEID added.
struct Row {
  std::uint16_t index;
  std::uint8_t sub_index;
  DataType type;
  Access access;
  std::int64_t initial = 0;
  bool node_relative = false;
};
constexpr std::array kProfile{
    Row{0x1000, 0, Unsigned32, kRo, 0x00020192},
    Row{0x1001, 0, Unsigned8, kRo},
    Row{0x1003, 0, Unsigned8, kRw},
    Row{0x1003, 1, Unsigned32, kRo},
    Row{0x1003, 2, Unsigned32, kRo},
    Row{0x1003, 3, Unsigned32, kRo},
    Row{0x1003, 4, Unsigned32, kRo},
    Row{0x1005, 0, Unsigned32, kRw, 0x80},
    Row{0x1006, 0, Unsigned32, kRw},
    Row{0x1007, 0, Unsigned32, kRw},
    Row{0x100C, 0, Unsigned16, kRw},
    Row{0x100D, 0, Unsigned8, kRw},
    Row{0x1010, 0, Unsigned8, kConst, 2},
    Row{0x1010, 1, Unsigned32, kRw, 1},
    Row{0x1010, 2, Unsigned32, kRw, 1},
    Row{0x1011, 0, Unsigned8, kConst, 2},
    Row{0x1011, 1, Unsigned32, kRw, 1},
    Row{0x1011, 2, Unsigned32, kRw, 1},
    Row{0x1012, 0, Unsigned32, kRw, 0x100},
    Row{0x1014, 0, Unsigned32, kRw, 0x80, true},
    Row{0x1015, 0, Unsigned16, kRw},
    Row{0x1016, 0, Unsigned8, kConst, 3},
    Row{0x1016, 1, Unsigned32, kRw},
    Row{0x1016, 2, Unsigned32, kRw},
    Row{0x1016, 3, Unsigned32, kRw, 0x00200064},
    Row{0x1017, 0, Unsigned16, kRw},
    Row{0x1018, 0, Unsigned8, kConst, 4},
    Row{0x1018, 1, Unsigned32, kRo, 0x2A},
    Row{0x1018, 2, Unsigned32, kRo, 0x00010002},
    Row{0x1018, 3, Unsigned32, kRo, 0x00030004},
    Row{0x1018, 4, Unsigned32, kRo, 0x12345678},
    Row{0x1019, 0, Unsigned8, kRw},
    Row{0x1029, 0, Unsigned8, kConst, 2},
    Row{0x1029, 1, Unsigned8, kRw},
    Row{0x1029, 2, Unsigned8, kRw},
    Row{0x1200, 0, Unsigned8, kConst, 2},
    Row{0x1200, 1, Unsigned32, kRo, 0x600, true},
    Row{0x1200, 2, Unsigned32, kRo, 0x580, true},
    Row{0x1201, 0, Unsigned8, kConst, 3},
    Row{0x1201, 1, Unsigned32, kRw, kOff},
    Row{0x1201, 2, Unsigned32, kRw, kOff},
    Row{0x1201, 3, Unsigned8, kRw},
    Row{0x1202, 0, Unsigned8, kConst, 3},
    Row{0x1202, 1, Unsigned32, kRw, 0x6A5},
    Row{0x1202, 2, Unsigned32, kRw, 0x6C5},
    Row{0x1202, 3, Unsigned8, kRw},
    Row{0xA000, 0, Unsigned16, kRw},
};

struct Limited {
  DataType type;
  std::int64_t low, high, initial;
};
constexpr std::array kLimited{
    Limited{Integer8, -10, 10, -9},
    Limited{Unsigned8, 5, 200, 6},
    Limited{Integer16, -1000, 1000, -999},
    Limited{Unsigned16, 1, 0xFFF0, 2},
    Limited{Integer24, -70000, 70000, -69999},
    Limited{Unsigned32, 1, 0xFFFFFFF0, 2},
    Limited{Integer64, -(1LL << 40), 1LL << 40, -(1LL << 40) + 1},
    Limited{Unsigned64, 16, -17, 17},  // to 0xFFFFFFFFFFFFFFEF
    Limited{Real32, real(-1.0F), real(1.0F), real(-0.5F)},
    Limited{Real64, std::bit_cast<std::int64_t>(-2.0), std::bit_cast<std::int64_t>(2.0), 0},
};
constexpr std::array kUnlimited{Boolean,    Integer8,   Unsigned8,  Integer16,      Unsigned16, Integer24,
                                Unsigned24, Integer32,  Unsigned32, Real32,         Integer40,  Unsigned40,
                                Integer48,  Unsigned48, TimeOfDay,  TimeDifference, Integer56,  Unsigned56,
                                Integer64,  Unsigned64, Real64};

constexpr std::array kOthers{
    EntryDescription{.index = 0x1008, .type = VisibleString, .access = kConst, .text = "Slave of the fuzzer"},
    EntryDescription{.index = 0x2030, .type = Unsigned16, .access = Access::WriteOnly, .pdo_mappable = true},
    EntryDescription{.index = 0x2031, .type = Unsigned16, .access = kRo, .pdo_mappable = true, .initial = 0x1234},
    EntryDescription{.index = 0x2032, .type = Unsigned32, .access = kConst, .pdo_mappable = true},
    EntryDescription{.index = 0x2033, .sub_index = 0, .access = kConst, .initial = 5},
    EntryDescription{.index = 0x2033, .sub_index = 2, .type = Unsigned16, .access = kRw, .initial = 2},
    EntryDescription{.index = 0x2033, .sub_index = 5, .type = Unsigned16, .access = kRw, .initial = 5},
    EntryDescription{.index = kJudgedNumber, .type = Unsigned32, .access = kRw},
    EntryDescription{.index = kJudgedText, .type = VisibleString, .access = kRw, .text = "ok", .capacity = 16},
    EntryDescription{.index = 0x2040, .type = VisibleString, .access = kRw, .text = "abc", .capacity = 20},
    EntryDescription{.index = 0x2041, .type = VisibleString, .access = kRw, .capacity = 3},
    EntryDescription{.index = 0x2042, .type = OctetString, .access = kRw, .capacity = 200},
    EntryDescription{.index = 0x2043, .type = UnicodeString, .access = Access::WriteOnly, .capacity = 14},
    EntryDescription{.index = 0x2044, .type = Domain, .access = kRw, .text = "0123456789", .capacity = 64},
    EntryDescription{.index = 0x2045, .type = Domain, .access = kRw},
    EntryDescription{.index = 0x2046, .type = Domain, .access = kRw},
    EntryDescription{.index = 0x2047, .type = Domain, .access = kRo},
    EntryDescription{.index = 0x2048, .type = Domain, .access = Access::WriteOnly},
    EntryDescription{.index = 0x6040, .type = Unsigned16, .access = Access::ReadWriteWrite, .pdo_mappable = true},
    EntryDescription{.index = 0x6041, .type = Unsigned16, .access = kRo, .pdo_mappable = true, .initial = 0x40},
    EntryDescription{.index = 0x6060, .type = Integer8, .access = Access::ReadWriteWrite, .pdo_mappable = true},
    EntryDescription{.index = 0x6063, .type = Integer32, .access = kRo, .pdo_mappable = true},
    EntryDescription{.index = 0x606C, .type = Integer32, .access = Access::ReadWriteRead, .pdo_mappable = true},
    EntryDescription{.index = 0x60FF, .type = Integer32, .access = Access::ReadWriteWrite, .pdo_mappable = true},
};

struct Pdo {
  std::uint16_t communication;
  std::int64_t cob_id;
  bool node_relative;
  std::uint8_t type;
  std::array<std::uint32_t, 3> mapped;
};
constexpr std::array kPdoRows{
    Pdo{0x1400, 0x200, true, 254, {0x60400010}},
    Pdo{0x1401, 0x300, true, 255, {0x60400010, 0x60600008}},
    Pdo{0x1402, 0x400, true, 1, {0x00050008, 0x60FF0020, 0x20500101}},
    Pdo{0x1403, 0x800006DF, false, 254, {}},
    Pdo{0x1800, 0x180, true, 254, {0x60410010}},
    Pdo{0x1801, 0x40000280, true, 1, {0x60410010, 0x606C0020}},
    Pdo{0x1802, 0x380, true, 252, {0x60630020, 0x20500101, 0x10010008}},
    Pdo{0x1803, 0xC00006DF, false, 254, {}},
};
constexpr std::uint8_t kMappable = 9;

void append(Table& table, const Pdo& pdo) {
  const auto at = [&](std::uint8_t sub, DataType type, std::int64_t initial) -> EntryDescription& {
    return table.emplace_back(EntryDescription{
        .index = pdo.communication, .sub_index = sub, .type = type, .access = kRw, .initial = initial});
  };
  at(0, Unsigned8, 6).access = kConst;
  EntryDescription& cob_id = at(1, Unsigned32, pdo.cob_id);
  cob_id.node_relative = pdo.node_relative;
  cob_id.limit_check = LimitCheck::Owner;
  at(2, Unsigned8, pdo.type);
  at(3, Unsigned16, 0);
  at(5, Unsigned16, 0);
  if (pdo.communication >= 0x1800) at(6, Unsigned8, 0);

  const auto mapping = static_cast<std::uint16_t>(pdo.communication + 0x200);
  const auto count = std::ranges::count_if(pdo.mapped, [](std::uint32_t word) { return word != 0; });
  table.push_back({.index = mapping, .access = kRw, .initial = count, .low = 0, .high = kMappable});
  for (std::uint8_t sub = 1; sub <= kMappable; ++sub) {
    const std::uint32_t mapped = sub <= pdo.mapped.size() ? pdo.mapped[sub - 1U] : 0;
    table.push_back({.index = mapping, .sub_index = sub, .type = Unsigned32, .access = kRw, .initial = mapped});
  }
}

Table build() {
  Table table{kOthers.begin(), kOthers.end()};
  for (const Row& row : kProfile) {
    EntryDescription& entry = table.emplace_back(EntryDescription{.index = row.index, .sub_index = row.sub_index});
    entry.type = row.type;
    entry.access = row.access;
    entry.initial = row.initial;
    entry.node_relative = row.node_relative;
    entry.pdo_mappable = row.index == 0x1001;
  }
  for (const Pdo& pdo : kPdoRows) append(table, pdo);
  std::uint16_t index = 0x2000;
  for (const Limited& row : kLimited) {
    EntryDescription entry{.index = index++, .type = row.type, .access = kRw, .initial = row.initial};
    entry.low = row.low;
    entry.high = row.high;
    table.push_back(entry);
  }
  index = 0x2010;
  for (const DataType type : kUnlimited)
    table.push_back({.index = index++, .type = type, .access = kRw, .pdo_mappable = true});
  for (std::uint8_t sub = 1; sub <= 16; ++sub)
    table.push_back({.index = 0x2050, .sub_index = sub, .type = Boolean, .access = kRw, .pdo_mappable = true});
  std::ranges::sort(table, {}, [](const EntryDescription& row) { return row.index << 8 | row.sub_index; });
  return table;
}

}  // namespace

std::span<const EntryDescription> table() {
  static const Table table = build();
  return table;
}

}  // namespace fuzz
