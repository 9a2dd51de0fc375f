#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "libcanopen/base/time.hpp"

namespace hub {

/// Frames of one station that may wait for the bus.
inline constexpr std::size_t kMostWaiting = 16;

/// Frames of one station that wait for the bus, in their order; @p Content is what is kept of one.
template <class Content>
class WaitingFrames {
 public:
  struct Waiting {
    Content content;
    canopen::TimePoint arrival;  ///< when it was handed over
    std::uint64_t number = 0;    ///< of all frames of the bus: the order in which they were handed over
    std::uint32_t priority = 0;  ///< arbitration_field()
  };

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] bool full() const noexcept { return count_ == ring_.size(); }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// The frame that is next; only if not empty().
  [[nodiscard]] const Waiting& first() const noexcept { return ring_[head_]; }
  /// The frame that was kept last; only if not empty().
  [[nodiscard]] Waiting& last() noexcept { return ring_[(head_ + count_ - 1) % ring_.size()]; }
  /// Keeps @p waiting behind the others; only if not full().
  void push(const Waiting& waiting) noexcept {
    ring_[(head_ + count_) % ring_.size()] = waiting;
    ++count_;
  }
  /// Takes the first frame away; only if not empty().
  void pop() noexcept {
    head_ = (head_ + 1) % ring_.size();
    --count_;
  }
  void clear() noexcept { count_ = 0; }

 private:
  std::array<Waiting, kMostWaiting> ring_;
  std::size_t head_ = 0;
  std::size_t count_ = 0;
};

/// Of @p stations, pointers to what has WaitingFrames as `frames`: whose first frame @p may_win and comes before
/// the first frames of the others by @p rank; nullptr if none does.
template <class Stations, class MayWin, class Rank>
[[nodiscard]] auto* first_of(const Stations& stations, MayWin may_win, Rank rank) noexcept {
  using Station = std::remove_reference_t<decltype(**stations.begin())>;
  Station* best = nullptr;
  for (const auto& station : stations) {
    if (station->frames.empty() || !may_win(*station)) continue;
    if (best == nullptr || rank(station->frames.first()) < rank(best->frames.first())) best = &*station;
  }
  return best;
}

/// Who has the lowest arbitration field of those of @p stations whose first frame was there at @p start; of equal
/// ones that which was handed over first. nullptr if there is none.
template <class Stations>
[[nodiscard]] auto* winner_of(const Stations& stations, canopen::TimePoint start) noexcept {
  const auto was_there = [start](const auto& station) { return station.frames.first().arrival <= start; };
  return first_of(stations, was_there, [](const auto& frame) { return std::pair{frame.priority, frame.number}; });
}

/// Whose first frame was handed over before those of the others, of those of @p stations that @p may_send; nullptr
/// if none waits.
template <class Stations, class MaySend>
[[nodiscard]] auto* earliest_of(const Stations& stations, MaySend may_send) noexcept {
  return first_of(stations, may_send, [](const auto& frame) { return frame.number; });
}
template <class Stations>
[[nodiscard]] auto* earliest_of(const Stations& stations) noexcept {
  return earliest_of(stations, [](const auto&) { return true; });
}

}  // namespace hub
