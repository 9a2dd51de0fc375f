#pragma once

#include <cstdint>
#include <initializer_list>

#include "tests/libcanopen/node_fixture.hpp"

inline constexpr std::uint32_t kUnmappable = 0x06040041;
inline constexpr std::uint32_t kTooLong = 0x06040042;
inline constexpr std::uint32_t kInUse = 0x06040043;
inline constexpr std::uint32_t kInvalidValue = 0x06090030;
inline constexpr std::uint32_t kDeviceState = 0x08000022;

/// A node whose PDO parameters are written.
class PdoParameters : public NodeTest {
 protected:
  using NodeTest::NodeTest;
  void SetUp() override { start(); }

  struct Write {
    std::uint16_t index;
    std::uint8_t sub_index;
    unsigned size;
    std::uint32_t value, abort;
  };
  void expect_writes(std::initializer_list<Write> rows) {
    int number = 0;
    for (const Write& row : rows) {
      EXPECT_EQ(writes(row.index, row.sub_index, row.value, row.size), row.abort)
          << "write " << ++number << ": " << std::hex << row.index << ':' << +row.sub_index << " := " << row.value;
    }
  }
};
