#pragma once

#include <cstdint>

namespace device {

/// What is wrong between a master and an axis, for tests of the master.
struct AxisDefect {
  bool ignores_controlword = false;       ///< the one before stays in force
  std::uint16_t controlword_cleared = 0;  ///< bits that never arrive
  std::uint16_t controlword_set = 0;      ///< bits that always seem to
  std::uint16_t statusword_cleared = 0;   ///< bits that are shown as 0
  std::uint16_t statusword_set = 0;       ///< as 1

  friend bool operator==(const AxisDefect&, const AxisDefect&) = default;
};

}  // namespace device
