#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "can/hub/medium/medium.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// Frames of this hub that the stream has not brought back yet. Those of a lane come back in their order; without
/// a bit rate all are in one lane, with one each station has its own.
class UnderWay {
 public:
  /// So few that their messages always fit into the buffers of a connection: sending never waits.
  static constexpr std::size_t kMost = 512;

  struct Frame {
    Passage passage;
    canopen::TimePoint taken{};  ///< when it was handed over
  };

  UnderWay() noexcept { clear(); }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] bool full() const noexcept { return count_ == kMost; }
  /// Those of lane @p number.
  [[nodiscard]] std::size_t count(std::uint32_t number) const noexcept {
    const std::size_t place = place_of(number);
    return place == lanes_in_use_ ? 0 : lanes_[place].count;
  }
  /// Only if not full().
  void push(std::uint32_t number, const Frame& frame) noexcept;
  /// The frame of lane @p number that comes back next; nullptr if there is none.
  [[nodiscard]] const Frame* first(std::uint32_t number) const noexcept {
    const std::size_t place = place_of(number);
    return place == lanes_in_use_ ? nullptr : &frames_[lanes_[place].first];
  }
  /// Takes it away; only if there is one.
  void pop(std::uint32_t number) noexcept;
  void clear() noexcept;
  /// @p sender leaves.
  void forget(const Participant& sender) noexcept {
    for (Frame& frame : frames_)
      if (frame.passage.sender == &sender) frame.passage.sender = nullptr;
  }

 private:
  using Place = std::uint16_t;
  struct Lane {
    std::uint32_t number = 0;
    Place count = 0, first = 0, last = 0;
  };

  /// lanes_in_use_ if nothing of lane @p number is under way.
  [[nodiscard]] std::size_t place_of(std::uint32_t number) const noexcept {
    std::size_t place = 0;
    while (place < lanes_in_use_ && lanes_[place].number != number) ++place;
    return place;
  }

  std::array<Frame, kMost> frames_{};
  std::array<Place, kMost> next_{};  ///< by place of a frame: the one behind it in its lane
  std::array<Place, kMost> free_{};  ///< places, the first kMost - count_ of them
  std::array<Lane, kMost> lanes_{};
  std::size_t lanes_in_use_ = 0;
  std::size_t count_ = 0;
};

inline void UnderWay::push(std::uint32_t number, const Frame& frame) noexcept {
  const Place place = free_[kMost - ++count_];
  frames_[place] = frame;
  const std::size_t at = place_of(number);
  Lane& lane = lanes_[at];
  if (at == lanes_in_use_) {
    ++lanes_in_use_;
    lane = {.number = number, .first = place};
  } else {
    next_[lane.last] = place;
  }
  lane.last = place;
  ++lane.count;
}

inline void UnderWay::pop(std::uint32_t number) noexcept {
  Lane& lane = lanes_[place_of(number)];
  free_[kMost - count_--] = lane.first;
  lane.first = next_[lane.first];
  if (--lane.count == 0) lane = lanes_[--lanes_in_use_];
}

inline void UnderWay::clear() noexcept {
  std::iota(free_.begin(), free_.end(), Place{0});
  lanes_in_use_ = 0;
  count_ = 0;
}

}  // namespace hub::trunk
