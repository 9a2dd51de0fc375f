#include "os/timer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/timerfd.h>

#include "os/clock.hpp"

namespace os {

Timer::Timer() : timer_{::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)} {
  if (!timer_) throw std::system_error{errno, std::generic_category(), "cannot create a timer"};
}

void Timer::ring_at(std::chrono::nanoseconds since_zero) noexcept {
  set(TFD_TIMER_ABSTIME, std::max(since_zero, std::chrono::nanoseconds{1}));  // zero would switch it off
}

bool Timer::take() noexcept {
  std::uint64_t expirations = 0;
  return ::read(timer_.get(), &expirations, sizeof expirations) == sizeof expirations;
}

void Timer::set(int flags, std::chrono::nanoseconds value) noexcept {
  const itimerspec setting{.it_interval = {}, .it_value = to_timespec(value)};
  ::timerfd_settime(timer_.get(), flags, &setting, nullptr);
}

}  // namespace os
