#include "can/port/retry_timer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/timerfd.h>

namespace bus {

RetryTimer::RetryTimer() : timer_{::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)} {
  if (!timer_) throw std::system_error{errno, std::generic_category(), "timerfd_create"};
}

void RetryTimer::start() noexcept {
  wait_ = kFirst;
  set(wait_);
}

void RetryTimer::start_later() noexcept {
  wait_ = std::min(2 * wait_, kLongest);
  set(wait_);
}

bool RetryTimer::take() noexcept {
  std::uint64_t expirations = 0;
  return ::read(timer_.get(), &expirations, sizeof expirations) == sizeof expirations;
}

void RetryTimer::set(std::chrono::milliseconds wait) noexcept {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
  itimerspec setting{};
  setting.it_value.tv_sec = seconds.count();
  setting.it_value.tv_nsec = std::chrono::nanoseconds{wait - seconds}.count();
  ::timerfd_settime(timer_.get(), 0, &setting, nullptr);
}

}  // namespace bus
