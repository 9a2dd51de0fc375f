#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace canopen {

static_assert(std::endian::native == std::endian::little, "values lie in memory as they travel on the bus");

/// Reads a value of type T from @p at, which needs no alignment.
template <class T>
T load(const void* at) noexcept {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Writes @p value to @p at, which needs no alignment.
template <class T>
void store(void* at, T value) noexcept {
  std::memcpy(at, &value, sizeof value);
}

/// Writes the lowest @p size bytes of @p value, size 0..8, to @p at; no byte beyond them is touched.
inline void store_bytes(void* at, std::uint64_t value, unsigned size) noexcept {
  switch (size) {
    case 1:
      return store(at, static_cast<std::uint8_t>(value));
    case 2:
      return store(at, static_cast<std::uint16_t>(value));
    case 4:
      return store(at, static_cast<std::uint32_t>(value));
    case 8:
      return store(at, value);
    default:
      std::memcpy(at, &value, size);
  }
}

/// All ones in the lowest @p size bytes, size 0..8.
constexpr std::uint64_t byte_mask(unsigned size) noexcept {
  return size >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * size)) - 1;
}

/// Two's complement of @p size bytes in @p bits, extended to 64 bits.
constexpr std::int64_t sign_extend(std::uint64_t bits, unsigned size) noexcept {
  const unsigned shift = 64 - 8 * size;
  return static_cast<std::int64_t>(bits << shift) >> shift;
}

}  // namespace canopen
