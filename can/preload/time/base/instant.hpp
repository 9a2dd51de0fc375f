#pragma once

#include <cstdint>
#include <ctime>

#include <sys/time.h>

#include "can/userbus/time.hpp"

namespace preload {

inline constexpr int64_t kNsOfSecond = 1'000'000'000;
inline constexpr int64_t kNsOfMillisecond = 1'000'000;
inline constexpr int64_t kNsOfMicrosecond = 1000;
using userbus::kNoInstant;

/// Whether @p time is one that system calls take: not negative, with less than a second of nanoseconds.
constexpr bool is_valid(const timespec& time) noexcept {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < kNsOfSecond;
}

/// In nanoseconds; kNoInstant if it is longer than that.
constexpr int64_t ns_of(const timespec& time) noexcept {
  constexpr int64_t kMostSeconds = INT64_MAX / kNsOfSecond - 1;
  return time.tv_sec > kMostSeconds ? kNoInstant : time.tv_sec * kNsOfSecond + time.tv_nsec;
}

constexpr int64_t ns_of(const timeval& time) noexcept {
  return ns_of(timespec{.tv_sec = time.tv_sec, .tv_nsec = time.tv_usec * kNsOfMicrosecond});
}

/// A limit of time of poll(2), which is none if it is negative, and of ppoll(2), which is none without @p limit.
constexpr int64_t ns_of_limit(int milliseconds) noexcept {
  return milliseconds < 0 ? kNoInstant : milliseconds * kNsOfMillisecond;
}
constexpr int64_t ns_of_limit(const timespec* limit) noexcept {
  return limit == nullptr ? kNoInstant : ns_of(*limit);
}

constexpr timespec timespec_of(int64_t ns) noexcept {
  return {.tv_sec = ns / kNsOfSecond, .tv_nsec = ns % kNsOfSecond};
}

constexpr timeval timeval_of(int64_t ns) noexcept {
  return {.tv_sec = ns / kNsOfSecond, .tv_usec = ns % kNsOfSecond / kNsOfMicrosecond};
}

/// @p duration after @p instant; kNoInstant if there is no end of it.
constexpr int64_t after(int64_t instant, int64_t duration) noexcept {
  return duration >= kNoInstant - instant ? kNoInstant : instant + duration;
}

}  // namespace preload
