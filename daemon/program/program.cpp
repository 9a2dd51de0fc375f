#include "daemon/program/program.hpp"

#include <algorithm>
#include <chrono>

#include <poll.h>

#include "os/clean_pages.hpp"
#include "service/clock.hpp"

namespace axisd {
namespace {

/// When the units have booted, and what only the start needs is not wanted any more.
constexpr canopen::Duration kStart = std::chrono::seconds{1};

}  // namespace

/// The fleet before the signals are caught: whoever waits for a bus can be ended.
Program::Program(const Assignment& assignment, const Log& log, bus::TimeShare* time)
    : log_{log},
      time_{time},
      party_{time == nullptr ? nullptr : &time->add()},
      notification_{assignment.units.size()},
      fleet_{{assignment.units, assignment.threads, assignment.state_root}, log, *this, time},
      events_{[this] { stop(); }},
      watchdog_{fleet_} {
  if (!assignment.control.path.empty())
    dispatcher_.emplace(events_, assignment.control, fleet_, queue_, [this] { stop(); });
  events_.dispatch();  // makes room for as many as are watched now, which it would do with the first of them
}

void Program::run() {
  fleet_.start();
  start_over_ = read_clock() + kStart;
  while (!stopping_) wait();
  Notification::on_stopping();
  fleet_.stop();
}

/// Until something rare has happened, and handles it.
void Program::wait() {
  if (!more_) sleep(std::min({log_.due(), start_over_, events_.due()}));
  more_ = events_.dispatch();
  const canopen::TimePoint now = read_clock();
  watchdog_.on_time(machine_clock());
  if (log_.due() <= now) log_.tell_left_out(now);
  if (start_over_ > now) return;
  start_over_ = canopen::kNever;
  os::give_back_clean_pages();
}

/// The watchdog of systemd knows the machine's clock alone.
void Program::sleep(canopen::TimePoint until) noexcept {
  pollfd rare{events_.descriptor(), POLLIN, 0};
  if (time_ == nullptr) {
    ::poll(&rare, 1, milliseconds_until(std::min(until, watchdog_.due())));
    return;
  }
  const bool is_ready =
      time_->wait(*party_, {.descriptors = {&rare, 1}, .until = until, .machine_until = watchdog_.due()});
  if (is_ready || events_.due() <= read_clock()) time_->note_touched();  // somebody may be told something
}

}  // namespace axisd
