#pragma once

#include <csignal>
#include <cstdint>
#include <ctime>

#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/wait/thread.hpp"

namespace preload {

/// What a timer does when it expires.
enum class Alarm : uint8_t { None, Descriptor, Signal, SignalToThread, Function };

/// A timer of the program that goes by the bus's time. Under the TimeLock.
struct BusTimer {
  bool used = false;
  Alarm alarm = Alarm::None;
  int descriptor = -1;  ///< an eventfd that stands for a timerfd: it counts as that does
  int signal = 0;
  int thread = 0;  ///< of the kernel
  sigval value{};
  void (*function)(sigval) = nullptr;
  int64_t offset = 0;           ///< its clock less the bus's CLOCK_MONOTONIC
  int64_t expiry = kNoInstant;  ///< of the bus's CLOCK_MONOTONIC; kNoInstant: it is not set
  int64_t interval = 0;
  int overruns = 0;  ///< expiries but one that the last signal stands for
};

/// setitimer(ITIMER_REAL)'s and alarm(2)'s.
BusTimer& interval_timer() noexcept;
/// A new one; nullptr if there are too many.
BusTimer* new_timer() noexcept;
/// The timerfd at @p descriptor; nullptr if there is none.
BusTimer* timer_at(int descriptor) noexcept;
/// The timer that @p identifier, of timer_create(2), is; nullptr if it is none of the bus's.
BusTimer* timer_of(timer_t identifier) noexcept;
timer_t identifier_of(const BusTimer& timer) noexcept;
/// The program closes @p descriptor.
void forget_timer(int descriptor) noexcept;
/// In a new process, which inherits none but timerfds.
void forget_timers() noexcept;

/// Sets @p timer as timer_settime(2) does; what was left of it goes to @p before, if there is one.
void set_timer(BusTimer& timer, const itimerspec& time, bool absolute, itimerspec* before = nullptr) noexcept;
/// What is left of it.
itimerspec time_left(const BusTimer& timer) noexcept;

/// When the next one expires.
int64_t first_expiry() noexcept;
/// Does what those do that have expired; a signal ends the wait of @p self, or that of another thread. Whether
/// there were any.
bool fire_due_timers(Thread& self, TimeLock& lock) noexcept;

}  // namespace preload
