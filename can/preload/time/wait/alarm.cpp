#include "can/preload/time/wait/alarm.hpp"

#include <cerrno>
#include <cstring>

#include <sys/syscall.h>
#include <unistd.h>

#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/scheduler.hpp"
#include "can/preload/time/wait/signals.hpp"

namespace preload {

namespace {

void send_signal(const BusTimer& timer) noexcept {
  siginfo_t info{};
  info.si_signo = timer.signal;
  info.si_code = SI_TIMER;
  info.si_value = timer.value;
  info.si_overrun = timer.overruns;
  if (timer.alarm == Alarm::SignalToThread)
    real().syscall(SYS_rt_tgsigqueueinfo, getpid(), timer.thread, timer.signal, &info);
  else
    real().syscall(SYS_rt_sigqueueinfo, getpid(), timer.signal, &info);
}

bool has_handler(int number) noexcept {
  struct sigaction action {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
}

/// Whether a thread that sleeps beside @p self takes signal @p number.
bool can_be_taken(int number, const Thread& self) noexcept {
  for (const Thread* thread = threads().waiting.first(); thread != nullptr; thread = thread->following) {
    const sigset_t* const blocked = open_mask(*thread);
    if (thread != &self && (blocked == nullptr || sigismember(blocked, number) == 0)) return true;
  }
  return false;
}

/// Another thread is to take the signal: its wait is interrupted then, as @p interruptions were before.
void await_taken(int number, unsigned interruptions, const Thread& self, TimeLock& lock) noexcept {
  constexpr int kMostLooks = 400;
  const timespec moment{.tv_sec = 0, .tv_nsec = kNsOfMillisecond / 2};
  if (!has_handler(number)) return;
  const Threads& all = threads();
  for (int i = 0; i < kMostLooks && all.interruptions == interruptions; ++i) {
    if (all.running > 0 || all.runnable.first() != nullptr || !can_be_taken(number, self)) return;
    lock.release();
    real().nanosleep(&moment, nullptr);
    lock.take();
  }
}

struct Notification {
  void (*function)(sigval);
  sigval value;
};

void* notify(void* argument) noexcept {
  Notification notification{};
  memcpy(&notification, argument, sizeof notification);
  free(argument);
  notification.function(notification.value);
  return nullptr;
}

void start_notification(const BusTimer& timer) noexcept {
  auto* const notification = static_cast<Notification*>(malloc(sizeof(Notification)));
  if (notification == nullptr) return;
  *notification = {timer.function, timer.value};
  pthread_attr_t detached;
  pthread_attr_init(&detached);
  pthread_attr_setdetachstate(&detached, PTHREAD_CREATE_DETACHED);
  pthread_t thread{};
  if (pthread_create(&thread, &detached, notify, notification) != 0) free(notification);
  pthread_attr_destroy(&detached);
}

}  // namespace

void settle_signal(int number, bool taken, unsigned interruptions, Thread& self, TimeLock& lock) noexcept {
  if (taken && self.place == Place::Waiting)
    make_runnable(self, Ended::Signal);
  else if (!taken && !threads().waiting.is_single())
    await_taken(number, interruptions, self, lock);
}

void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept {
  if (timer.alarm == Alarm::None) return;
  const BusTimer copy = timer;
  const unsigned interruptions = threads().interruptions;
  lock.release();
  if (copy.alarm == Alarm::Function) {
    start_notification(copy);
    return lock.take();
  }
  const bool taken = do_and_take_signals([&copy]() noexcept { send_signal(copy); }, self);
  lock.take();
  settle_signal(copy.signal, taken, interruptions, self, lock);
}

}  // namespace preload
