#include "bench/operations/library_node.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace bench {
namespace {

using canopen::Access;
using canopen::EntryDescription;
using enum canopen::DataType;

constexpr std::size_t kObjects = 1500;
constexpr std::uint16_t kAxes = 8;
constexpr std::uint16_t kFirstPlainNumber = 0x3000;
constexpr auto kRw = Access::ReadWrite;

const std::string& domain() {
  static const std::string bytes(LibraryNode::kDomainBytes, 'd');
  return bytes;
}

void add_communication(std::vector<EntryDescription>& table) {
  table.push_back({.index = 0x1000, .type = Unsigned32, .initial = 0x00020192});
  table.push_back({.index = 0x1001, .type = Unsigned8});
  table.push_back({.index = 0x1005, .type = Unsigned32, .access = kRw, .initial = 0x80});
  table.push_back({.index = 0x1014, .type = Unsigned32, .access = kRw, .node_relative = true, .initial = 0x80});
  table.push_back({.index = 0x1017, .type = Unsigned16, .access = kRw, .initial = 100});
  table.push_back({.index = 0x1018, .type = Unsigned8, .initial = 4});
  for (std::uint8_t sub = 1; sub <= 4; ++sub) {
    table.push_back({.index = 0x1018, .sub_index = sub, .type = Unsigned32, .initial = sub});
  }
}

void add_axes(std::vector<EntryDescription>& table) {
  const std::array objects{
      EntryDescription{
          .index = 0x6040, .type = Unsigned16, .access = Access::ReadWriteWrite, .pdo_mappable = true},
      EntryDescription{.index = 0x6041, .type = Unsigned16, .pdo_mappable = true, .initial = 0x0237},
      EntryDescription{.index = 0x6060, .type = Integer8, .access = Access::ReadWriteWrite, .pdo_mappable = true},
      EntryDescription{.index = 0x6064, .type = Integer32, .pdo_mappable = true},
      EntryDescription{
          .index = 0x607A, .type = Integer32, .access = Access::ReadWriteWrite, .pdo_mappable = true}};
  for (std::uint16_t axis = 0; axis < kAxes; ++axis) {
    for (EntryDescription object : objects) {
      object.index = LibraryNode::axis_object(object.index, axis);
      table.push_back(object);
    }
  }
}

struct Pdo {
  std::uint16_t communication;
  std::uint32_t cob_id;
  std::uint8_t type;
  std::vector<std::uint32_t> mapped;
};

void add(std::vector<EntryDescription>& table, const Pdo& pdo) {
  const std::uint16_t index = pdo.communication;
  table.push_back({.index = index, .initial = 5});
  table.push_back({.index = index, .sub_index = 1, .type = Unsigned32, .access = kRw, .initial = pdo.cob_id});
  table.push_back({.index = index, .sub_index = 2, .access = kRw, .initial = pdo.type});
  table.push_back({.index = index, .sub_index = 3, .type = Unsigned16, .access = kRw});
  table.push_back({.index = index, .sub_index = 5, .type = Unsigned16, .access = kRw});
  const auto mapping = static_cast<std::uint16_t>(index + 0x200);
  table.push_back({.index = mapping, .access = kRw, .initial = static_cast<std::int64_t>(pdo.mapped.size())});
  std::uint8_t sub = 0;
  for (const std::uint32_t word : pdo.mapped) {
    table.push_back({.index = mapping, .sub_index = ++sub, .type = Unsigned32, .access = kRw, .initial = word});
  }
}

/// The mapping word of @p object of the axis that PDO @p pdo belongs to.
std::uint32_t mapped(std::uint16_t object, std::uint16_t pdo, std::uint32_t bits) {
  return static_cast<std::uint32_t>(LibraryNode::axis_object(object, pdo)) << 16 | bits;
}

void add_pdos(std::vector<EntryDescription>& table, const Shape& shape) {
  for (std::uint16_t n = 0; n < shape.pdos; ++n) {
    add(table, {.communication = static_cast<std::uint16_t>(0x1400 + n),
                .cob_id = LibraryNode::kFirstRpdo + n,
                .type = 255,
                .mapped = {mapped(0x6040, n, 16), mapped(0x607A, n, 32), mapped(0x6060, n, 8)}});
    add(table, {.communication = static_cast<std::uint16_t>(0x1800 + n),
                .cob_id = canopen::cob_id::kNoRemote | (LibraryNode::kFirstTpdo + n),
                .type = shape.transmission_type,
                .mapped = {mapped(0x6041, n, 16), mapped(0x6064, n, 32)}});
  }
}

constexpr canopen::Policy kPolicy{};

}  // namespace

std::vector<EntryDescription> library_table(const Shape& shape) {
  std::vector<EntryDescription> table;
  add_communication(table);
  add_pdos(table, shape);
  add_axes(table);
  table.push_back({.index = LibraryNode::kNumber, .type = Unsigned32, .access = kRw, .initial = 0x12345678});
  table.push_back({.index = LibraryNode::kDomain,
                   .type = Domain,
                   .access = kRw,
                   .text = domain(),
                   .capacity = LibraryNode::kDomainBytes});
  std::size_t objects = 6 + std::size_t{4} * shape.pdos + std::size_t{5} * kAxes + 2;
  for (std::uint16_t index = kFirstPlainNumber; objects < kObjects; ++index, ++objects) {
    table.push_back({.index = index, .type = Unsigned32, .access = kRw, .initial = index});
  }
  std::ranges::sort(table, {}, [](const EntryDescription& row) { return row.index << 8 | row.sub_index; });
  return table;
}

LibraryNode::LibraryNode(const Shape& shape)
    : table{library_table(shape)}, dictionary{table, kNodeId}, node{dictionary, kPolicy, sink, application} {
  node.start(now);
  canopen::Frame start{.id = 0, .length = 2};
  start.data[0] = static_cast<std::uint8_t>(canopen::NmtCommand::Start);
  node.on_frame(start, now);
}

std::uint16_t LibraryNode::axis_object(std::uint16_t index, std::uint16_t pdo) noexcept {
  return static_cast<std::uint16_t>(index + 0x800 * (pdo % kAxes));
}

}  // namespace bench
