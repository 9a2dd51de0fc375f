#include "can/preload/time/wait/alarm.hpp"

#include <cerrno>
#include <cstring>

#include <sys/syscall.h>
#include <unistd.h>

#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/scheduler.hpp"

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

/// Another thread is to take the signal; it becomes runnable when it has.
void await_taken(int number, TimeLock& lock) noexcept {
  constexpr int kMostLooks = 50;
  const timespec moment{.tv_sec = 0, .tv_nsec = kNsOfMillisecond / 2};
  if (!has_handler(number)) return;
  for (int i = 0; i < kMostLooks && threads().runnable.first() == nullptr; ++i) {
    sigset_t pending;
    if (sigpending(&pending) == 0 && sigismember(&pending, number) == 1) return;  // all block it
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

void settle_signal(int number, bool taken, Thread& self, TimeLock& lock) noexcept {
  if (taken && self.place == Place::Waiting)
    make_runnable(self, Ended::Signal);
  else if (!taken && !threads().waiting.is_single())
    await_taken(number, lock);
}

void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept {
  if (timer.alarm == Alarm::None) return;
  const BusTimer copy = timer;
  lock.release();
  if (copy.alarm == Alarm::Function) {
    start_notification(copy);
    return lock.take();
  }
  const bool taken = do_and_take_signals([&copy]() noexcept { send_signal(copy); }, self);
  lock.take();
  settle_signal(copy.signal, taken, self, lock);
}

}  // namespace preload
