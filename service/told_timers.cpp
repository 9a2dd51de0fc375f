#include "service/told_timers.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "service/clock.hpp"

namespace axisd {

ToldTimers::~ToldTimers() {
  for (Timer* const timer : timers_) timer->owner = nullptr;
}

int ToldTimers::add(sd_event* event, sd_event_source** source, sd_event_time_handler_t handler, void* userdata) {
  auto timer = std::make_unique<Timer>(Timer{this, nullptr, handler, userdata});
  timers_.push_back(timer.get());
  const auto never = [](sd_event_source*, std::uint64_t, void*) { return 0; };
  const int result = sd_event_add_time(event, source, CLOCK_MONOTONIC, UINT64_MAX, 0, never, timer.get());
  if (result < 0) {
    timers_.pop_back();
    return result;
  }
  timer->source = *source;
  sd_event_source_set_destroy_callback(*source, &ToldTimers::forget);
  static_cast<void>(timer.release());
  return result;
}

void ToldTimers::forget(void* timer) noexcept {
  const std::unique_ptr<Timer> gone{static_cast<Timer*>(timer)};
  if (gone->owner != nullptr) gone->owner->timers_.remove(gone.get());
}

void ToldTimers::start(sd_event_source* source, std::chrono::microseconds delay) noexcept {
  static_cast<Timer*>(sd_event_source_get_userdata(source))->due = read_clock() + delay;
}

canopen::TimePoint ToldTimers::due() const noexcept {
  canopen::TimePoint due = canopen::kNever;
  for (const Timer* const timer : timers_) due = std::min(due, timer->due);
  return due;
}

void ToldTimers::ring_one(canopen::TimePoint now) noexcept {
  const auto first = std::ranges::min_element(timers_, {}, [](const Timer* timer) { return timer->due; });
  if (first == timers_.end() || (*first)->due > now) return;
  Timer& timer = **first;
  timer.due = canopen::kNever;
  // it may end itself
  sd_event_source* const source = sd_event_source_ref(timer.source);
  timer.handler(source, 0, timer.userdata);
  sd_event_source_unref(source);
}

}  // namespace axisd
