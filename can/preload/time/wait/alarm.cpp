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

/// Sends it with all signals blocked, and lets it come then: whether a handler has run in this thread.
bool send_and_take(const BusTimer& timer, const sigset_t* mask) noexcept {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  send_signal(timer);
  const timespec none{};
  const bool taken = real().ppoll(nullptr, 0, &none, mask != nullptr ? mask : &before) < 0 && errno == EINTR;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return taken;
}

bool has_handler(int number) noexcept {
  struct sigaction action {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
}

/// Another thread is to take the signal; it becomes runnable when it has.
void await_taken(const BusTimer& timer, TimeLock& lock) noexcept {
  constexpr int kMostLooks = 50;
  const timespec moment{.tv_sec = 0, .tv_nsec = kNsOfMillisecond / 2};
  if (!has_handler(timer.signal)) return;
  for (int i = 0; i < kMostLooks && threads().runnable.first() == nullptr; ++i) {
    sigset_t pending;
    if (sigpending(&pending) == 0 && sigismember(&pending, timer.signal) == 1) return;  // all block it
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

void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept {
  if (timer.alarm == Alarm::None) return;
  const BusTimer copy = timer;
  bool taken = false;
  lock.release();
  if (copy.alarm == Alarm::Function)
    start_notification(copy);
  else
    taken = send_and_take(copy, self.wait.mask);
  lock.take();
  if (taken && self.place == Place::Waiting) return make_runnable(self, Ended::Signal);
  if (!taken && copy.alarm != Alarm::Function && !threads().waiting.is_single()) await_taken(copy, lock);
}

}  // namespace preload
