#include "can/preload/time/wait/stuck.hpp"

#include <cstdio>
#include <ctime>

#include <fcntl.h>
#include <unistd.h>

#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/thread.hpp"

namespace preload {

namespace {

/// Who computes for longer than this (ns of processor time) may wait for another thread in a loop.
constexpr int64_t kLongComputation = 20 * kNsOfMillisecond;
/// Who is seen asleep so many times in a row is blocked.
constexpr int kBlockedLooks = 4;
/// Between two of those looks (ns), however many threads ask.
constexpr int64_t kBetweenLooks = 4 * kNsOfMillisecond;

/// The kernel's clock of a thread's processor time.
constexpr clockid_t clock_of(int id) noexcept {
  constexpr int kBits = 3;
  constexpr int kScheduledTimeOfThread = 6;
  return static_cast<clockid_t>(static_cast<unsigned>(~id) << kBits | kScheduledTimeOfThread);
}

/// Whether the kernel has @p thread asleep; one that was woken, but has no processor yet, is not.
bool is_blocked(const Thread& thread) noexcept {
  char path[64];
  snprintf(path, sizeof path, "/proc/self/task/%d/wchan", thread.id.load());
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  char place[2]{};
  const ssize_t size = next().read(file, place, sizeof place);
  next().close(file);
  return size > 0 && place[0] != '0';
}

int64_t processor_time_of(const Thread& thread) noexcept {
  timespec used{};
  return real().clock_gettime(clock_of(thread.id), &used) == 0 ? ns_of(used) : 0;
}

bool is_busy(Thread& thread) noexcept {
  if (thread.place != Place::Running || thread.id == 0) return false;
  Patience& patience = thread.patience;
  if (const int64_t now = machine_present(); now - patience.looked_ns >= kBetweenLooks) {
    patience.looked_ns = now;
    patience.blocked = is_blocked(thread) ? patience.blocked + 1 : 0;
  }
  const int64_t used = processor_time_of(thread);
  if (patience.processor_ns < 0) patience.processor_ns = used;
  return patience.blocked < kBlockedLooks && used - patience.processor_ns < kLongComputation;
}

}  // namespace

bool are_runners_stuck() noexcept {
  bool busy = false;
  for_each_thread([](Thread& thread, void* found) { *static_cast<bool*>(found) |= is_busy(thread); }, &busy);
  return !busy;
}

}  // namespace preload
