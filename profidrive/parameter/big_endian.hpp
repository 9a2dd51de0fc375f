#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace profidrive {

/// The number in @p bytes, of which there are 4 at most, the most significant first.
constexpr std::uint32_t number_in(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t number = 0;
  for (const std::uint8_t byte : bytes) number = number << 8 | byte;
  return number;
}

/// Puts the lowest bytes of @p number into @p bytes, of which there are 4 at most, the most significant first.
constexpr void put_number(std::span<std::uint8_t> bytes, std::uint32_t number) noexcept {
  for (std::size_t i = bytes.size(); i > 0; --i, number >>= 8) bytes[i - 1] = static_cast<std::uint8_t>(number);
}

}  // namespace profidrive
