#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"
#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

using conformance::CanSocket;
using conformance::frame;

/// Runs @p work in a process of its own, which ends with what it returns.
template <class Work>
pid_t start(Work work) {
  const pid_t process = fork();
  if (process == 0) _exit(work());
  return process;
}

int status_of(pid_t process) {
  int status = -1;
  EXPECT_EQ(waitpid(process, &status, 0), process);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Child, IsWaitedForUntilItsTime) {
  const Stopwatch time;
  const pid_t child = start([] {
    sleep(7);
    return 3;
  });

  EXPECT_EQ(status_of(child), 3);
  EXPECT_EQ(time.passed(), seconds{7});
}

TEST(Child, BeginsAtTheInstantOfItsFork) {
  sleep_for(milliseconds{123});
  const nanoseconds now = shown();
  const pid_t child = start([now] { return shown() == now ? 0 : 1; });

  EXPECT_EQ(status_of(child), 0);
}

TEST(Child, TalksByAPipe) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const Stopwatch time;
  const pid_t child = start([&ends] {
    for (int i = 0; i < 3; ++i) {
      sleep(1);
      if (write(ends[1], "x", 1) != 1) return 1;
    }
    return 0;
  });
  close(ends[1]);
  char byte = 0;

  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(read(ends[0], &byte, 1), 1);
    EXPECT_EQ(time.passed(), seconds{i});
  }
  EXPECT_EQ(read(ends[0], &byte, 1), 0);  // it has ended
  EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(time.passed(), seconds{3});
  close(ends[0]);
}

TEST(Child, ClosesAPipeAndLivesOn) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const Stopwatch time;
  const pid_t child = start([&ends] {
    sleep(1);
    close(ends[1]);
    sleep(1);
    return 0;
  });
  close(ends[1]);
  char byte = 0;

  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  EXPECT_EQ(time.passed(), seconds{1});
  EXPECT_EQ(status_of(child), 0);
  close(ends[0]);
}

TEST(Child, ClosesAPipeWhenItBecomesAProgram) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const Stopwatch time;
  const pid_t child = start([] { return execl("/bin/sleep", "sleep", "5", nullptr); });
  close(ends[1]);
  char byte = 0;

  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  EXPECT_EQ(time.passed(), seconds{0});
  EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(time.passed(), seconds{5});
  close(ends[0]);
}

TEST(Child, TakesPartWhateverItsEnvironment) {
  char name[] = "sleep", length[] = "5", own[] = "OWN=1";
  char* const words[] = {name, length, nullptr};
  char* const environment[] = {own, nullptr};
  const Stopwatch time;
  pid_t spawned = -1;
  ASSERT_EQ(posix_spawn(&spawned, "/bin/sleep", nullptr, nullptr, words, environment), 0);
  const pid_t executed = start([&] { return execve("/bin/sleep", words, environment); });

  EXPECT_EQ(status_of(spawned), 0);
  EXPECT_EQ(status_of(executed), 0);
  EXPECT_EQ(time.passed(), seconds{5});
}

TEST(Child, SeesASignalAtTheInstantAtWhichItIsSent) {
  constexpr int kTimes = 100;
  struct sigaction action {};
  action.sa_handler = [](int) {};
  ASSERT_EQ(sigaction(SIGUSR1, &action, nullptr), 0);
  const Stopwatch time;
  const pid_t child = start([&time] {
    for (int i = 1; i <= kTimes; ++i)
      if (sleep(1000) == 0 || time.passed() != milliseconds{i}) return i;
    return 0;
  });
  for (int i = 0; i < kTimes; ++i) {
    sleep_for(milliseconds{1});
    kill(child, SIGUSR1);
  }

  EXPECT_EQ(status_of(child), 0);
}

TEST(Child, IsEndedByASignal) {
  const Stopwatch time;
  const pid_t child = start([] {
    for (;;) sleep(1000);
    return 0;
  });
  sleep(2);
  kill(child, SIGTERM);

  EXPECT_EQ(status_of(child), -1);
  EXPECT_EQ(time.passed(), seconds{2});
}

volatile pid_t forked = -1;

TEST(Child, OfASignalHandlerGoesOnWithItsSleepEnded) {
  struct sigaction action {};
  action.sa_handler = [](int) { forked = fork(); };
  sigaction(SIGALRM, &action, nullptr);
  const Stopwatch time;
  alarm(2);
  const unsigned left = sleep(10);
  if (forked == 0) _exit(left == 8 && sleep(1) == 0 && time.passed() == seconds{3} ? 0 : 1);

  EXPECT_EQ(left, 8u);
  EXPECT_EQ(status_of(forked), 0);
  EXPECT_EQ(time.passed(), seconds{3});
  signal(SIGALRM, SIG_DFL);
}

TEST(Child, OfASignalHandlerMayRunOnTheProcessorsOfItsProgram) {
  struct sigaction action {};
  action.sa_handler = [](int) {
    forked = fork();
    if (forked == 0) execl("/bin/sh", "sh", "-c", "exit $(nproc)", nullptr);
  };
  sigaction(SIGALRM, &action, nullptr);
  alarm(1);
  sleep(10);
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);

  EXPECT_EQ(status_of(forked), CPU_COUNT(&all));
  signal(SIGALRM, SIG_DFL);
}

TEST(Child, MayBeAnotherProgram) {
  const Stopwatch time;
  const pid_t child = start([] { return execlp("sleep", "sleep", "4", nullptr); });
  EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(time.passed(), seconds{4});

  pid_t spawned = -1;
  char name[] = "sleep";
  char length[] = "5";
  char* words[] = {name, length, nullptr};
  ASSERT_EQ(posix_spawnp(&spawned, name, nullptr, nullptr, words, environ), 0);
  EXPECT_EQ(status_of(spawned), 0);
  EXPECT_EQ(time.passed(), seconds{9});
}

TEST(Shell, SleepsByTheBus) {
  const Stopwatch time;
  EXPECT_EQ(std::system("sleep 2; exit 6"), 6 << 8);
  EXPECT_EQ(time.passed(), seconds{2});

  std::FILE* const stream = popen("sleep 3; echo done", "r");
  ASSERT_NE(stream, nullptr);
  char line[16]{};
  EXPECT_NE(std::fgets(line, sizeof line, stream), nullptr);
  EXPECT_EQ(std::string{line}, "done\n");
  EXPECT_EQ(pclose(stream), 0);
  EXPECT_EQ(time.passed(), seconds{5});
}

/// 47 bits and those between frames at 1 Mbit/s, more if bits are stuffed: what a frame without data takes.
constexpr nanoseconds kShortest = microseconds{44};
constexpr nanoseconds kLongest = microseconds{60};

TEST(Frames, TakeTheirTimeOnTheWire) {
  const CanSocket sender, receiver;
  const Stopwatch time;
  ASSERT_EQ(sender.send(frame(0x123)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x123u);
  EXPECT_GE(time.passed(), kShortest);
  EXPECT_LE(time.passed(), kLongest);
}

TEST(Frames, GoToAndFroBetweenProcesses) {
  constexpr int kRounds = 50;
  const CanSocket socket;
  const pid_t child = start([] {
    const CanSocket other;
    for (int i = 0; i < kRounds; ++i) {
      if (other.receive_id() != 0x100) return 1;
      sleep_for(milliseconds{1});
      if (other.send(frame(0x200)) != 0) return 2;
    }
    return 0;
  });
  sleep_for(milliseconds{1});
  nanoseconds first{0};
  for (int i = 0; i < kRounds; ++i) {
    const Stopwatch time;
    ASSERT_EQ(socket.send(frame(0x100)), 0);
    ASSERT_EQ(socket.receive_id(), 0x200u);
    if (i == 0) first = time.passed();
    EXPECT_EQ(time.passed(), first) << i;
    sleep_for(milliseconds{9});
  }

  EXPECT_GE(first, milliseconds{1} + 2 * kShortest);
  EXPECT_LE(first, milliseconds{1} + 2 * kLongest);
  EXPECT_EQ(status_of(child), 0);
}

TEST(Frames, AreStampedByTheClockOfTheBus) {
  const CanSocket sender, receiver;
  ASSERT_EQ(receiver.set(SOL_SOCKET, SO_TIMESTAMPNS, 1), 0);
  sleep_for(milliseconds{5});
  const nanoseconds sent = shown(CLOCK_REALTIME);
  ASSERT_EQ(sender.send(frame(0x1)), 0);
  can_frame received{};
  iovec part{&received, sizeof received};
  char control[128];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  ASSERT_EQ(recvmsg(receiver.fd(), &message, 0), static_cast<ssize_t>(sizeof received));
  timespec stamp{};
  std::memcpy(&stamp, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof stamp);

  const nanoseconds late = seconds{stamp.tv_sec} + nanoseconds{stamp.tv_nsec} - sent;
  EXPECT_GE(late, kShortest);
  EXPECT_LE(late, kLongest);
}

TEST(Descriptors, OfTheLibraryAreNotThePrograms) {
  const pid_t child = start([] {
    close_range(3, ~0U, 0);
    for (int i = 3; i < 1024; ++i) close(i);
    const Stopwatch time;
    sleep(1);
    return time.passed() == seconds{1} ? 0 : 1;
  });

  EXPECT_EQ(status_of(child), 0);
}

}  // namespace
}  // namespace preload_test
