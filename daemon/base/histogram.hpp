#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace axisd {

/// How long something took, how often: counted in classes, as monitoring systems want it. Nothing resets it.
class Histogram {
 public:
  /// Upper ends of the classes but the last one, which has none.
  static constexpr std::array kBounds = std::to_array<std::chrono::nanoseconds>(
      {std::chrono::microseconds{10}, std::chrono::microseconds{25}, std::chrono::microseconds{50},
       std::chrono::microseconds{100}, std::chrono::microseconds{250}, std::chrono::microseconds{500},
       std::chrono::milliseconds{1}, std::chrono::microseconds{2500}, std::chrono::milliseconds{5},
       std::chrono::milliseconds{10}, std::chrono::milliseconds{25}, std::chrono::milliseconds{100}});

  void note(std::chrono::nanoseconds time) noexcept {
    const auto above = std::ranges::lower_bound(kBounds, time);
    ++counts_[static_cast<std::size_t>(above - kBounds.begin())];
    sum_ += time;
  }

  /// Of each class, those below it not included; the last one is above all bounds.
  const std::array<std::uint64_t, kBounds.size() + 1>& counts() const noexcept { return counts_; }
  std::chrono::nanoseconds sum() const noexcept { return sum_; }

 private:
  std::array<std::uint64_t, kBounds.size() + 1> counts_{};
  std::chrono::nanoseconds sum_{};
};

}  // namespace axisd
