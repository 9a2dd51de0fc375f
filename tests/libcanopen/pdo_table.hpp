#pragma once

#include <span>

#include "libcanopen/od/entry_description.hpp"
#include "tests/libcanopen/node_fixture.hpp"

/// The test table with all that PDOs and SYNC can have:
///
///     1006h 1007h 1019h, 1800h..1804h:06    cycle period, window, counter; SYNC start values
///     1404h 1604h, 1804h 1A04h              one more PDO each way, invalid, with room for 64 mapped objects
///     2100h:01..40h                         BOOLEAN, mappable both ways
std::span<const canopen::EntryDescription> pdo_table();

/// A node over that table whose application keeps the errors, so that no EMCY is in the way.
class PdoTest : public NodeTest {
 protected:
  explicit PdoTest(const canopen::Policy& policy = {.error_keeping = canopen::ErrorKeeping::Owner})
      : NodeTest{policy, pdo_table()} {}

  void operate() { says("000#0105"); }
  /// Maps @p words into the empty PDO whose communication record is @p communication and makes it valid.
  void map(std::uint16_t communication, std::uint32_t cob_id, std::uint8_t type,
           std::initializer_list<std::uint32_t> words);
  /// The same, with as many entries as @p words has.
  void map(std::uint16_t communication, std::uint32_t cob_id, std::uint8_t type,
           std::span<const std::uint32_t> words);
};
