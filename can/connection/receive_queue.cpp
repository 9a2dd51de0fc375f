#include "can/connection/receive_queue.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace bus {
namespace {

/// Room that is kept between two bursts, in entries.
constexpr std::size_t kKept = 2048;

}  // namespace

ReceiveQueue::ReceiveQueue(Port& port) : port_{port}, room_{kCapacity * sizeof(Entry)} {}

ReceiveQueue::Entry& ReceiveQueue::at(std::size_t number) const noexcept {
  return static_cast<Entry*>(static_cast<void*>(room_.bytes().data()))[number % kCapacity];
}

void ReceiveQueue::read_ahead() noexcept {
  const std::size_t first = written_;
  const std::size_t end = std::min(first + kMostAtOnce, read_ + kCapacity);
  while (written_ < end && read_some(end - written_) > 0) continue;
  if (written_ == first) return;
  const std::chrono::nanoseconds time = port_.frame_arrival().value_or(std::chrono::nanoseconds{0});
  for (std::size_t i = first; i < written_; ++i) at(i).time = time;
  most_ = std::max(most_, waiting());
}

/// At most @p most (1..); how many that were.
std::size_t ReceiveQueue::read_some(std::size_t most) noexcept {
  constexpr std::size_t kTogether = 64;
  std::array<Arrival, kTogether> arrivals;
  const std::size_t count = port_.receive_all(std::span{arrivals}.first(std::min(most, kTogether)));
  for (std::size_t i = 0; i < count; ++i) at(written_++).arrival = arrivals[i];
  return count;
}

Received ReceiveQueue::receive(canopen::Frame& frame) noexcept {
  is_ahead_ = waiting() > 0;
  if (!is_ahead_) return port_.receive(frame);
  const auto& [arrival, time] = at(read_++);
  if (arrival.received.kind == Received::Frame) frame = arrival.frame;
  time_ = time;
  const Received received = arrival.received;
  if (read_ == written_) discard();
  return received;
}

std::optional<std::chrono::nanoseconds> ReceiveQueue::frame_arrival() const noexcept {
  if (!is_ahead_) return port_.frame_arrival();
  return time_.count() != 0 ? std::optional{time_} : std::nullopt;
}

void ReceiveQueue::discard() noexcept {
  read_ = 0;
  written_ = 0;
}

void ReceiveQueue::rest() noexcept {
  if (most_ > kKept && waiting() == 0) room_.give_back();
  most_ = 0;
}

}  // namespace bus
