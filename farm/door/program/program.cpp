#include "farm/door/program/program.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <poll.h>
#include <systemd/sd-daemon.h>

#include "service/clock.hpp"

namespace farm {

namespace {

/// Until @p when, rounded up, for poll(); negative: for ever.
int milliseconds_until(canopen::TimePoint when) noexcept {
  constexpr canopen::Duration kLongest = std::chrono::hours{1};
  if (when == canopen::kNever) return -1;
  const canopen::Duration left = std::clamp(when - axisd::read_clock(), canopen::Duration{0}, kLongest);
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count());
}

}  // namespace

Program::Program(const Options& options, const axisd::Log& log)
    : log_{log},
      server_{options.farm.server.url},
      events_{[this] { is_stopping_ = true; }},
      daemons_{events_, std::make_unique<gateway::SocketReach>(options.sockets), log},
      link_{events_, options.farm.server, fmt::format("axisd-nats {}", options.host), *this},
      door_{std::make_unique<Door>(Door::Parts{events_, link_, daemons_, log},
                                   Door::Settings{options.farm.name, options.host, options.read_only})} {
  watch();
}

void Program::watch() {
  std::uint64_t period = 0;
  if (sd_watchdog_enabled(0, &period) <= 0) return;
  watchdog_period_ = std::chrono::microseconds{period} / 2;  // as sd_watchdog_enabled(3) recommends
  watchdog_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Program*>(self)->feed_watchdog();
        return 0;
      },
      this);
  feed_watchdog();
}

/// The server may be away for a while, at the start too: that is no failure of the service.
void Program::run() {
  sd_notify(0, "READY=1");
  while (!is_stopping_) wait();
  sd_notify(0, "STOPPING=1");
}

void Program::on_up() {
  log_.info("{}: connected", server_);
  door_->on_up();
}

void Program::on_down(const std::string& why) {
  log_.warning("{}: {}", server_, why);
}

void Program::wait() {
  pollfd rare{events_.descriptor(), POLLIN, 0};
  if (!more_) ::poll(&rare, 1, milliseconds_until(log_.due()));
  more_ = events_.dispatch();
  if (const canopen::TimePoint now = axisd::read_clock(); log_.due() <= now) log_.tell_left_out(now);
}

void Program::feed_watchdog() {
  sd_notify(0, "WATCHDOG=1");
  axisd::ServiceEvents::start(watchdog_, watchdog_period_);
}

}  // namespace farm
