#pragma once

#include <cstdint>

namespace cia402 {

/// Whether @p word, a controlword, has any of the bits of @p mask.
constexpr bool has(std::uint16_t word, std::uint16_t mask) noexcept {
  return (word & mask) != 0;
}

}  // namespace cia402
