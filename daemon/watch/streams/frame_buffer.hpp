#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "daemon/watch/frame_tap.hpp"
#include "daemon/watch/streams/ring_places.hpp"

namespace axisd {

/// Frames of a unit on their way from its thread to that of the control socket. What does not fit is counted and
/// lost.
class FrameBuffer {
 public:
  /// A frame, and when it passed.
  struct Passed {
    canopen::Duration time{};  ///< since the start of the unit
    Direction direction = Direction::Received;
    canopen::Frame frame{};
  };
  static constexpr std::size_t kRoom = 8192;

  /// Allocates.
  FrameBuffer() : items_(kRoom) {}

  /// The unit's thread.
  void add(const Passed& passed) noexcept {
    if (places_.is_full()) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    items_[places_.next()] = passed;
    places_.publish();
  }
  // The thread of the control socket.
  [[nodiscard]] std::size_t waiting() const noexcept { return places_.waiting(); }
  /// The @p number-th of those that wait, from 0 on.
  [[nodiscard]] const Passed& operator[](std::size_t number) const noexcept { return items_[places_.at(number)]; }
  void release(std::size_t count) noexcept { places_.release(count); }
  /// How many were lost since the last call.
  [[nodiscard]] std::uint64_t take_lost() noexcept { return lost_.exchange(0, std::memory_order_relaxed); }

 private:
  std::vector<Passed> items_;
  RingPlaces places_{kRoom};
  std::atomic<std::uint64_t> lost_ = 0;
};

}  // namespace axisd
