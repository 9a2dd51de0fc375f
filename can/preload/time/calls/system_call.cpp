// syscall: what programs ask of the kernel by number, as far as it has to do with time.
#include <cerrno>
#include <climits>
#include <cstdarg>

#include <linux/futex.h>
#include <sys/syscall.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// The six arguments of a system call.
struct Arguments {
  long value[6];

  template <class Type>
  [[nodiscard]] Type* pointer(int i) const noexcept {
    return reinterpret_cast<Type*>(value[i]);
  }
  [[nodiscard]] int number(int i) const noexcept { return static_cast<int>(value[i]); }
};

long call_kernel(long number, const Arguments& all) noexcept {
  const long(&value)[6] = all.value;
  return real().syscall(number, value[0], value[1], value[2], value[3], value[4], value[5]);
}

/// A word of futex(2) and what it is while one waits for it.
struct Expected {
  const uint32_t* word;
  uint32_t value;

  [[nodiscard]] bool is_other() const noexcept { return __atomic_load_n(word, __ATOMIC_SEQ_CST) != value; }
};

bool is_other(void* expected) noexcept {
  return static_cast<Expected*>(expected)->is_other();
}

bool is_other_by_now(const void* expected) noexcept {
  return static_cast<const Expected*>(expected)->is_other();
}

/// When a wait of futex(2) is over: after the time that is given, or when a clock shows it.
int64_t futex_deadline(const Arguments& all, int operation) noexcept {
  const auto* const time = all.pointer<const timespec>(3);
  if (time == nullptr) return kNoInstant;
  const int64_t ns = ns_of(*time);
  if ((operation & FUTEX_CMD_MASK) == FUTEX_WAIT) return after(present(), ns);
  return (operation & FUTEX_CLOCK_REALTIME) != 0 ? ns - wall_time(0) : ns;
}

long wait_for_futex(const Arguments& all, int operation) noexcept {
  const bool with_bits = (operation & FUTEX_CMD_MASK) == FUTEX_WAIT_BITSET;
  Expected expected{all.pointer<const uint32_t>(0), static_cast<uint32_t>(all.value[2])};
  Wait wait{};
  wait.address = expected.word;
  wait.deadline = futex_deadline(all, operation);
  if (with_bits) wait.bits = static_cast<uint32_t>(all.value[5]);
  if ((operation & FUTEX_PRIVATE_FLAG) == 0) wait.is_over = is_other_by_now;
  wait.subject = &expected;
  if (expected.is_other()) return failed(EAGAIN);
  switch (wait_unless(wait, is_other, &expected)) {
    case Ended::Deadline:
      return failed(ETIMEDOUT);
    case Ended::Signal:
      return failed(EINTR);
    case Ended::Ready:
      return 0;
    case Ended::Gone:
      break;
  }
  return 0;  // as if woken for nothing; the next one waits by the machine
}

long wake_for_futex(const Arguments& all, int operation, uint32_t bits, int most) noexcept {
  const int woken = wake(all.pointer<const void>(0), most, bits);
  if ((operation & FUTEX_PRIVATE_FLAG) != 0 && woken > 0) return woken;
  if ((operation & FUTEX_PRIVATE_FLAG) == 0) note_touched();
  const long others = call_kernel(SYS_futex, all);
  return others < 0 ? others : others + woken;
}

long use_futex(const Arguments& all) noexcept {
  const int operation = all.number(1);
  switch (operation & FUTEX_CMD_MASK) {
    case FUTEX_WAIT:
    case FUTEX_WAIT_BITSET:
      return wait_for_futex(all, operation);
    case FUTEX_WAKE:
      return wake_for_futex(all, operation, UINT32_MAX, all.number(2));
    case FUTEX_WAKE_BITSET:
      return wake_for_futex(all, operation, static_cast<uint32_t>(all.value[5]), all.number(2));
    case FUTEX_REQUEUE:
    case FUTEX_CMP_REQUEUE:
    case FUTEX_WAKE_OP:
      return wake_for_futex(all, operation, UINT32_MAX, INT_MAX);
    default:
      return call_kernel(SYS_futex, all);
  }
}

/// The numbers that there is a wrapped call for; each returns as that does, but 0 or -1 with errno for the
/// clock's.
long use_wrapped(long number, const Arguments& all) noexcept {
  switch (number) {
    case SYS_futex:
      return use_futex(all);
    case SYS_clock_gettime:
      return clock_gettime(static_cast<clockid_t>(all.value[0]), all.pointer<timespec>(1));
    case SYS_gettimeofday:
      return gettimeofday(all.pointer<timeval>(0), all.pointer<void>(1));
    case SYS_nanosleep:
      return nanosleep(all.pointer<const timespec>(0), all.pointer<timespec>(1));
    case SYS_clock_nanosleep: {
      const int error = clock_nanosleep(static_cast<clockid_t>(all.value[0]), all.number(1),
                                        all.pointer<const timespec>(2), all.pointer<timespec>(3));
      return error == 0 ? 0 : failed(error);
    }
    case SYS_ppoll:
      return ppoll(all.pointer<pollfd>(0), static_cast<nfds_t>(all.value[1]), all.pointer<const timespec>(2),
                   all.pointer<const sigset_t>(3));
    case SYS_epoll_pwait:
      return epoll_pwait(all.number(0), all.pointer<epoll_event>(1), all.number(2), all.number(3),
                         all.pointer<const sigset_t>(4));
#ifdef SYS_epoll_wait
    case SYS_epoll_wait:
      return epoll_wait(all.number(0), all.pointer<epoll_event>(1), all.number(2), all.number(3));
#endif
    case SYS_exit_group:
      _exit(all.number(0));
    default:
      return call_kernel(number, all);
  }
}

}  // namespace

}  // namespace preload

PRELOAD_EXPORT long syscall(long number, ...) noexcept {
  preload::Arguments all{};
  va_list arguments;
  va_start(arguments, number);
  for (long& value : all.value) value = va_arg(arguments, long);
  va_end(arguments);
  return preload::by_turns() ? preload::use_wrapped(number, all) : preload::call_kernel(number, all);
}
