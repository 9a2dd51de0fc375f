#include "tests/libcanopen/sdo_table.hpp"

#include <vector>

namespace {

using canopen::Access;
using canopen::EntryDescription;
using enum canopen::DataType;
using Table = std::vector<EntryDescription>;

constexpr auto kRw = Access::ReadWrite;

struct Server {
  std::uint16_t index;
  std::int64_t request, response;
};

void add(Table& table, const Server& server) {
  EntryDescription cob_id{.index = server.index, .type = Unsigned32, .access = kRw};
  cob_id.limit_check = canopen::LimitCheck::Owner;
  table.push_back({.index = server.index, .access = Access::Constant, .initial = 3});
  cob_id.sub_index = 1;
  cob_id.initial = server.request;
  table.push_back(cob_id);
  cob_id.sub_index = 2;
  cob_id.initial = server.response;
  table.push_back(cob_id);
  table.push_back({.index = server.index, .sub_index = 3, .access = kRw});
}

void add_default_server(Table& table) {
  table.push_back({.index = 0x1200, .access = Access::Constant, .initial = 2});
  for (std::uint8_t sub = 1; sub <= 2; ++sub) {
    table.push_back({.index = 0x1200, .sub_index = sub, .type = Unsigned32, .node_relative = true});
    table.back().initial = sub == 1 ? 0x600 : 0x580;
  }
}

void add_domain(Table& table, std::uint16_t index, Access access, std::uint16_t capacity = 0) {
  table.push_back({.index = index, .type = Domain, .access = access, .capacity = capacity});
}

Table build() {
  Table table{{.index = 0x1000, .type = Unsigned32, .initial = 0x00020192},
              {.index = 0x1017, .type = Unsigned16, .access = kRw}};
  add_default_server(table);
  for (std::uint16_t index = 0x1201; index <= 0x1203; ++index) add(table, {index, 0x80000000, 0x80000000});
  add(table, {0x127F, 0x680, 0x681});
  table.push_back({.index = 0x1400, .access = Access::Constant, .initial = 2});
  table.push_back({.index = 0x1400, .sub_index = 1, .type = Unsigned32, .access = kRw, .initial = 0x205});
  table.back().limit_check = canopen::LimitCheck::Owner;
  table.push_back({.index = 0x1400, .sub_index = 2, .access = kRw, .initial = 255});
  table.push_back({.index = 0x1600, .access = kRw, .initial = 1});
  table.push_back({.index = 0x1600, .sub_index = 1, .type = Unsigned32, .access = kRw, .initial = 0x20000020});
  table.push_back({.index = 0x2000, .type = Unsigned32, .access = kRw, .pdo_mappable = true});
  add_domain(table, 0x2100, kRw);
  add_domain(table, 0x2101, Access::WriteOnly);
  add_domain(table, 0x2102, Access::ReadOnly);
  add_domain(table, 0x2103, kRw, 20);
  return table;
}

Table build_many() {
  Table table{{.index = 0x1000, .type = Unsigned32, .initial = 0x00020192}};
  for (std::uint16_t n = 1; n < 128; ++n) {
    add(table, {static_cast<std::uint16_t>(0x1200 + n), 0x20000000 + n, 0x20001000 + n});
  }
  table.push_back({.index = 0x2000, .type = Unsigned32, .access = kRw});
  add_domain(table, 0x2100, kRw);
  for (std::uint16_t n = 0; n < 128; ++n) {
    table.push_back({.index = static_cast<std::uint16_t>(0x2200 + n), .type = VisibleString, .access = kRw});
    table.back().capacity = 30;
  }
  return table;
}

}  // namespace

std::span<const EntryDescription> sdo_table() {
  static const Table table = build();
  return table;
}

std::span<const EntryDescription> many_servers_table() {
  static const Table table = build_many();
  return table;
}
