#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "injection/language/random.hpp"

namespace sim {

/// What chance decides in a world, all of it from one seed.
class Draw {
 public:
  explicit constexpr Draw(std::uint64_t seed) noexcept : random_{seed} {}

  /// 0 to @p count - 1; @p count positive.
  constexpr std::uint64_t below(std::uint64_t count) noexcept { return random_.next() % count; }
  /// @p low to @p high, both included.
  constexpr std::int64_t between(std::int64_t low, std::int64_t high) noexcept {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  /// True in @p share (0 to 1) of all cases.
  constexpr bool chance(double share) noexcept { return random_.fraction() < share; }
  /// Evenly between @p low and @p high.
  constexpr double real(double low, double high) noexcept { return low + random_.fraction() * (high - low); }
  /// One of @p items, which are not empty.
  template <class Items>
  constexpr const auto& one_of(const Items& items) noexcept {
    return items[static_cast<std::size_t>(below(std::size(items)))];
  }
  /// Another one that has nothing to do with what is drawn here from now on.
  constexpr Draw fork() noexcept { return Draw{random_.next()}; }

 private:
  injection::Random random_;
};

}  // namespace sim
