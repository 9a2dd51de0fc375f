#include "service/service_loop.hpp"

#include <algorithm>
#include <cstdint>

#include <poll.h>
#include <systemd/sd-daemon.h>

#include "service/clock.hpp"

namespace axisd {

ServiceLoop::ServiceLoop(ServiceEvents& events, const Log& log) : events_{events}, log_{log} {
  std::uint64_t period = 0;
  if (sd_watchdog_enabled(0, &period) <= 0) return;
  watchdog_period_ = std::chrono::microseconds{period} / 2;  // as sd_watchdog_enabled(3) recommends
  watchdog_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<ServiceLoop*>(self)->feed_watchdog();
        return 0;
      },
      this);
  feed_watchdog();
}

bool ServiceLoop::turn(canopen::TimePoint until) {
  pollfd rare{events_.descriptor(), POLLIN, 0};
  if (!more_) ::poll(&rare, 1, milliseconds_until(std::min(until, log_.due())));
  more_ = events_.dispatch();
  if (const canopen::TimePoint now = read_clock(); log_.due() <= now) log_.tell_left_out(now);
  return !more_;
}

void ServiceLoop::feed_watchdog() noexcept {
  sd_notify(0, "WATCHDOG=1");
  ServiceEvents::start(watchdog_, watchdog_period_);
}

}  // namespace axisd
