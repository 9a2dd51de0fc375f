#include "can/clock/sleeper.hpp"

#include <algorithm>

#include "can/clock/time_share.hpp"
#include "os/clock.hpp"

namespace bus {

Sleeper::Sleeper(TimeShare* time) : time_{time}, party_{time == nullptr ? nullptr : &time->add()} {}

void Sleeper::sleep(std::span<pollfd> descriptors, canopen::TimePoint until) noexcept {
  if (time_ != nullptr) {
    (void)time_->wait(*party_, {.descriptors = descriptors, .until = until});
    return;
  }
  const canopen::Duration left = until - canopen::TimePoint{os::monotonic_time()};
  const timespec limit = os::to_timespec(std::max(left, canopen::Duration::zero()));
  (void)::ppoll(descriptors.data(), descriptors.size(), &limit, nullptr);
}

}  // namespace bus
