#pragma once

#include <cstddef>
#include <cstdint>

namespace userbus {

/// Bit rates that a bus can have (bit/s), beside 0, with which frames take no time. ISO 11898-2 ends at the
/// highest for classical frames.
inline constexpr uint32_t kLowestBitRate = 1000;
inline constexpr uint32_t kHighestBitRate = 1'000'000;

/// What a message says is expected where read_bit_rate() is false.
inline constexpr char kBitRateRule[] = "0 or an integer 1000 to 1000000 (bit/s)";

/// Reads the @p size decimal digits at @p text; false if they are no bit rate of a bus.
constexpr bool read_bit_rate(const char* text, size_t size, uint32_t& rate) noexcept {
  constexpr uint32_t kTen = 10;
  rate = 0;
  if (size == 0) return false;
  for (size_t i = 0; i < size; ++i) {
    if (text[i] < '0' || text[i] > '9' || rate > kHighestBitRate) return false;
    rate = rate * kTen + static_cast<uint32_t>(text[i] - '0');
  }
  return rate == 0 || (rate >= kLowestBitRate && rate <= kHighestBitRate);
}

}  // namespace userbus
