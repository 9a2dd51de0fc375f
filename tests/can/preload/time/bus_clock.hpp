#pragma once

#include <chrono>
#include <cstdint>

#include <time.h>

namespace preload_test {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

/// What @p clock shows.
inline nanoseconds shown(clockid_t clock = CLOCK_MONOTONIC) {
  timespec time{};
  clock_gettime(clock, &time);
  return seconds{time.tv_sec} + nanoseconds{time.tv_nsec};
}

/// Measures by the bus's clock, exactly: what a program computes takes no time.
class Stopwatch {
 public:
  [[nodiscard]] nanoseconds passed() const { return shown() - begin_; }

 private:
  nanoseconds begin_ = shown();
};

/// As system calls take it.
inline timespec timespec_of(nanoseconds time) {
  return {.tv_sec = time.count() / 1'000'000'000, .tv_nsec = time.count() % 1'000'000'000};
}

/// Instant @p from_now by @p clock, as system calls take it.
inline timespec instant(nanoseconds from_now, clockid_t clock = CLOCK_MONOTONIC) {
  return timespec_of(shown(clock) + from_now);
}

inline void sleep_for(nanoseconds time) {
  const timespec wanted = timespec_of(time);
  nanosleep(&wanted, nullptr);
}

}  // namespace preload_test
