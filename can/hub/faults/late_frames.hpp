#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "can/hub/medium/medium.hpp"

namespace hub::faults {

/// Frames that are heard later, in the order of their times; of equal ones in that in which they came.
class LateFrames {
 public:
  static constexpr std::size_t kMost = 1024;

  struct Late {
    canopen::TimePoint due;
    Passage passage;
    Identity sender;
  };

  /// Makes room for all; std::bad_alloc.
  void reserve() { frames_.reserve(kMost); }
  /// Keeps @p late; false if there is no room.
  [[nodiscard]] bool keep(const Late& late) noexcept {
    if (frames_.size() >= std::min(kMost, frames_.capacity())) return false;
    const auto earlier = [](canopen::TimePoint due, const Late& other) { return due < other.due; };
    frames_.insert(std::upper_bound(frames_.begin(), frames_.end(), late.due, earlier), late);
    return true;
  }
  [[nodiscard]] bool empty() const noexcept { return frames_.empty(); }
  [[nodiscard]] canopen::TimePoint next() const noexcept {
    return frames_.empty() ? canopen::kNever : frames_.front().due;
  }
  /// The first one; only if not empty().
  Late take() noexcept {
    const Late first = frames_.front();
    frames_.erase(frames_.begin());
    return first;
  }
  /// @p participant is named as a sender no more.
  void forget(const Participant& participant) noexcept {
    for (Late& late : frames_)
      if (late.passage.sender == &participant) late.passage.sender = nullptr;
  }

 private:
  std::vector<Late> frames_;
};

}  // namespace hub::faults
