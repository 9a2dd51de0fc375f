#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/time.hpp"

namespace canopen {

/// Deadlines of a fixed set of timers in a binary heap: the earliest one costs nothing to read.
/// All memory is taken in the constructor and by add(); timers are named by their number, and of those that are
/// due at the same time the lower number comes first.
class CANOPEN_EXPORT TimerQueue {
 public:
  /// Room for timers 0 .. @p timers - 1, none of them armed.
  explicit TimerQueue(std::size_t timers = 0);
  /// Room for @p timers more, to be taken before any is armed; returns the number of the first of them.
  std::size_t add(std::size_t timers);

  /// Sets or moves the deadline of @p timer.
  void arm(std::size_t timer, TimePoint when) noexcept;
  /// Takes @p timer out; nothing happens if it is not armed.
  void cancel(std::size_t timer) noexcept;
  /// Takes every timer out.
  void clear() noexcept;

  /// The earliest deadline, kNever if no timer is armed. It lies where it lies as long as the queue.
  const TimePoint& earliest() const noexcept { return earliest_; }
  /// Takes out and names the earliest timer if it is due at @p now.
  std::optional<std::size_t> take_due(TimePoint now) noexcept {
    if (earliest_ > now || heap_.empty()) return std::nullopt;
    return take_first();
  }
  /// True while @p timer has a deadline.
  bool is_armed(std::size_t timer) const noexcept { return position_[timer] != kOut; }

 private:
  struct Node {
    TimePoint when;
    std::uint32_t timer = 0;

    friend bool operator<(const Node& a, const Node& b) noexcept {
      return a.when < b.when || (a.when == b.when && a.timer < b.timer);
    }
  };
  static constexpr std::uint32_t kOut = UINT32_MAX;

  std::size_t take_first() noexcept;
  void place(std::size_t at, Node node) noexcept;
  void rise(std::size_t at, Node node) noexcept;
  void sink(std::size_t at, Node node) noexcept;
  void fill(std::size_t at, Node node) noexcept;
  void remove_at(std::size_t at) noexcept;
  void note_earliest() noexcept { earliest_ = heap_.empty() ? kNever : heap_.front().when; }

  TimePoint earliest_ = kNever;
  std::vector<Node> heap_;
  std::vector<std::uint32_t> position_;
};

}  // namespace canopen
