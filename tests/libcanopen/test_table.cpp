#include "tests/libcanopen/test_table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace {

using canopen::Access;
using canopen::DataType;
using canopen::EntryDescription;
using canopen::LimitCheck;
using enum canopen::DataType;

constexpr auto kRw = Access::ReadWrite;
constexpr auto kRo = Access::ReadOnly;

constexpr std::int64_t real(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

constexpr std::array kPlain{
    EntryDescription{.index = 0x1000, .type = Unsigned32, .initial = 0x00020192},
    EntryDescription{.index = 0x1005,
                     .type = Unsigned32,
                     .access = kRw,
                     .limit_check = LimitCheck::Owner,
                     .initial = 0x80,
                     .low = 1,
                     .high = 0x800000FF},
    EntryDescription{
        .index = 0x1008, .type = VisibleString, .access = Access::Constant, .text = "Slave of the tests"},
    EntryDescription{.index = 0x100A, .type = VisibleString, .access = Access::Constant, .text = "1.0"},
    EntryDescription{.index = 0x1014,
                     .type = Unsigned32,
                     .access = kRw,
                     .node_relative = true,
                     .limit_check = LimitCheck::Owner,
                     .initial = 0x80},
    EntryDescription{.index = 0x1017, .type = Unsigned16, .access = kRw},
    EntryDescription{.index = 0x1018, .sub_index = 0, .access = Access::Constant, .initial = 4},
    EntryDescription{.index = 0x1018, .sub_index = 1, .type = Unsigned32, .initial = 0x2A},
    EntryDescription{.index = 0x1018, .sub_index = 2, .type = Unsigned32, .initial = 0x00010002},
    EntryDescription{.index = 0x1018, .sub_index = 3, .type = Unsigned32, .initial = 0x00030004},
    EntryDescription{.index = 0x1018, .sub_index = 4, .type = Unsigned32, .initial = 0x12345678},
    EntryDescription{.index = 0x1200, .sub_index = 0, .access = Access::Constant, .initial = 2},
    EntryDescription{.index = 0x1200, .sub_index = 1, .type = Unsigned32, .node_relative = true, .initial = 0x600},
    EntryDescription{.index = 0x1200, .sub_index = 2, .type = Unsigned32, .node_relative = true, .initial = 0x580},
    EntryDescription{.index = 0x2020, .type = Unsigned16, .access = Access::WriteOnly, .pdo_mappable = true},
    EntryDescription{.index = 0x2021, .type = Unsigned16, .access = kRo, .pdo_mappable = true, .initial = 0x1234},
    EntryDescription{.index = 0x2022, .type = Unsigned32, .access = Access::Constant, .pdo_mappable = true},
    EntryDescription{.index = 0x2023, .type = VisibleString, .access = kRw, .text = "abc", .capacity = 20},
    EntryDescription{.index = 0x2024, .type = VisibleString, .access = kRw, .capacity = 3},
    EntryDescription{.index = 0x2025, .sub_index = 0, .access = Access::Constant, .initial = 5},
    EntryDescription{.index = 0x2025, .sub_index = 2, .type = Unsigned16, .access = kRw, .initial = 2},
    EntryDescription{.index = 0x2025, .sub_index = 5, .type = Unsigned16, .access = kRw, .initial = 5},
    EntryDescription{
        .index = 0x6040, .type = Unsigned16, .access = Access::ReadWriteWrite, .pdo_mappable = true, .initial = 1},
    EntryDescription{.index = 0x6041, .type = Unsigned16, .access = kRo, .pdo_mappable = true, .initial = 0x0040},
    EntryDescription{.index = 0x6060, .type = Integer8, .access = Access::ReadWriteWrite, .pdo_mappable = true},
    EntryDescription{.index = 0x6061, .type = Integer8, .access = kRo, .pdo_mappable = true},
    EntryDescription{.index = 0x6063, .type = Integer32, .access = kRo, .pdo_mappable = true},
    EntryDescription{.index = 0x606C, .type = Integer32, .access = Access::ReadWriteRead, .pdo_mappable = true},
    EntryDescription{.index = 0x60FF, .type = Integer32, .access = Access::ReadWriteWrite, .pdo_mappable = true},
    EntryDescription{.index = 0xA000, .type = Unsigned16, .access = kRw},
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
constexpr std::array kUnlimited{Boolean,    Integer8,  Unsigned8,  Integer16, Unsigned16, Integer24,
                                Unsigned24, Integer32, Unsigned32, Real32,    Integer40,  Unsigned48,
                                Unsigned56, Integer64, Unsigned64, Real64};

struct Pdo {
  std::uint16_t communication;
  std::uint32_t cob_id;
  bool node_relative;
  std::uint8_t type;
  std::array<std::uint32_t, 4> mapped;
};
constexpr std::array kPdos{
    Pdo{0x1400, 0x200, true, 254, {0x60400010}},
    Pdo{0x1401, 0x300, true, 255, {0x60400010, 0x60600008}},
    Pdo{0x1402, 0x400, true, 1, {0x60400010, 0x60FF0020}},
    Pdo{0x1403, 0x800006DF, false, 254, {}},
    Pdo{0x1800, 0x40000180, true, 254, {0x60410010}},
    Pdo{0x1801, 0x40000280, true, 1, {0x60410010, 0x606C0020}},
    Pdo{0x1802, 0x40000380, true, 0, {0x60630020}},
    Pdo{0x1803, 0xC00006DF, false, 254, {}},
};

void append(std::vector<EntryDescription>& table, const Pdo& pdo) {
  EntryDescription row{.index = pdo.communication, .access = Access::Constant, .initial = 5};
  table.push_back(row);
  row = {.index = pdo.communication, .sub_index = 1, .type = Unsigned32, .access = kRw};
  row.node_relative = pdo.node_relative;
  row.limit_check = LimitCheck::Owner;
  row.initial = pdo.cob_id;
  table.push_back(row);
  table.push_back({.index = pdo.communication, .sub_index = 2, .access = kRw, .initial = pdo.type});
  table.push_back({.index = pdo.communication, .sub_index = 3, .type = Unsigned16, .access = kRw});
  table.push_back({.index = pdo.communication, .sub_index = 5, .type = Unsigned16, .access = kRw});

  const auto mapping = static_cast<std::uint16_t>(pdo.communication + 0x200);
  const auto count = std::ranges::count_if(pdo.mapped, [](std::uint32_t word) { return word != 0; });
  table.push_back({.index = mapping, .access = kRw, .initial = count, .low = 0, .high = 4});
  for (std::uint8_t sub = 1; sub <= pdo.mapped.size(); ++sub) {
    table.push_back(
        {.index = mapping, .sub_index = sub, .type = Unsigned32, .access = kRw, .initial = pdo.mapped[sub - 1U]});
  }
}

std::vector<EntryDescription> build() {
  std::vector<EntryDescription> table{kPlain.begin(), kPlain.end()};
  for (const Pdo& pdo : kPdos) append(table, pdo);
  std::uint16_t index = 0x2000;
  for (const Limited& row : kLimited) {
    EntryDescription entry{.index = index++, .type = row.type, .access = kRw, .initial = row.initial};
    entry.low = row.low;
    entry.high = row.high;
    table.push_back(entry);
  }
  index = 0x2010;
  for (const DataType type : kUnlimited) {
    table.push_back({.index = index++, .type = type, .access = kRw, .pdo_mappable = true});
  }
  std::ranges::sort(table, {}, [](const EntryDescription& row) { return row.index << 8 | row.sub_index; });
  return table;
}

}  // namespace

std::span<const EntryDescription> test_table() {
  static const std::vector<EntryDescription> table = build();
  return table;
}
