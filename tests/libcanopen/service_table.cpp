#include "tests/libcanopen/service_table.hpp"

#include <vector>

namespace {

using canopen::Access;
using canopen::EntryDescription;
using canopen::LimitCheck;
using enum canopen::DataType;
using Table = std::vector<EntryDescription>;

constexpr auto kRw = Access::ReadWrite;
constexpr auto kConst = Access::Constant;

void add_cob_id(Table& table, std::uint16_t index, std::uint8_t sub_index, std::int64_t initial) {
  table.push_back({.index = index, .sub_index = sub_index, .type = Unsigned32, .access = kRw});
  table.back().limit_check = LimitCheck::Owner;
  table.back().initial = initial;
}

/// An object of sub-index 0 and @p count entries.
void add_array(Table& table, EntryDescription entry, std::uint8_t count) {
  table.push_back({.index = entry.index, .access = kConst, .initial = count});
  for (entry.sub_index = 1; entry.sub_index <= count; ++entry.sub_index) table.push_back(entry);
}

void add_tpdo(Table& table) {
  table.push_back({.index = 0x1800, .access = kConst, .initial = 2});
  add_cob_id(table, 0x1800, 1, 0xC0000185);
  table.push_back({.index = 0x1800, .sub_index = 2, .access = kRw, .initial = 254});
  table.push_back({.index = 0x1A00, .access = kRw, .initial = 1});
  table.push_back({.index = 0x1A00, .sub_index = 1, .type = Unsigned32, .access = kRw, .initial = 0x10010008});
}

Table build() {
  Table table{{.index = 0x1000, .type = Unsigned32}, {.index = 0x1001, .pdo_mappable = true}};
  table.push_back({.index = 0x1003, .access = kRw});
  for (std::uint8_t sub = 1; sub <= 4; ++sub) {
    table.push_back({.index = 0x1003, .sub_index = sub, .type = Unsigned32});
  }
  table.push_back({.index = 0x100C, .type = Unsigned16, .access = kRw});
  table.push_back({.index = 0x100D, .type = Unsigned8, .access = kRw});
  add_array(table, {.index = 0x1010, .type = Unsigned32, .access = kRw, .initial = 3}, 2);
  add_array(table, {.index = 0x1011, .type = Unsigned32, .access = kRw, .initial = 1}, 2);
  add_cob_id(table, 0x1012, 0, 0x100);
  add_cob_id(table, 0x1014, 0, 0x85);
  table.push_back({.index = 0x1015, .type = Unsigned16, .access = kRw});
  add_array(table, {.index = 0x1016, .type = Unsigned32, .access = kRw}, 3);
  table.push_back({.index = 0x1017, .type = Unsigned16, .access = kRw});
  add_array(table, {.index = 0x1029, .type = Unsigned8, .access = kRw}, 2);
  add_tpdo(table);
  return table;
}

}  // namespace

std::span<const EntryDescription> service_table() {
  static const Table table = build();
  return table;
}
