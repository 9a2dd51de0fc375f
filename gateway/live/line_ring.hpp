#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace gateway {

/// The time by which is judged what is old, since any zero.
using LiveTime = std::chrono::milliseconds;

/// The last lines of a subscription, as texts with numbers 1, 2, 3... in the order in which they came.
class LineRing {
 public:
  /// A line is kept for so long,
  static constexpr LiveTime kLongest{4000};
  /// and no more than so much of all (bytes): the oldest go first.
  static constexpr std::size_t kMostBytes = 8UL * 1024 * 1024;

  /// Lets @p text follow at time @p now.
  void push(std::string_view text, LiveTime now);
  /// Forgets what is too old at time @p now.
  void forget(LiveTime now);

  /// The number of the newest line; 0: none has come.
  [[nodiscard]] std::uint64_t last() const noexcept { return last_; }
  /// Appends the lines behind number @p after to @p to, in their order, with commas between them. Gives the number
  /// of those behind it that are no longer kept.
  std::uint64_t copy_behind(std::uint64_t after, std::string& to) const;

 private:
  struct Line {
    LiveTime since;
    std::string text;
  };

  void drop();

  std::deque<Line> lines_;
  std::size_t bytes_ = 0;  ///< of `lines_`
  std::uint64_t last_ = 0;
};

}  // namespace gateway
