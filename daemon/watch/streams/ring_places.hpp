#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace axisd {

/// The places of a bounded queue from one thread to another, of which neither waits for the other; what lies in
/// them is whose queue it is. The one thread writes to next() and publishes, the other one reads at() and
/// releases.
class RingPlaces {
 public:
  explicit RingPlaces(std::size_t room) noexcept : room_{room} {}

  // The thread that writes.
  [[nodiscard]] bool is_full() const noexcept {
    return written_.load(std::memory_order_relaxed) - read_.load(std::memory_order_acquire) == room_;
  }
  /// The place of what comes next, unless it is full.
  [[nodiscard]] std::size_t next() const noexcept { return written_.load(std::memory_order_relaxed) % room_; }
  void publish() noexcept {
    written_.store(written_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  // The thread that reads.
  [[nodiscard]] std::size_t waiting() const noexcept {
    return written_.load(std::memory_order_acquire) - read_.load(std::memory_order_relaxed);
  }
  /// The place of the one that is the @p number-th to wait, from 0 on.
  [[nodiscard]] std::size_t at(std::size_t number) const noexcept {
    return (read_.load(std::memory_order_relaxed) + number) % room_;
  }
  /// The first @p count that wait have been read.
  void release(std::size_t count) noexcept {
    read_.store(read_.load(std::memory_order_relaxed) + count, std::memory_order_release);
  }

 private:
  std::size_t room_;
  std::atomic<std::size_t> written_ = 0;
  std::atomic<std::size_t> read_ = 0;
};

}  // namespace axisd
