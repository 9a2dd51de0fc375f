#pragma once

#include <cstdint>

namespace canopen {

/// TIME_OF_DAY (CiA 301, 7.1.6.5).
struct TimeOfDay {
  std::uint32_t milliseconds = 0;  ///< after midnight, 28 bits
  std::uint16_t days = 0;          ///< since 1 January 1984

  friend constexpr bool operator==(const TimeOfDay&, const TimeOfDay&) = default;
};

}  // namespace canopen
