#include "daemon/timer.hpp"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <sys/timerfd.h>
#include <unistd.h>

namespace axisd {

Timer::Timer() : descriptor_{timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)} {
  if (!descriptor_) throw std::system_error{errno, std::generic_category(), "cannot create a timer"};
}

void Timer::wake_by(canopen::TimePoint when) noexcept {
  if (when >= set_) return;
  set_ = when;
  const auto since_start = when.time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since_start);
  itimerspec setting{};
  setting.it_value.tv_sec = seconds.count();
  setting.it_value.tv_nsec = (since_start - seconds).count();
  timerfd_settime(descriptor_.get(), TFD_TIMER_ABSTIME, &setting, nullptr);
}

void Timer::acknowledge() noexcept {
  std::uint64_t expirations = 0;
  [[maybe_unused]] const ssize_t got = read(descriptor_.get(), &expirations, sizeof expirations);
  set_ = canopen::kNever;
}

}  // namespace axisd
