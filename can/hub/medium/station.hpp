#pragma once

#include <array>
#include <cstdint>

#include "can/hub/medium/medium.hpp"

namespace hub {

/// What a Medium keeps for one participant: its frames that wait for the bus, in their order.
class Station {
 public:
  /// A frame that waits.
  struct Waiting {
    Passage passage;
    canopen::TimePoint arrival;  ///< when it was handed over
    std::uint64_t number = 0;    ///< of all frames of the medium: the order in which they were handed over
    std::uint32_t priority = 0;  ///< arbitration_field()
  };

  explicit Station(Participant& owner) noexcept : participant{&owner} {}

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] bool full() const noexcept { return count_ == ring_.size(); }
  /// Frames that wait.
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

  /// Takes all frames away.
  void clear() noexcept { count_ = 0; }

  Participant* participant;  ///< nullptr: it has left
  Identity left;             ///< who that was, if frames met an interference then
  bool refused = false;      ///< it had to be told that there was no room

 private:
  std::array<Waiting, Medium::kQueue> ring_;
  std::size_t head_ = 0;
  std::size_t count_ = 0;
};

}  // namespace hub
