#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "can/hub/medium/medium.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// Frames of this hub that the stream has not brought back yet, in their order.
class UnderWay {
 public:
  /// So few that their messages always fit into the buffers of a connection: sending never waits.
  static constexpr std::size_t kMost = 512;

  struct Frame {
    Passage passage;
    std::uint64_t counter = 0;   ///< number of the frame
    canopen::TimePoint taken{};  ///< when it was handed over
  };

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] bool full() const noexcept { return count_ == kMost; }
  /// Only if not full().
  void push(const Frame& frame) noexcept { ring_[(head_ + count_++) % kMost] = frame; }
  /// The frame that comes back next; only if not empty().
  [[nodiscard]] const Frame& first() const noexcept { return ring_[head_]; }
  void pop() noexcept {
    head_ = (head_ + 1) % kMost;
    --count_;
  }
  void clear() noexcept { count_ = 0; }
  /// @p sender leaves.
  void forget(const Participant& sender) noexcept {
    for (std::size_t i = 0; i < count_; ++i)
      if (Passage& passage = ring_[(head_ + i) % kMost].passage; passage.sender == &sender)
        passage.sender = nullptr;
  }

 private:
  std::array<Frame, kMost> ring_{};
  std::size_t head_ = 0;
  std::size_t count_ = 0;
};

}  // namespace hub::trunk
