#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace canopen::sdo {

namespace crc_detail {
constexpr std::array<std::uint16_t, 256> make_table() noexcept {
  constexpr unsigned kPolynomial = 0x1021;  // x^16 + x^12 + x^5 + 1
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned remainder = byte << 8;
    for (int bit = 0; bit < 8; ++bit) remainder = remainder << 1 ^ ((remainder & 0x8000) != 0 ? kPolynomial : 0);
    table[byte] = static_cast<std::uint16_t>(remainder);
  }
  return table;
}
inline constexpr auto kTable = make_table();
}  // namespace crc_detail

/// CRC of a block transfer (CiA 301, 7.2.4.3.16): that of @p bytes behind data whose CRC is @p before.
constexpr std::uint16_t crc(std::span<const std::uint8_t> bytes, std::uint16_t before = 0) noexcept {
  for (const std::uint8_t byte : bytes) {
    before = static_cast<std::uint16_t>(before << 8 ^ crc_detail::kTable[(before >> 8 ^ byte) & 0xFF]);
  }
  return before;
}

}  // namespace canopen::sdo
