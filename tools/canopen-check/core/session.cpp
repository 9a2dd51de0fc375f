#include "tools/canopen-check/core/session.hpp"

namespace conformance {
namespace {

bool is_reset(const canopen::Frame& frame) noexcept {
  return frame.id == 0 && !frame.extended && !frame.remote &&
         (frame.data[0] == static_cast<std::uint8_t>(canopen::NmtCommand::ResetNode) ||
          frame.data[0] == static_cast<std::uint8_t>(canopen::NmtCommand::ResetCommunication));
}

}  // namespace

Condition under(std::uint32_t identifier) {
  return [identifier](const canopen::Frame& frame) {
    return frame.id == identifier && !frame.remote && !frame.extended;
  };
}

bool Session::send(const canopen::Frame& frame) {
  if (ended() || (!resets_ && is_reset(frame)) || !wire_->send(frame)) return false;
  keep({.time = wire_->now(), .frame = frame, .sent = true});
  return true;
}

bool Session::command_to(std::uint8_t node_id, canopen::NmtCommand command) {
  return send({.id = 0, .length = 2, .data = {static_cast<std::uint8_t>(command), node_id}});
}

std::optional<TimedFrame> Session::next(canopen::TimePoint until) {
  if (ended()) return std::nullopt;
  const std::optional<TimedFrame> frame = wire_->receive(until);
  if (!frame) return frame;
  keep(*frame);
  constexpr std::uint32_t kEmergency = 0x80;
  if (under(identifier(kEmergency))(frame->frame) && frame->frame.length >= 3) emergency_ = frame->frame;
  return frame;
}

std::optional<TimedFrame> Session::Window::next() {
  if (late_ > kMostLate) return std::nullopt;
  std::optional<TimedFrame> frame = session_->next(until_);
  if (frame && frame->time > until_) ++late_;
  return frame;
}

std::optional<TimedFrame> Session::wait_for(const Condition& condition, canopen::Duration patience) {
  Window window{*this, now() + patience};
  while (std::optional<TimedFrame> frame = window.next())
    if (condition(frame->frame)) return frame;
  return std::nullopt;
}

std::vector<TimedFrame> Session::collect_first(std::size_t count, const Condition& condition,
                                               canopen::Duration span) {
  std::vector<TimedFrame> found;
  Window window{*this, now() + span};
  while (found.size() < count) {
    const std::optional<TimedFrame> frame = window.next();
    if (!frame) break;
    if (condition(frame->frame)) found.push_back(*frame);
  }
  return found;
}

std::vector<TimedFrame> Session::collect(const Condition& condition, canopen::Duration span) {
  return collect_first(static_cast<std::size_t>(-1), condition, span);
}

void Session::pass(canopen::Duration span) {
  Window window{*this, now() + span};
  while (window.next()) {
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
