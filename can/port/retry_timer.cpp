#include "can/port/retry_timer.hpp"

#include <algorithm>

namespace bus {

void RetryTimer::start() noexcept {
  wait_ = kFirst;
  timer_.ring_after(wait_);
}

void RetryTimer::start_later() noexcept {
  wait_ = std::min(2 * wait_, kLongest);
  timer_.ring_after(wait_);
}

}  // namespace bus
