#pragma once

#include <array>
#include <cstdio>

#include "tests/device/test_unit.hpp"

namespace device {

inline constexpr std::uint32_t kInvalid = 0x80000000;

/// A unit of @p axes axes that may leave Operational without a fault.
inline Configuration unit_of(std::size_t axes, drive::ObjectKind kind = drive::ObjectKind::Servo) {
  Configuration configuration = unit_with({});
  configuration.axes.resize(axes);
  for (AxisSetup& axis : configuration.axes) axis.drive.kind = kind;
  configuration.fault_on_leaving_operational = false;
  return configuration;
}

/// A PDO parameter over SDO: record, sub-index, value and size.
struct Write {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint32_t value;
  unsigned size = 4;
};

/// The request of @p write.
inline std::string request(const Write& write) {
  std::array<char, 32> line{};
  std::snprintf(line.data(), line.size(), "605#%02X%02X%02X%02X%02X%02X%02X%02X", 0x23U | (4 - write.size) << 2,
                write.index & 0xFFU, unsigned{write.index} >> 8, write.sub_index, write.value & 0xFF,
                write.value >> 8 & 0xFF, write.value >> 16 & 0xFF, write.value >> 24);
  return line.data();
}

/// @p write is accepted.
inline void expect_accepted(TestUnit& unit, const Write& write) {
  EXPECT_EQ(unit.download(write.index, write.sub_index, write.value, write.size), 0U) << request(write);
}

/// No alarm is active, and the end of the last one was told.
inline void expect_no_alarm(TestUnit& unit) {
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
}

}  // namespace device
