#include "tests/tools/canopen-check/slave/simulated_wire.hpp"

#include <algorithm>

namespace conformance_test {

void SimulatedWire::collect() {
  for (zoo::Station* const station : stations_)
    for (const canopen::Frame& frame : station->take_frames()) {
      for (zoo::Station* const other : stations_)
        if (other != station) other->on_frame(frame, now_);
      waiting_.push_back({.time = now_, .frame = frame});
    }
}

bool SimulatedWire::send(const canopen::Frame& frame) {
  if (++sent_ > frames_until_loss_) stations_.clear();
  if (!up()) return false;
  now_ += kFrameTime;
  for (zoo::Station* const station : stations_) station->on_frame(frame, now_);
  collect();
  return true;
}

std::optional<conformance::TimedFrame> SimulatedWire::receive(canopen::TimePoint until) {
  while (waiting_.empty()) {
    canopen::TimePoint next = until;
    for (const zoo::Station* const station : stations_) next = std::min(next, station->next_deadline());
    now_ = std::max(now_, next);
    if (stations_.empty() || next >= until) {
      if (now_ < until) now_ = until;
      for (zoo::Station* const station : stations_) station->on_time(now_);
      collect();
      break;
    }
    for (zoo::Station* const station : stations_) station->on_time(now_);
    collect();
  }
  if (waiting_.empty()) return std::nullopt;
  conformance::TimedFrame frame = waiting_.front();
  waiting_.pop_front();
  now_ += kFrameTime;
  return frame;
}

}  // namespace conformance_test
