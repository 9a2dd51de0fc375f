// clock_gettime, gettimeofday, time, timespec_get: clocks show the time of the bus.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// The present, for a program that looks at it.
int64_t look_at_present() noexcept {
  if (by_turns()) note_idle();
  return present();
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::look_at_present;
using preload::real;
using preload::wall_time;

PRELOAD_EXPORT int clock_gettime(clockid_t clock, timespec* time) noexcept {
  int64_t offset = 0;
  if (by_machine() || !preload::is_of_bus(clock, offset)) return real().clock_gettime(clock, time);
  *time = preload::timespec_of(look_at_present() + offset);
  return 0;
}

PRELOAD_EXPORT int gettimeofday(timeval* time, void* zone) noexcept {
  if (by_machine()) return real().gettimeofday(time, zone);
  if (zone != nullptr) real().gettimeofday(nullptr, zone);
  *time = preload::timeval_of(wall_time(look_at_present()));
  return 0;
}

PRELOAD_EXPORT time_t time(time_t* seconds) noexcept {
  if (by_machine()) return real().time(seconds);
  const time_t now = wall_time(look_at_present()) / preload::kNsOfSecond;
  if (seconds != nullptr) *seconds = now;
  return now;
}

PRELOAD_EXPORT int timespec_get(timespec* time, int base) noexcept {
  if (by_machine() || base != TIME_UTC) return real().timespec_get(time, base);
  *time = preload::timespec_of(wall_time(look_at_present()));
  return base;
}
