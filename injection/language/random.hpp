#pragma once

#include <cstdint>

namespace injection {

/// The generator splitmix64: the same numbers from the same seed, on every machine.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) noexcept : state_{seed} {}

  constexpr std::uint64_t next() noexcept {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// Evenly between 0 (included) and 1 (not).
  constexpr double fraction() noexcept {
    constexpr unsigned kSpare = 11;  // a double holds 53 bits
    return static_cast<double>(next() >> kSpare) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace injection
