#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace cia402 {

/// A whole number of 320 bits, not negative: products of whole 64-bit numbers, without a thought of overflows.
class LongNumber {
 public:
  /// The product of @p factors.
  LongNumber(std::initializer_list<std::uint64_t> factors) {
    parts_[0] = 1;
    for (const std::uint64_t factor : factors) {
      const LongNumber one = *this;
      *this = one.times(static_cast<std::uint32_t>(factor));
      add(one.times(static_cast<std::uint32_t>(factor >> 32)), 1);
    }
  }

  friend std::strong_ordering operator<=>(const LongNumber& one, const LongNumber& other) {
    for (std::size_t i = kParts; i-- > 0;)
      if (one.parts_[i] != other.parts_[i]) return one.parts_[i] <=> other.parts_[i];
    return std::strong_ordering::equal;
  }

 private:
  static constexpr std::size_t kParts = 10;

  LongNumber times(std::uint32_t factor) const {
    LongNumber product{};
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < kParts; ++i) {
      carry += std::uint64_t{parts_[i]} * factor;
      product.parts_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return product;
  }
  void add(const LongNumber& other, std::size_t shift) {
    std::uint64_t carry = 0;
    for (std::size_t i = shift; i < kParts; ++i) {
      carry += std::uint64_t{parts_[i]} + other.parts_[i - shift];
      parts_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }

  std::array<std::uint32_t, kParts> parts_{};
};

}  // namespace cia402
