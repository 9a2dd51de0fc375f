#include "tests/libcanopen/pdo_table.hpp"

namespace {

using canopen::Access;
using canopen::EntryDescription;
using canopen::LimitCheck;
using enum canopen::DataType;

constexpr std::uint8_t kBits = 64;

void append_pdo(std::vector<EntryDescription>& table, std::uint16_t communication) {
  table.push_back({.index = communication, .access = Access::Constant, .initial = 6});
  table.push_back({.index = communication,
                   .sub_index = 1,
                   .type = Unsigned32,
                   .access = Access::ReadWrite,
                   .limit_check = LimitCheck::Owner,
                   .initial = 0x80000000});
  table.push_back({.index = communication, .sub_index = 2, .access = Access::ReadWrite, .initial = 255});
  table.push_back({.index = communication, .sub_index = 3, .type = Unsigned16, .access = Access::ReadWrite});
  table.push_back({.index = communication, .sub_index = 5, .type = Unsigned16, .access = Access::ReadWrite});
  const auto mapping = static_cast<std::uint16_t>(communication + 0x200);
  table.push_back({.index = mapping, .access = Access::ReadWrite});
  for (std::uint8_t sub = 1; sub <= kBits; ++sub)
    table.push_back({.index = mapping, .sub_index = sub, .type = Unsigned32, .access = Access::ReadWrite});
}

std::vector<EntryDescription> build() {
  const auto plain = test_table();
  std::vector<EntryDescription> table{plain.begin(), plain.end()};
  table.push_back({.index = 0x1006, .type = Unsigned32, .access = Access::ReadWrite});
  table.push_back({.index = 0x1007, .type = Unsigned32, .access = Access::ReadWrite});
  table.push_back({.index = 0x1019, .type = Unsigned8, .access = Access::ReadWrite});
  append_pdo(table, 0x1404);
  append_pdo(table, 0x1804);
  for (std::uint16_t index = 0x1800; index <= 0x1804; ++index)
    table.push_back({.index = index, .sub_index = 6, .access = Access::ReadWrite});
  table.push_back({.index = 0x2100, .access = Access::Constant, .initial = kBits});
  for (std::uint8_t sub = 1; sub <= kBits; ++sub)
    table.push_back(
        {.index = 0x2100, .sub_index = sub, .type = Boolean, .access = Access::ReadWrite, .pdo_mappable = true});
  std::ranges::sort(table, {}, [](const EntryDescription& row) { return row.index << 8 | row.sub_index; });
  return table;
}

}  // namespace

std::span<const EntryDescription> pdo_table() {
  static const std::vector<EntryDescription> table = build();
  return table;
}

void PdoTest::map(std::uint16_t communication, std::uint32_t cob_id, std::uint8_t type,
                  std::initializer_list<std::uint32_t> words) {
  map(communication, cob_id, type, std::span{words.begin(), words.size()});
}

void PdoTest::map(std::uint16_t communication, std::uint32_t cob_id, std::uint8_t type,
                  std::span<const std::uint32_t> words) {
  const auto mapping = static_cast<std::uint16_t>(communication + 0x200);
  ASSERT_EQ(writes_u32(communication, 1, 0x80000000), 0U);
  ASSERT_EQ(writes_u8(mapping, 0, 0), 0U);
  std::uint8_t sub = 0;
  for (const std::uint32_t word : words) ASSERT_EQ(writes_u32(mapping, ++sub, word), 0U) << std::hex << word;
  ASSERT_EQ(writes_u8(mapping, 0, sub), 0U);
  ASSERT_EQ(writes_u8(communication, 2, type), 0U);
  ASSERT_EQ(writes_u32(communication, 1, cob_id), 0U);
}
