#include "can/preload/time/base/hidden.hpp"

#include <atomic>

#include <fcntl.h>
#include <sys/resource.h>

#include "can/preload/next.hpp"

namespace preload {

namespace {

/// Below what select(2) takes, should a program count on that, and above what programs open.
constexpr int kFirstHidden = 900;
constexpr int kMostHidden = 4096;
std::atomic<bool> hidden[kMostHidden];
std::atomic<int> count_hidden;

/// Where they begin where a process may not have so many.
int lowest_hidden() noexcept {
  constexpr rlim_t kReserve = 64, kWanted = kFirstHidden;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur > kWanted + kReserve) return kFirstHidden;
  return limit.rlim_cur > 2 * kReserve ? static_cast<int>(limit.rlim_cur - kReserve) : 0;
}

void mark(int descriptor, bool is_ours) noexcept {
  if (descriptor < 0 || descriptor >= kMostHidden) return;
  if (hidden[descriptor].exchange(is_ours) != is_ours) count_hidden += is_ours ? 1 : -1;
}

}  // namespace

int hide(int descriptor) noexcept {
  if (descriptor < 0) return descriptor;
  int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, lowest_hidden());
  if (moved >= 0)
    next().close(descriptor);
  else
    moved = descriptor;
  mark(moved, true);
  return moved;
}

void close_hidden(int descriptor) noexcept {
  mark(descriptor, false);
  next().close(descriptor);
}

bool is_hidden(int descriptor) noexcept {
  return count_hidden.load(std::memory_order_relaxed) != 0 && descriptor >= 0 && descriptor < kMostHidden &&
         hidden[descriptor].load(std::memory_order_relaxed);
}

}  // namespace preload
