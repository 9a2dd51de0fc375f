#include "tools/canopen-check/core/session.hpp"

namespace conformance {

Condition under(std::uint32_t identifier) {
  return [identifier](const canopen::Frame& frame) {
    return frame.id == identifier && !frame.remote && !frame.extended;
  };
}

bool Session::send(const canopen::Frame& frame) {
  if (ended() || !wire_->send(frame)) return false;
  keep({.time = wire_->now(), .frame = frame, .sent = true});
  return true;
}

bool Session::command_to(std::uint8_t node_id, canopen::NmtCommand command) {
  return send({.id = 0, .length = 2, .data = {static_cast<std::uint8_t>(command), node_id}});
}

std::optional<TimedFrame> Session::next(canopen::TimePoint until) {
  if (ended()) return std::nullopt;
  const std::optional<TimedFrame> frame = wire_->receive(until);
  if (frame) keep(*frame);
  return frame;
}

std::optional<TimedFrame> Session::wait_for(const Condition& condition, canopen::Duration patience) {
  const canopen::TimePoint until = now() + patience;
  while (const std::optional<TimedFrame> frame = next(until))
    if (condition(frame->frame)) return frame;
  return std::nullopt;
}

std::vector<TimedFrame> Session::collect(const Condition& condition, canopen::Duration span) {
  std::vector<TimedFrame> found;
  const canopen::TimePoint until = now() + span;
  while (const std::optional<TimedFrame> frame = next(until))
    if (condition(frame->frame)) found.push_back(*frame);
  return found;
}

void Session::pass(canopen::Duration span) {
  const canopen::TimePoint until = now() + span;
  while (next(until)) {
  }
}

void Session::drain() {
  pass(canopen::Duration::zero());
}

std::span<const TimedFrame> Session::since(std::size_t mark) const noexcept {
  return std::span{frames_}.subspan(std::min(mark, frames_.size()));
}

void Session::keep(const TimedFrame& frame) {
  if (frames_.size() < kMostFrames) frames_.push_back(frame);
}

}  // namespace conformance
