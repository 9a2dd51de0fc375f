#include "daemon/timer.hpp"

#include <cerrno>
#include <system_error>

#include <sys/timerfd.h>

namespace axisd {

Timer::Timer() : descriptor_{timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)} {
  if (!descriptor_) throw std::system_error{errno, std::generic_category(), "cannot create a timer"};
}

void Timer::set(canopen::TimePoint when) noexcept {
  set_ = when;
  itimerspec setting{};  // zero, which disarms, for never
  if (when != canopen::kNever) {
    const auto since_start = when.time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since_start);
    setting.it_value.tv_sec = seconds.count();
    setting.it_value.tv_nsec = (since_start - seconds).count();
  }
  // Setting it also takes back the expirations that have not been read, so that nobody has to read them.
  timerfd_settime(descriptor_.get(), TFD_TIMER_ABSTIME, &setting, nullptr);
}

}  // namespace axisd
