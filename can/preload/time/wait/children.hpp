#pragma once

#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/wait/thread.hpp"

namespace preload {

/// Whether there is a child to be waited for.
bool has_ended_child() noexcept;
/// The program has waited for one.
void note_reaped() noexcept;

/// The hub has told that a child has ended: waits until the kernel says so, too, and until its signal has been
/// taken. Ends the waits that this ends; @p self coordinates.
void take_end_of_child(Thread& self, TimeLock& lock) noexcept;

}  // namespace preload
