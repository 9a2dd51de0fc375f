#include "daemon/watch/frame_tap.hpp"

#include <algorithm>
#include <utility>

#include "service/clock.hpp"

namespace axisd {

bool FrameTap::add(FrameListener& listener) noexcept {
  const bool was_empty = listeners_.is_empty();
  const bool added = listeners_.add(listener);
  if (was_empty && added) owner_.on_tap(true);
  return added;
}

void FrameTap::remove(FrameListener& listener) noexcept {
  if (listeners_.is_empty()) return;
  listeners_.remove(listener);
  if (listeners_.is_empty()) owner_.on_tap(false);
}

void FrameTap::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  on_time(now);
  tell(frame, Direction::Received, now);
}

void FrameTap::on_handled() noexcept {
  const canopen::TimePoint now = std::exchange(now_, canopen::kNever);
  for (FrameListener* const listener : listeners_.all()) listener->on_handled(now);
}

void FrameTap::send(const canopen::Frame& frame, canopen::Delivery delivery) {
  tell(frame, Direction::Sent, now());
  bus_.send(frame, delivery);
}

canopen::TimePoint FrameTap::now() const noexcept {
  return now_ == canopen::kNever ? std::max(told_, read_clock()) : now_;
}

canopen::TimePoint FrameTap::next_deadline() const noexcept {
  canopen::TimePoint earliest = canopen::kNever;
  for (const FrameListener* const listener : listeners_.all())
    earliest = std::min(earliest, listener->next_deadline());
  return earliest;
}

void FrameTap::tell(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept {
  for (FrameListener* const listener : listeners_.all()) listener->on_frame(frame, direction, time);
}

}  // namespace axisd
