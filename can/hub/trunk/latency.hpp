#pragma once

#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace hub::trunk {

/// How long something took, many times: quantiles within 6 %, from 1 ns on.
class Latency {
 public:
  void add(std::chrono::nanoseconds time) noexcept {
    ++counts_[place_of(static_cast<std::uint64_t>(time.count() > 0 ? time.count() : 0))];
    ++count_;
  }
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  /// What @p share (0..1) of all times do not exceed; 0 if there is none.
  [[nodiscard]] std::chrono::nanoseconds quantile(double share) const noexcept {
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(count_));
    std::uint64_t passed = 0;
    for (std::size_t place = 0; place < counts_.size(); ++place)
      if ((passed += counts_[place]) > wanted || (passed == count_ && count_ > 0))
        return std::chrono::nanoseconds{upper_end(place)};
    return std::chrono::nanoseconds{0};
  }

 private:
  // A place stands for the highest bit of a time and the four bits behind it.
  static constexpr unsigned kFineBits = 4;
  static constexpr std::size_t kFine = 1U << kFineBits;

  static std::size_t place_of(std::uint64_t time) noexcept {
    if (time < kFine) return time;
    const auto highest = static_cast<unsigned>(std::bit_width(time)) - 1;
    return (highest - kFineBits + 1) * kFine + ((time >> (highest - kFineBits)) & (kFine - 1));
  }
  static std::int64_t upper_end(std::size_t place) noexcept {
    if (place < kFine) return static_cast<std::int64_t>(place);
    const std::size_t shift = place / kFine - 1;
    return static_cast<std::int64_t>(((kFine | place % kFine) + 1) << shift) - 1;
  }

  static constexpr std::size_t kHighestBit = 48;  // three days
  std::array<std::uint64_t, (kHighestBit - kFineBits + 2) * kFine> counts_{};
  std::uint64_t count_ = 0;
};

}  // namespace hub::trunk
