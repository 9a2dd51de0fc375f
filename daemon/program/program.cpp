#include "daemon/program/program.hpp"

#include <algorithm>

#include <poll.h>

#include "os/clean_pages.hpp"
#include "service/clock.hpp"

namespace axisd {

/// The fleet before the signals are caught: whoever waits for a bus can be ended.
Program::Program(const Assignment& assignment, const Log& log)
    : log_{log},
      notification_{assignment.units.size()},
      fleet_{assignment.units, assignment.threads, assignment.state_root, log, *this},
      events_{[this] { stop(); }},
      watchdog_{fleet_} {
  if (!assignment.control.path.empty())
    dispatcher_.emplace(events_, assignment.control, fleet_, queue_, [this] { stop(); });
  events_.dispatch();  // makes room for as many as are watched now, which it would do with the first of them
}

void Program::run() {
  fleet_.start();
  os::give_back_clean_pages();
  while (!stopping_) wait();
  Notification::on_stopping();
  fleet_.stop();
}

/// Until something rare has happened, and handles it.
void Program::wait() {
  const canopen::TimePoint deadline = std::min(watchdog_.due(), log_.due());
  pollfd rare{events_.descriptor(), POLLIN, 0};
  if (!more_) ::poll(&rare, 1, milliseconds_until(deadline));
  more_ = events_.dispatch();
  const canopen::TimePoint now = read_clock();
  watchdog_.on_time(now);
  if (log_.due() <= now) log_.tell_left_out(now);
}

}  // namespace axisd
