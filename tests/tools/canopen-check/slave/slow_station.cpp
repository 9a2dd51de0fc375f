#include "tests/tools/canopen-check/slave/slow_station.hpp"

#include <algorithm>

namespace conformance_test {
namespace {

constexpr std::uint32_t kRequest = 0x605, kResponse = 0x585;

bool is_upload(const canopen::Frame& frame) noexcept {
  return frame.id == kRequest && !frame.remote && frame.length == 8 && frame.data[0] == 0x40;
}

}  // namespace

void SlowStation::insert(std::vector<Due>& queue, canopen::TimePoint time, const canopen::Frame& frame) {
  const auto behind = std::ranges::upper_bound(queue, time, {}, &Due::time);
  queue.insert(behind, {.time = time, .frame = frame});
}

bool SlowStation::take(std::vector<Due>& queue, canopen::TimePoint now, Due& due) {
  if (queue.empty() || queue.front().time > now) return false;
  due = queue.front();
  queue.erase(queue.begin());
  return true;
}

void SlowStation::on_frame(const canopen::Frame& frame, canopen::TimePoint now) {
  on_time(now);
  const auto waits = [](const Due& due) { return is_upload(due.frame); };
  if (is_upload(frame) && std::ranges::any_of(incoming_, waits)) {
    ++overlapping_;
    if (slowness_.one_upload) return;
  }
  const canopen::TimePoint due = now + (frame.id == kRequest && !frame.remote ? slowness_.sdo : slowness_.others);
  insert(incoming_, incoming_.empty() ? due : std::max(due, incoming_.back().time), frame);
}

void SlowStation::collect(canopen::TimePoint now) {
  for (const canopen::Frame& frame : slave_->take_frames())
    insert(outgoing_, now + (frame.id == kResponse ? canopen::Duration::zero() : slowness_.out), frame);
}

void SlowStation::on_time(canopen::TimePoint now) {
  for (canopen::TimePoint next = now; next <= now;) {
    const canopen::TimePoint timer = next_look();
    next = incoming_.empty() ? timer : std::min(timer, incoming_.front().time);
    if (next > now) break;
    if (Due due; take(incoming_, next, due)) {
      slave_->on_frame(due.frame, due.time);
    } else {
      slave_->on_time(next);
    }
    collect(next);
  }
  for (Due due; take(outgoing_, now, due);) sent_.push_back(due.frame);
}

canopen::TimePoint SlowStation::next_look() const {
  const canopen::TimePoint due = slave_->next_deadline();
  const canopen::Duration tick = slowness_.tick, since = due.time_since_epoch();
  const bool never = due == canopen::TimePoint::max();
  if (never || tick == tick.zero() || since % tick == tick.zero()) return due;
  return due + (tick - since % tick);
}

canopen::TimePoint SlowStation::next_deadline() const {
  canopen::TimePoint next = next_look();
  for (const std::vector<Due>* const queue : {&incoming_, &outgoing_})
    if (!queue->empty()) next = std::min(next, queue->front().time);
  return next;
}

}  // namespace conformance_test
