#include "can/hub/time/processor.hpp"

#include <sched.h>

namespace hub {

namespace {

/// How long the hub stays. To have moved all costs some tens of microseconds.
constexpr canopen::Duration kStay = std::chrono::milliseconds{50};

}  // namespace

unsigned Processor::choose(canopen::TimePoint now) noexcept {
  const int processor = sched_getcpu();
  if (stay_.is_on && now >= until_) {
    userbus::end_stay(stay_);  // its next sleep ends where the kernel likes
  } else if (!stay_.is_on) {
    userbus::begin_stay(stay_, processor);
    until_ = now + kStay;
  }
  return static_cast<unsigned>(processor + 1);
}

}  // namespace hub
