#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace cia402 {

/// Numbers by chance; prints its seed, AXISD_TEST_SEED repeats one.
class RandomNumbers {
 public:
  RandomNumbers() { std::cout << "AXISD_TEST_SEED=" << seed_ << '\n'; }

  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>{low, high}(random_);
  }
  double between(double low, double high) { return std::uniform_real_distribution<double>{low, high}(random_); }
  bool by_chance(double share) { return between(0.0, 1.0) < share; }
  /// From 1 to 2^@p most_bits - 1, of every length alike.
  std::uint64_t of_any_length(int most_bits) {
    const int bits = static_cast<int>(whole(1, most_bits));
    return (random_() >> (64 - bits)) | std::uint64_t{1} << (bits - 1);
  }

 private:
  static unsigned chosen() {
    const char* const wanted = std::getenv("AXISD_TEST_SEED");
    return wanted != nullptr ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : std::random_device{}();
  }

  unsigned seed_ = chosen();
  std::mt19937_64 random_{seed_};
  testing::ScopedTrace trace_{__FILE__, __LINE__, "AXISD_TEST_SEED=" + std::to_string(seed_)};
};

}  // namespace cia402
