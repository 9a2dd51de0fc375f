#include "can/connection/transmit_queue.hpp"

#include <cassert>

namespace bus {

namespace {

bool same_identifier(const canopen::Frame& a, const canopen::Frame& b) noexcept {
  return a.id == b.id && a.extended == b.extended && a.remote == b.remote;
}

}  // namespace

TransmitQueue::TransmitQueue(Port& port, std::size_t capacity, std::size_t margin)
    : port_{port}, capacity_{capacity}, margin_{margin} {
  assert(capacity > 0 && margin <= capacity);
  ring_.reserve(capacity);
  held_.reserve(kMostHeld);
  deliveries_.reserve(kMostHeld);
}

void TransmitQueue::send(const canopen::Frame& frame, canopen::Delivery delivery) noexcept {
  if (holds_) {
    if (held_.size() == kMostHeld) send_what_is_held();
    held_.push_back(frame);
    return deliveries_.push_back(delivery);
  }
  if (count_ > 0 || !settle(port_.send(frame))) keep({frame, delivery, {}});
}

void TransmitQueue::release() noexcept {
  holds_ = false;
  send_what_is_held();
}

void TransmitQueue::send_what_is_held() noexcept {
  for (std::size_t i = send_held(); i < held_.size(); ++i)
    if (count_ > 0 || !settle(port_.send(held_[i]))) keep({held_[i], deliveries_[i], {}});
  held_.clear();
  deliveries_.clear();
}

/// As many of them as the bus takes; how many that are. What becomes of the next one is up to it alone.
std::size_t TransmitQueue::send_held() noexcept {
  if (count_ > 0 || held_.size() < 2) return 0;
  const std::size_t sent = port_.send_all(held_).count;
  counters_.sent += sent;
  return sent;
}

void TransmitQueue::send_marked(const canopen::Frame& frame, const Mark& mark) noexcept {
  if (count_ > 0 || !settle(port_.send_marked(frame, mark))) keep({frame, canopen::Delivery::Ordered, mark});
}

void TransmitQueue::retry(canopen::TimePoint now) noexcept {
  now_ = now;
  if (now < next_retry_) return;
  // A frame that finds the link down takes all the others with it: count_ is then 0.
  while (count_ > 0 && hand_over(at(0))) {
    if (count_ == 0) return;
    head_ = (head_ + 1) % capacity_;
    if (--count_ == 0) head_ = 0;
  }
}

canopen::TimePoint TransmitQueue::next_retry() const noexcept {
  return count_ > 0 ? next_retry_ : canopen::kNever;
}

bool TransmitQueue::accepts_input() const noexcept {
  return capacity_ - count_ >= margin_;
}

void TransmitQueue::discard() noexcept {
  counters_.dropped += count_;
  count_ = 0;
  head_ = 0;
}

bool TransmitQueue::hand_over(const Waiting& waiting) noexcept {
  return settle(waiting.mark.hub == 0 ? port_.send(waiting.frame)
                                      : port_.send_marked(waiting.frame, waiting.mark));
}

/// What became of an attempt to send; true if the frame needs no further one: it is out, or lost.
bool TransmitQueue::settle(SendStatus status) noexcept {
  switch (status) {
    case SendStatus::Sent:
      ++counters_.sent;
      return true;
    case SendStatus::Full:
      ++counters_.refused;
      next_retry_ = now_ + kFrameTime;
      return false;
    case SendStatus::Down:
      if (count_ == 0) ++counters_.dropped;
      discard();
      return true;
    case SendStatus::Failed:
      ++counters_.dropped;
      return true;
  }
  return true;
}

void TransmitQueue::keep(const Waiting& waiting) noexcept {
  if (waiting.delivery == canopen::Delivery::Replaceable) {
    Waiting* const older = last_of_identifier(waiting.frame);
    if (older != nullptr && older->delivery == canopen::Delivery::Replaceable) {
      older->frame = waiting.frame;
      ++counters_.replaced;
      return;
    }
  }
  if (count_ == capacity_ && !make_room()) {
    ++counters_.dropped;
    return;
  }
  const std::size_t place = (head_ + count_) % capacity_;
  if (place < ring_.size())
    ring_[place] = waiting;
  else
    ring_.push_back(waiting);
  ++count_;
  ++counters_.queued;
}

TransmitQueue::Waiting* TransmitQueue::last_of_identifier(const canopen::Frame& frame) noexcept {
  for (std::size_t i = count_; i > 0; --i)
    if (same_identifier(at(i - 1).frame, frame)) return &at(i - 1);
  return nullptr;
}

/// Drops the oldest replaceable frame; false if there is none.
bool TransmitQueue::make_room() noexcept {
  std::size_t position = 0;
  while (position < count_ && at(position).delivery != canopen::Delivery::Replaceable) ++position;
  if (position == count_) return false;
  for (; position + 1 < count_; ++position) at(position) = at(position + 1);
  --count_;
  ++counters_.dropped;
  return true;
}

}  // namespace bus
