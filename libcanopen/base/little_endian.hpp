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
