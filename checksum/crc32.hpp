#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace checksum {

/// CRC-32 of ISO-HDLC (polynomial 04C11DB7h reflected), as zlib's crc32() has it: of @p bytes behind those whose
/// result is @p before.
[[nodiscard]] constexpr std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0) noexcept {
  constexpr std::uint32_t kPolynomial = 0xEDB88320;
  constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
      std::uint32_t rest = i;
      for (int bit = 0; bit < 8; ++bit) rest = (rest & 1U) != 0 ? rest >> 1 ^ kPolynomial : rest >> 1;
      table[i] = rest;
    }
    return table;
  }();
  std::uint32_t crc = ~before;
  for (const std::byte byte : bytes) crc = kTable[(crc ^ static_cast<std::uint32_t>(byte)) & 0xFFU] ^ crc >> 8;
  return ~crc;
}

namespace crc_check {
inline constexpr std::array kDigits{std::byte{'1'}, std::byte{'2'}, std::byte{'3'}, std::byte{'4'}, std::byte{'5'},
                                    std::byte{'6'}, std::byte{'7'}, std::byte{'8'}, std::byte{'9'}};
static_assert(crc32(kDigits) == 0xCBF43926, "the check value of this CRC");
}  // namespace crc_check

}  // namespace checksum
