#include "can/hub/faults/talker.hpp"

#include <algorithm>
#include <chrono>

#include "can/hub/medium/bit_time.hpp"

namespace hub::faults {

namespace {

using canopen::Duration;
using canopen::TimePoint;

constexpr std::uint32_t kWhole = 100;  ///< per cent
/// A share of time is that of so long; what the bus was idle before is not made up for.
constexpr Duration kShareTime = std::chrono::milliseconds{10};

Duration time_of(const can_frame& frame, std::uint32_t bit_rate) noexcept {
  if (bit_rate == 0) return Duration::zero();
  return Duration{std::chrono::nanoseconds{std::chrono::seconds{1}}.count() * bits_on_wire(frame) / bit_rate};
}

}  // namespace

Talker::Talker(Medium& medium, injection::Trigger& trigger, const can_frame& frame)
    : medium_{medium}, trigger_{trigger}, frame_{frame} {
  medium_.attach(*this);
}

Talker::~Talker() {
  medium_.withdraw(*this);
  medium_.detach(*this);
}

void Talker::start(TimePoint now) noexcept {
  started_ = true;
  begin(now);
}

TimePoint Talker::next_deadline() const noexcept {
  return started_ && !is_over() ? wanted() : canopen::kNever;
}

void Talker::on_time(TimePoint now) noexcept {
  if (next_deadline() <= now) go_on(now);
}

void Talker::receive(const Passage& passage) noexcept {
  if (passage.sender != this) return;
  --waiting_;
  on_time(medium_.now());
}

bool Talker::speak(TimePoint now) noexcept {
  if (!has_room() || !trigger_.on_opportunity(now)) return false;
  Passage passage;
  passage.frame = frame_;
  passage.sender = this;
  passage.local = false;
  ++waiting_;
  medium_.send(passage, now);
  return true;
}

Duration Talker::frame_time() const noexcept {
  return time_of(frame_, medium_.bit_rate());
}

PeriodicTalker::PeriodicTalker(Medium& medium, injection::Trigger& trigger, const can_frame& frame,
                               Duration period)
    : Talker{medium, trigger, frame}, period_{period} {}

void PeriodicTalker::go_on(TimePoint now) noexcept {
  next_ = std::max(next_, now - period_ * static_cast<int>(Medium::kQueue));
  for (; next_ <= now && !is_over(); next_ += period_) speak(next_);
}

TimePoint EagerTalker::wanted() const noexcept {
  return medium().bit_rate() == 0 || !has_room() ? canopen::kNever : next_;
}

void EagerTalker::go_on(TimePoint now) noexcept {
  while (has_room() && !is_over()) {
    if (speak(now)) continue;
    next_ = now + frame_time();
    return;
  }
}

FillingTalker::FillingTalker(Medium& medium, injection::Trigger& trigger, const can_frame& frame,
                             std::uint32_t percent)
    : Talker{medium, trigger, frame}, percent_{percent} {}

TimePoint FillingTalker::wanted() const noexcept {
  return medium().bit_rate() == 0 || !has_room() ? canopen::kNever : next_;
}

void FillingTalker::on_frame(const Passage& passage, TimePoint end) noexcept {
  if (passage.sender == this) return;  // has been counted when it was sent
  next_ = std::max(next_, end - kShareTime);
  use(time_of(passage.frame, medium().bit_rate()));
}

void FillingTalker::use(Duration time) noexcept {
  next_ += time * static_cast<int>(kWhole) / static_cast<int>(percent_);
}

void FillingTalker::go_on(TimePoint now) noexcept {
  next_ = std::max(next_, now - kShareTime);
  while (next_ <= now && has_room() && !is_over()) {
    use(frame_time());  // also if it is not sent: then the next opportunity comes behind
    speak(now);
  }
}

}  // namespace hub::faults
