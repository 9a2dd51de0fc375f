#include "libcanopen/base/timer_queue.hpp"

#include <cassert>

namespace canopen {

TimerQueue::TimerQueue(std::size_t timers) {
  add(timers);
}

std::size_t TimerQueue::add(std::size_t timers) {
  const std::size_t first = position_.size();
  position_.resize(first + timers, kOut);
  heap_.reserve(position_.size());
  return first;
}

void TimerQueue::arm(std::size_t timer, TimePoint when) noexcept {
  assert(timer < position_.size());
  const Node node{when, static_cast<std::uint32_t>(timer)};
  if (position_[timer] == kOut) {
    heap_.push_back(node);  // within the capacity reserved by add()
    rise(heap_.size() - 1, node);
  } else if (const std::size_t at = position_[timer]; node < heap_[at]) {
    rise(at, node);
  } else {
    sink(at, node);
  }
  earliest_ = heap_.front().when;
}

void TimerQueue::cancel(std::size_t timer) noexcept {
  assert(timer < position_.size());
  if (position_[timer] != kOut) remove_at(position_[timer]);
}

void TimerQueue::clear() noexcept {
  for (const Node& node : heap_) position_[node.timer] = kOut;
  heap_.clear();
  note_earliest();
}

std::size_t TimerQueue::take_first() noexcept {
  const std::size_t timer = heap_.front().timer;
  remove_at(0);
  return timer;
}

void TimerQueue::place(std::size_t at, Node node) noexcept {
  heap_[at] = node;
  position_[node.timer] = static_cast<std::uint32_t>(at);
}

void TimerQueue::rise(std::size_t at, Node node) noexcept {
  while (at > 0) {
    const std::size_t parent = (at - 1) / 2;
    if (!(node < heap_[parent])) break;
    place(at, heap_[parent]);
    at = parent;
  }
  place(at, node);
}

void TimerQueue::sink(std::size_t at, Node node) noexcept {
  for (;;) {
    std::size_t child = 2 * at + 1;
    if (child >= heap_.size()) break;
    if (child + 1 < heap_.size() && heap_[child + 1] < heap_[child]) ++child;
    if (!(heap_[child] < node)) break;
    place(at, heap_[child]);
    at = child;
  }
  place(at, node);
}

/// Puts @p node where a gap is, at @p at or where it belongs from there.
void TimerQueue::fill(std::size_t at, Node node) noexcept {
  if (at > 0 && node < heap_[(at - 1) / 2]) {
    rise(at, node);
  } else {
    sink(at, node);
  }
}

void TimerQueue::remove_at(std::size_t at) noexcept {
  position_[heap_[at].timer] = kOut;
  const Node last = heap_.back();
  heap_.pop_back();
  if (at != heap_.size()) fill(at, last);
  note_earliest();
}

}  // namespace canopen
