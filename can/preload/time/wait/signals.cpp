#include "can/preload/time/wait/signals.hpp"

#include <cerrno>

#include <fcntl.h>
#include <linux/futex.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>

#include "can/preload/next.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/base/real.hpp"

namespace preload {

namespace {

/// With a descriptor to be called by, a thread can let signals come and go to sleep in one step.
int bell_of(Thread& self) noexcept {
  if (self.bell == Thread::kNoBell) {
    const int bell = hide(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    self.bell = bell < 0 ? Thread::kNoBellToBeHad : bell;
  }
  return self.bell;
}

int sleep_on_futex(Thread& self, const timespec* limit) noexcept {
  return real().syscall(SYS_futex, &self.go, FUTEX_WAIT_PRIVATE, 0, limit, nullptr, 0) == 0 ? 0 : errno;
}

void ring(void* called) noexcept {
  constexpr uint64_t kOnce = 1;
  Thread& thread = *static_cast<Thread*>(called);
  const int bell = thread.bell;
  if (bell > 0 && next().write(bell, &kOnce, sizeof kOnce) == sizeof kOnce) return;
  real().syscall(SYS_futex, &thread.go, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
}

}  // namespace

void hold_signals(Thread& self) noexcept {
  if (self.holds_signals) return;
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &self.mask_before);
  self.holds_signals = true;
}

void release_signals(Thread& self) noexcept {
  if (!self.holds_signals) return;
  self.holds_signals = false;
  const sigset_t before = self.mask_before;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

bool take_signals(const Thread& self) noexcept {
  const timespec none{};
  return real().ppoll(nullptr, 0, &none, open_mask(self)) < 0 && errno == EINTR;
}

int sleep_until_called(Thread& self, const timespec* limit) noexcept {
  const int bell = bell_of(self);
  if (bell <= 0) {
    release_signals(self);
    return sleep_on_futex(self, limit);
  }
  if (self.go != 0) return 0;
  pollfd called{bell, POLLIN, 0};
  const int ready = real().ppoll(&called, 1, limit, open_mask(self));
  if (ready < 0) return errno;
  if (ready == 0) return ETIMEDOUT;
  uint64_t count = 0;
  return next().read(bell, &count, sizeof count) < 0 ? errno : 0;
}

void call_thread(Thread& thread, int word) noexcept {
  thread.go = word;
  if (&thread != own_thread()) TimeLock::call_later(ring, &thread);
}

}  // namespace preload
