#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "libcanopen/base/little_endian.hpp"
#include "tests/device/pdo_rules_fixture.hpp"

namespace device {

/// A unit that a master maps and wires over SDO; it may leave Operational without a fault.
struct WiredDevice : TestUnit {
  explicit WiredDevice(const Configuration& configuration = unit_of(1)) : TestUnit{configuration} { start(); }
  /// The unit after a power cut, with what @p former had stored.
  explicit WiredDevice(const TestUnit& former) : TestUnit{unit_of(1)} {
    EXPECT_TRUE(device.load_parameters(former.listener.image));
    start();
  }

  /// The value of parameter @p number of axis @p axis.
  double parameter(std::uint16_t number, std::size_t index = 0, std::size_t axis = 1) const {
    return device.axis(axis).read(number, index).value();
  }
  /// Maps @p entries in PDO @p pdo (1..8) of axis @p axis; its COB-ID stays if it is valid.
  void map(std::uint16_t parameters, unsigned pdo, const std::vector<std::uint32_t>& entries, unsigned axis = 1) {
    const auto record = static_cast<std::uint16_t>(parameters + 0x40 * (axis - 1) + pdo - 1);
    const auto mapping = static_cast<std::uint16_t>(record + 0x200);
    const auto cob_id = static_cast<std::uint32_t>(upload(record, 1).number());
    ASSERT_EQ(download(record, 1, cob_id | kInvalid, 4), 0U);
    ASSERT_EQ(download(mapping, 0, 0, 1), 0U);
    for (std::uint8_t i = 0; i < 4; ++i)
      ASSERT_EQ(download(mapping, static_cast<std::uint8_t>(i + 1), i < entries.size() ? entries[i] : 0, 4), 0U)
          << "entry " << int{i};
    ASSERT_EQ(download(mapping, 0, static_cast<std::uint32_t>(entries.size()), 1), 0U);
    if ((cob_id & kInvalid) == 0) {
      ASSERT_EQ(download(record, 1, cob_id, 4), 0U);
    }
  }
  void map_rpdo(unsigned pdo, const std::vector<std::uint32_t>& entries, unsigned axis = 1) {
    map(0x1400, pdo, entries, axis);
  }
  void map_tpdo(unsigned pdo, const std::vector<std::uint32_t>& entries, unsigned axis = 1) {
    map(0x1800, pdo, entries, axis);
  }
  /// Maps nothing in any PDO of axis @p axis.
  void unmap_all(unsigned axis = 1) {
    for (unsigned pdo = 1; pdo <= 8; ++pdo) {
      map_rpdo(pdo, {}, axis);
      map_tpdo(pdo, {}, axis);
    }
  }
  /// Writes parameter @p number of drive object @p object over SDO; 0 or the abort code.
  std::uint32_t write_parameter(std::uint8_t object, std::uint16_t number, std::uint32_t value, unsigned size,
                                std::uint8_t index = 0) {
    EXPECT_EQ(download(0x41B6, 0, object, 2), 0U);
    return download(static_cast<std::uint16_t>(0x2000 + number), index, value, size);
  }
  std::uint32_t read_parameter(std::uint8_t object, std::uint16_t number, std::uint8_t index = 0) {
    EXPECT_EQ(download(0x41B6, 0, object, 2), 0U);
    return static_cast<std::uint32_t>(upload(static_cast<std::uint16_t>(0x2000 + number), index).number());
  }
  std::uint32_t wire(std::uint8_t object, std::uint16_t number, const drive::BicoSource& source,
                     std::uint8_t index = 0) {
    return write_parameter(object, number, drive::pack(source), 4, index);
  }
  /// Pre-operational: mappings can be changed.
  void leave() { says("000#8005"); }
  /// Operational again, with a cycle over.
  void enter() {
    says("000#0105");
    passes(Device::kCycle);
  }
  void cycle() { passes(2 * Device::kCycle); }
  std::int16_t word(std::uint16_t index) { return static_cast<std::int16_t>(upload(index).number()); }
  std::int32_t double_word(std::uint16_t index) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(upload(index).number()));
  }
  /// Through the states with controlwords over SDO; with @p last in the end.
  void switch_on(std::uint16_t last = 0x000F) {
    for (const std::uint32_t word : {0x0006U, 0x0007U, std::uint32_t{last}}) {
      ASSERT_EQ(download(0x6040, 0, word, 2), 0U);
      cycle();
    }
  }
};

/// @p rpm as 60FFh carries it.
inline std::uint32_t increments(double rpm) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(bus_speed(rpm))));
}

inline double own(std::uint16_t number, std::uint16_t position = 0) {
  return drive::own_source(number, position);
}

}  // namespace device
