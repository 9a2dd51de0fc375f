#include "can/hub/loop/timer.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>

#include <sys/timerfd.h>
#include <unistd.h>

namespace hub {

Timer::Timer(Poll& poll) : descriptor_{timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)} {
  if (!descriptor_ || !poll.add(descriptor_.get(), EPOLLIN, *this))
    throw std::system_error{errno, std::generic_category(), "timerfd_create"};
}

void Timer::wake_at(canopen::TimePoint when) noexcept {
  if (when >= armed_) return;
  armed_ = when;
  // zero would switch the timer off
  const auto since_zero = std::max(when.time_since_epoch(), canopen::Duration{1});
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since_zero);
  itimerspec setting{};
  setting.it_value = {.tv_sec = seconds.count(), .tv_nsec = (since_zero - seconds).count()};
  timerfd_settime(descriptor_.get(), TFD_TIMER_ABSTIME, &setting, nullptr);
}

void Timer::on_events(std::uint32_t, canopen::TimePoint) noexcept {
  std::uint64_t expirations = 0;
  if (read(descriptor_.get(), &expirations, sizeof expirations) > 0) armed_ = canopen::kNever;
}

}  // namespace hub
