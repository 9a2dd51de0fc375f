#include "can/preload/time/base/lock.hpp"

#include <atomic>
#include <climits>
#include <cstdint>

#include <linux/futex.h>
#include <sys/syscall.h>

#include "can/preload/time/base/real.hpp"

namespace preload {

namespace {

enum : uint32_t { kFree, kTaken, kWanted };

std::atomic<uint32_t> word;
std::atomic<const char*> owner;

struct Later {
  void (*call)(void*) = nullptr;
  void* subject = nullptr;
};
Later later;

/// Its address is the thread's name.
[[gnu::tls_model("initial-exec")]] thread_local char own_mark;

void sleep_while_wanted() noexcept {
  real().syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, kWanted, nullptr, nullptr, 0);
}

}  // namespace

TimeLock::TimeLock() noexcept {
  take();
}

TimeLock::~TimeLock() {
  release();
}

// There is one lock; who takes it or releases it is said by an object all the same.
// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
void TimeLock::take() noexcept {
  uint32_t found = kFree;
  if (!word.compare_exchange_strong(found, kTaken, std::memory_order_acquire))
    while (word.exchange(kWanted, std::memory_order_acquire) != kFree) sleep_while_wanted();
  owner.store(&own_mark, std::memory_order_relaxed);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
void TimeLock::release() noexcept {
  const Later due = later;
  later = {};
  owner.store(nullptr, std::memory_order_relaxed);
  if (word.exchange(kFree, std::memory_order_release) == kWanted)
    real().syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
  if (due.call != nullptr) due.call(due.subject);
}

void TimeLock::call_later(void (*call)(void*), void* subject) noexcept {
  if (later.call != nullptr) later.call(later.subject);
  later = {call, subject};
}

bool TimeLock::is_mine() noexcept {
  return owner.load(std::memory_order_relaxed) == &own_mark;
}

void TimeLock::forget() noexcept {
  owner = nullptr;
  later = {};
  word = kFree;
}

}  // namespace preload
