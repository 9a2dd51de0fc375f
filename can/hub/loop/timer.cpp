#include "can/hub/loop/timer.hpp"

#include <cerrno>
#include <system_error>

namespace hub {

Timer::Timer(Poll& poll) {
  if (!poll.add(timer_.descriptor(), EPOLLIN, *this))
    throw std::system_error{errno, std::generic_category(), "timerfd_create"};
}

void Timer::wake_at(canopen::TimePoint when) noexcept {
  if (when >= armed_) return;
  armed_ = when;
  timer_.ring_at(when.time_since_epoch());
}

void Timer::on_events(std::uint32_t) noexcept {
  if (timer_.take()) armed_ = canopen::kNever;
}

}  // namespace hub
