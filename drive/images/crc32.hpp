#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drive {

/// CRC-32 of @p bytes with the reflected polynomial EDB88320h, as Ethernet and zip have it.
constexpr std::uint32_t crc32(std::span<const std::byte> bytes) noexcept {
  constexpr std::uint32_t kPolynomial = 0xEDB88320;
  constexpr int kBitsAByte = 8;
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::byte byte : bytes) {
    crc ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < kBitsAByte; ++bit) crc = crc >> 1 ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
  }
  return ~crc;
}

namespace crc_check {
inline constexpr std::array kDigits{std::byte{'1'}, std::byte{'2'}, std::byte{'3'}, std::byte{'4'}, std::byte{'5'},
                                    std::byte{'6'}, std::byte{'7'}, std::byte{'8'}, std::byte{'9'}};
static_assert(crc32(kDigits) == 0xCBF43926, "the check value of this CRC");
}  // namespace crc_check

}  // namespace drive
