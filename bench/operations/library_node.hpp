#pragma once

#include <cstdint>
#include <vector>

#include "bench/operations/frames.hpp"
#include "libcanopen/node/node.hpp"

namespace bench {

/// How the PDOs of a measured node are laid out.
struct Shape {
  std::uint16_t pdos = 4;  ///< as many RPDOs as TPDOs, 1..64
  std::uint8_t transmission_type = 1;
};

/// A table of 1,500 objects: communication objects, eight axes of five profile objects, 2000h UNSIGNED32, 2001h
/// DOMAIN of 1,024 bytes and plain numbers. An RPDO carries controlword, target position and mode of its axis (7
/// bytes), a TPDO statusword and position (6 bytes).
std::vector<canopen::EntryDescription> library_table(const Shape& shape);

/// A node of the library, in Operational, over library_table().
struct LibraryNode {
  explicit LibraryNode(const Shape& shape = {});

  static constexpr std::uint8_t kNodeId = 5;
  static constexpr std::uint16_t kNumber = 0x2000;
  static constexpr std::uint16_t kDomain = 0x2001;
  static constexpr std::size_t kDomainBytes = 1024;
  /// Identifiers of the first PDOs; the others follow.
  static constexpr std::uint32_t kFirstRpdo = 0x201;
  static constexpr std::uint32_t kFirstTpdo = 0x281;

  /// The position actual value that TPDO @p pdo carries.
  canopen::Cell<std::int32_t> position(std::uint16_t pdo) {
    return dictionary.cell<std::int32_t>(axis_object(0x6064, pdo), 0);
  }
  /// Object @p index of the first axis, for the axis of PDO @p pdo.
  static std::uint16_t axis_object(std::uint16_t index, std::uint16_t pdo) noexcept;

  canopen::TimePoint now{std::chrono::hours{1}};
  CountingSink sink;
  canopen::Application application;
  std::vector<canopen::EntryDescription> table;
  canopen::Dictionary dictionary;
  canopen::Node node;
};

}  // namespace bench
