#pragma once

#include <cstddef>
#include <vector>

#include "unit/time.hpp"

namespace trace {

/// Values with a time in the order of their coming, as many as there is room for from the beginning on. Nothing is
/// allocated after construction.
template <class Item>
class TimedRing {
 public:
  TimedRing() = default;
  explicit TimedRing(std::size_t capacity) : items_(capacity) {}

  std::size_t size() const noexcept { return count_; }
  bool is_full() const noexcept { return count_ == items_.size(); }
  /// Item @p position, 0 = the oldest.
  const Item& operator[](std::size_t position) const noexcept {
    return items_[(first_ + position) % items_.size()];
  }
  void clear() noexcept { first_ = count_ = lost_ = 0; }
  /// Forgets what is older than @p time, and losses that are.
  void forget_before(unit::TimePoint time) noexcept {
    while (count_ > 0 && (*this)[0].time < time) pop();
    if (last_lost_ < time) lost_ = 0;
  }
  /// Puts @p item behind the others; if there is no room, the oldest one leaves.
  void push(const Item& item) noexcept {
    if (is_full()) {
      note_loss((*this)[0].time);
      pop();
    }
    items_[(first_ + count_++) % items_.size()] = item;
  }
  /// Puts @p item behind the others if there is room.
  void push_if_room(const Item& item) noexcept {
    if (is_full()) return note_loss(item.time);
    push(item);
  }
  /// How many were lost because there was no room.
  std::size_t lost() const noexcept { return lost_; }

 private:
  void pop() noexcept {
    first_ = (first_ + 1) % items_.size();
    --count_;
  }
  void note_loss(unit::TimePoint time) noexcept {
    ++lost_;
    last_lost_ = time;
  }

  std::vector<Item> items_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::size_t lost_ = 0;
  unit::TimePoint last_lost_{};
};

}  // namespace trace
