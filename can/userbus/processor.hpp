#pragma once

#include <sched.h>

namespace userbus {

/// A thread that runs on one processor only for a while. Where programs take turns, one acts at a time; who gets
/// the turn is woken soonest where the one who gives it has just run: another processor would have to be woken,
/// too.
struct Stay {
  cpu_set_t before{};  ///< where it could run
  cpu_set_t one{};
  bool is_on = false;
};

/// The calling thread runs on @p processor until end_stay(). Does nothing if it stays already, may not run there,
/// or on no other one, or processors are more than cpu_set_t holds. errno stays.
void begin_stay(Stay& stay, int processor) noexcept;
/// It may run again where it could before; but what others have set meanwhile, as taskset(1), stays, unless it is
/// just that one processor. errno stays.
void end_stay(Stay& stay) noexcept;

}  // namespace userbus
