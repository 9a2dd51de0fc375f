#include <atomic>
#include <csetjmp>
#include <csignal>
#include <semaphore>
#include <thread>

#include <gtest/gtest.h>
#include <sys/epoll.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

/// An epoll set and a timer in it.
struct TimerInSet {
  TimerInSet() {
    epoll_event event{.events = EPOLLIN, .data = {.fd = timer}};
    EXPECT_EQ(epoll_ctl(set, EPOLL_CTL_ADD, timer, &event), 0);
  }
  TimerInSet(const TimerInSet&) = delete;
  TimerInSet& operator=(const TimerInSet&) = delete;
  ~TimerInSet() {
    close(timer);
    close(set);
  }
  void start(nanoseconds first, nanoseconds interval) const {
    const itimerspec wanted{.it_interval = timespec_of(interval), .it_value = timespec_of(first)};
    EXPECT_EQ(timerfd_settime(timer, 0, &wanted, nullptr), 0);
  }
  [[nodiscard]] int wait(int milliseconds) const {
    epoll_event event{};
    return epoll_wait(set, &event, 1, milliseconds);
  }
  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t count = 0;
    EXPECT_EQ(read(timer, &count, sizeof count), static_cast<ssize_t>(sizeof count));
    return count;
  }
  int timer = timerfd_create(CLOCK_MONOTONIC, 0);
  int set = epoll_create1(0);
};

TEST(TimerDescriptor, WakesAnEpollSet) {
  const TimerInSet timer;
  const Stopwatch time;
  timer.start(milliseconds{70}, milliseconds{30});

  EXPECT_EQ(timer.wait(50), 0);
  EXPECT_EQ(time.passed(), milliseconds{50});
  EXPECT_EQ(timer.wait(-1), 1);
  EXPECT_EQ(time.passed(), milliseconds{70});
  EXPECT_EQ(timer.count(), 1u);
  EXPECT_EQ(timer.count(), 1u);  // waits for the next
  EXPECT_EQ(time.passed(), milliseconds{100});
  itimerspec left{};
  EXPECT_EQ(timerfd_gettime(timer.timer, &left), 0);
  EXPECT_EQ(left.it_value.tv_nsec, 30'000'000);
  sleep_for(milliseconds{100});
  EXPECT_EQ(timer.count(), 3u);
}

TEST(TimerDescriptor, IsSilentWhenItIsStopped) {
  const TimerInSet timer;
  timer.start(milliseconds{1}, nanoseconds{0});
  sleep_for(milliseconds{2});
  timer.start(nanoseconds{0}, nanoseconds{0});

  EXPECT_EQ(timer.wait(10), 0);
}

volatile sig_atomic_t alarms;

/// Counts SIGALRM.
struct Alarms {
  Alarms() {
    alarms = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { alarms = alarms + 1; };
    sigaction(SIGALRM, &action, nullptr);
  }
  Alarms(const Alarms&) = delete;
  Alarms& operator=(const Alarms&) = delete;
  ~Alarms() { std::signal(SIGALRM, SIG_DFL); }
};

TEST(IntervalTimer, EndsASleep) {
  const Alarms counted;
  const Stopwatch time;
  const itimerval wanted{.it_interval = {.tv_sec = 0, .tv_usec = 250'000},
                         .it_value = {.tv_sec = 1, .tv_usec = 0}};
  ASSERT_EQ(setitimer(ITIMER_REAL, &wanted, nullptr), 0);
  timespec left{};
  const timespec long_time = timespec_of(seconds{10});

  EXPECT_EQ(nanosleep(&long_time, &left), -1);
  EXPECT_EQ(errno, EINTR);
  EXPECT_EQ(left.tv_sec, 9);
  EXPECT_EQ(time.passed(), seconds{1});
  EXPECT_EQ(pause(), -1);
  EXPECT_EQ(time.passed(), milliseconds{1250});
  EXPECT_EQ(alarms, 2);
  const itimerval none{};
  EXPECT_EQ(setitimer(ITIMER_REAL, &none, nullptr), 0);
}

TEST(Alarm, ComesAfterItsSeconds) {
  const Alarms counted;
  const Stopwatch time;
  alarm(30);
  EXPECT_EQ(alarm(20), 30u);
  sigset_t none;
  sigemptyset(&none);

  EXPECT_EQ(sigsuspend(&none), -1);
  EXPECT_EQ(time.passed(), seconds{20});
  EXPECT_EQ(alarms, 1);
}

sigjmp_buf out_of_sleep;

TEST(Alarm, MayJumpOutOfASleep) {
  constexpr unsigned kTimes = 20;
  struct sigaction action {};
  action.sa_handler = [](int) { siglongjmp(out_of_sleep, 1); };
  sigaction(SIGALRM, &action, nullptr);
  sigset_t alarm_only;
  sigemptyset(&alarm_only);
  sigaddset(&alarm_only, SIGALRM);
  pthread_sigmask(SIG_BLOCK, &alarm_only, nullptr);  // of the other thread, which is not who jumps
  std::binary_semaphore ends{0};
  std::thread other{[&] { ends.acquire(); }};
  pthread_sigmask(SIG_UNBLOCK, &alarm_only, nullptr);
  const Stopwatch time;
  std::atomic<unsigned> jumps = 0;
  if (sigsetjmp(out_of_sleep, 1) != 0) ++jumps;
  if (jumps < kTimes) {
    alarm(1);
    sleep(10);
    ADD_FAILURE() << "it has not jumped";
  }
  EXPECT_EQ(time.passed(), seconds{kTimes});

  action.sa_handler = [](int) {};
  sigaction(SIGALRM, &action, nullptr);
  alarm(1);
  EXPECT_EQ(sleep(10), 9u) << "signals come as before";
  sleep(1);
  ends.release();
  other.join();
  EXPECT_EQ(time.passed(), seconds{kTimes + 2});
  signal(SIGALRM, SIG_DFL);
}

TEST(PosixTimer, SendsItsSignal) {
  sigset_t wanted;
  sigemptyset(&wanted);
  sigaddset(&wanted, SIGRTMIN);
  pthread_sigmask(SIG_BLOCK, &wanted, nullptr);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGRTMIN;
  event.sigev_value.sival_int = 42;
  timer_t timer{};
  ASSERT_EQ(timer_create(CLOCK_MONOTONIC, &event, &timer), 0);
  const itimerspec time{.it_interval = {}, .it_value = timespec_of(seconds{5})};
  ASSERT_EQ(timer_settime(timer, 0, &time, nullptr), 0);
  const Stopwatch watch;
  siginfo_t info{};
  const timespec limit = timespec_of(seconds{3});

  EXPECT_EQ(sigtimedwait(&wanted, &info, &limit), -1);
  EXPECT_EQ(errno, EAGAIN);
  EXPECT_EQ(watch.passed(), seconds{3});
  EXPECT_EQ(sigwaitinfo(&wanted, &info), SIGRTMIN);
  EXPECT_EQ(watch.passed(), seconds{5});
  EXPECT_EQ(info.si_value.sival_int, 42);
  EXPECT_EQ(timer_delete(timer), 0);
  pthread_sigmask(SIG_UNBLOCK, &wanted, nullptr);
}

}  // namespace
}  // namespace preload_test
