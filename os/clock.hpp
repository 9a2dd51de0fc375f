#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

namespace os {

/// A clock in place of the machine's: that of a bus with a time of its own.
class OtherTime {
 public:
  OtherTime() = default;
  OtherTime(const OtherTime&) = delete;
  OtherTime& operator=(const OtherTime&) = delete;
  virtual ~OtherTime() = default;

  /// What stands for CLOCK_MONOTONIC, since its zero.
  [[nodiscard]] virtual std::chrono::nanoseconds monotonic() const noexcept = 0;
  /// What stands for CLOCK_REALTIME, since 1 January 1970, 0:00 UTC.
  [[nodiscard]] virtual std::chrono::nanoseconds wall() const noexcept = 0;
  /// Whether it stands while this process does something: what another thread does meanwhile takes no time of it.
  [[nodiscard]] virtual bool stands_while_acting() const noexcept = 0;
  /// Waits by it until @p descriptor is readable.
  virtual void wait_readable(int descriptor) noexcept = 0;
  /// The process has sent a frame at the present.
  virtual void note_sent() noexcept = 0;
  /// It has done something else that others can notice.
  virtual void note_touched() noexcept = 0;
  /// A thread of it has left something for another one, which looks before time goes on.
  virtual void note_handed_over() noexcept = 0;
};

/// The clock of the process, nullptr: the machine's.
inline OtherTime* other_time = nullptr;

/// The process lives by @p time from now on, which outlives it; before it has threads.
inline void use_time(OtherTime& time) noexcept {
  other_time = &time;
}

/// OtherTime::note_handed_over() where there is one.
inline void note_handed_over() noexcept {
  if (other_time != nullptr) other_time->note_handed_over();
}

/// Whether a thread that is waited for takes no time of the clock, so that what it does can as well be done at
/// once.
inline bool stands_while_acting() noexcept {
  return other_time != nullptr && other_time->stands_while_acting();
}

/// The present on a clock of the machine, whatever clock the process lives by, since the clock's zero.
inline std::chrono::nanoseconds machine_time(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

/// The present on CLOCK_MONOTONIC, since its zero.
inline std::chrono::nanoseconds monotonic_time() noexcept {
  return other_time == nullptr ? machine_time(CLOCK_MONOTONIC) : other_time->monotonic();
}

/// The present on CLOCK_REALTIME, since 1 January 1970, 0:00 UTC.
inline std::chrono::nanoseconds wall_time() noexcept {
  return other_time == nullptr ? machine_time(CLOCK_REALTIME) : other_time->wall();
}

/// @p time, not negative, as system calls take it.
constexpr timespec to_timespec(std::chrono::nanoseconds time) noexcept {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  return {.tv_sec = seconds.count(), .tv_nsec = (time - seconds).count()};
}

/// What poll(2) takes for @p left: milliseconds, rounded up, an hour at most.
constexpr int poll_limit(std::chrono::nanoseconds left) noexcept {
  constexpr std::chrono::nanoseconds kLongest = std::chrono::hours{1};
  const auto limit = std::clamp(left, std::chrono::nanoseconds{0}, kLongest);
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(limit).count());
}

}  // namespace os
