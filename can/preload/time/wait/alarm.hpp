#pragma once

#include "can/preload/time/wait/timer.hpp"

namespace preload {

/// Does what @p timer, which has expired, does but for a descriptor: a signal, or a function in a thread of its
/// own. The signal ends the wait of @p self, which coordinates, if it comes to that.
void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept;

}  // namespace preload
