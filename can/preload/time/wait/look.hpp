#pragma once

#include <cerrno>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

/// What poll(2) and its relatives do: looks until there is something, or until the deadline of @p wait, which says
/// what is waited for between. @p look asks the kernel without waiting, @p by_machine waits by the machine's clock
/// until a deadline of the bus's. Returns what these do, 0 at the deadline, -1 with EINTR for a signal.
template <class Look, class ByMachine>
int look_until(Wait wait, Look look, ByMachine by_machine) noexcept {
  if (!by_turns()) return by_machine(wait.deadline);
  if (wait.deadline <= present()) {
    const int ready = look();
    if (ready == 0) note_idle();
    if (ready >= 0) note_poll();
    return ready;
  }
  wait.polled = true;
  for (;;) {
    const int ready = look();
    if (ready > 0) note_poll();
    if (ready != 0) return ready;
    switch (wait_for(wait)) {
      case Ended::Ready:
        break;
      case Ended::Deadline:
        return 0;
      case Ended::Signal:
        errno = EINTR;
        return -1;
      case Ended::Gone:
        return by_machine(wait.deadline);
    }
  }
}

}  // namespace preload
