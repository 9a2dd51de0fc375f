#include "can/preload/time/base/clock.hpp"

#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"

namespace preload {

namespace {

std::atomic<int64_t> shown;
std::atomic<int64_t> wall_offset;

/// Of Pace::Scaled; written before pace is.
struct Course {
  double scale = 1;
  int64_t begin_ns = 0;
  int64_t machine_begin_ns = 0;
};
Course course;

}  // namespace

void go_scaled(double scale, int64_t begin_ns, int64_t machine_begin_ns, int64_t wall_offset_ns) noexcept {
  course = {scale, begin_ns, machine_begin_ns};
  wall_offset = wall_offset_ns;
  pace.store(Pace::Scaled, std::memory_order_release);
}

void go_by_turns(int64_t wall_offset_ns) noexcept {
  wall_offset = wall_offset_ns;
  pace.store(Pace::Turns, std::memory_order_release);
}

void show_present(int64_t instant) noexcept {
  shown.store(instant, std::memory_order_relaxed);
}

int64_t present() noexcept {
  if (by_turns()) return shown.load(std::memory_order_relaxed);
  const auto passed = static_cast<double>(machine_present() - course.machine_begin_ns);
  return course.begin_ns + static_cast<int64_t>(passed * course.scale);
}

int64_t wall_time(int64_t instant) noexcept {
  return instant + wall_offset.load(std::memory_order_relaxed);
}

bool is_of_bus(clockid_t clock, int64_t& offset) noexcept {
  switch (clock) {
    case CLOCK_REALTIME:
    case CLOCK_REALTIME_COARSE:
    case CLOCK_REALTIME_ALARM:
    case CLOCK_TAI:
      offset = wall_offset.load(std::memory_order_relaxed);
      return true;
    case CLOCK_MONOTONIC:
    case CLOCK_MONOTONIC_RAW:
    case CLOCK_MONOTONIC_COARSE:
    case CLOCK_BOOTTIME:
    case CLOCK_BOOTTIME_ALARM:
      offset = 0;
      return true;
    default:  // processor time
      return false;
  }
}

int64_t machine_present() noexcept {
  timespec now{};
  real().clock_gettime(CLOCK_MONOTONIC, &now);
  return ns_of(now);
}

int64_t machine_duration(int64_t duration) noexcept {
  if (duration == kNoInstant) return kNoInstant;
  const double machines = static_cast<double>(duration) / course.scale;
  return machines >= static_cast<double>(kNoInstant) ? kNoInstant : static_cast<int64_t>(machines);
}

int64_t machine_left(int64_t deadline) noexcept {
  const int64_t now = present();
  return machine_duration(deadline > now ? deadline - now : 0);
}

int64_t machine_instant(int64_t instant) noexcept {
  if (instant == kNoInstant) return kNoInstant;
  if (by_turns()) return after(machine_present(), instant > present() ? instant - present() : 0);
  const int64_t duration = instant > course.begin_ns ? instant - course.begin_ns : 0;
  return after(course.machine_begin_ns, machine_duration(duration));
}

}  // namespace preload
