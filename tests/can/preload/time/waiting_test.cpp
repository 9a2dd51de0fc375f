#include <atomic>
#include <semaphore>
#include <thread>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

/// A pipe that nobody writes to unless the test does.
struct Pipe {
  Pipe() { EXPECT_EQ(pipe(ends), 0); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(ends[0]);
    close(ends[1]);
  }
  int ends[2]{};
};

TEST(Poll, WaitsAsLongAsItIsAskedTo) {
  const Pipe pipe;
  pollfd wanted{pipe.ends[0], POLLIN, 0};
  const Stopwatch time;

  EXPECT_EQ(poll(&wanted, 1, 1500), 0);
  EXPECT_EQ(time.passed(), milliseconds{1500});
  const timespec limit = timespec_of(microseconds{300});
  EXPECT_EQ(ppoll(&wanted, 1, &limit, nullptr), 0);
  EXPECT_EQ(time.passed(), microseconds{1'500'300});
  EXPECT_EQ(poll(&wanted, 1, 0), 0);
  EXPECT_EQ(time.passed(), microseconds{1'500'300});
}

TEST(Poll, InALoopLetsAnotherThreadDoItsWork) {
  const int always = eventfd(1, 0);
  std::binary_semaphore begins{0};
  std::atomic<bool> is_done = false;
  std::thread worker{[&] {
    begins.acquire();
    is_done = true;
  }};
  const Stopwatch time;
  begins.release();
  int polls = 0;
  for (pollfd wanted{always, POLLIN, 0}; !is_done && polls < 1'000'000; ++polls) poll(&wanted, 1, 0);

  EXPECT_LT(polls, 100) << "it goes on as the loop does, not when that has computed for long";
  EXPECT_EQ(time.passed(), milliseconds{0});
  worker.join();
  close(always);
}

TEST(Poll, InALoopGoesOnBesideAThreadThatSpins) {
  constexpr int kPolls = 100;
  const int always = eventfd(1, 0);
  std::binary_semaphore begins{0};
  std::atomic<bool> is_done = false;
  std::thread spinner{[&] {
    begins.acquire();
    while (!is_done) {
    }
  }};
  begins.release();
  int ready = 0;
  for (int i = 0; i < kPolls; ++i) {
    pollfd wanted{always, POLLIN, 0};
    ready += poll(&wanted, 1, 0);
  }
  is_done = true;

  EXPECT_EQ(ready, kPolls);
  spinner.join();
  close(always);
}

TEST(Select, LeavesWhatIsLeftOfItsTime) {
  const Pipe pipe;
  std::thread writer{[&pipe] {
    sleep_for(seconds{1});
    EXPECT_EQ(write(pipe.ends[1], "x", 1), 1);
  }};
  fd_set wanted;
  FD_ZERO(&wanted);
  FD_SET(pipe.ends[0], &wanted);
  timeval limit{.tv_sec = 5, .tv_usec = 0};

  EXPECT_EQ(select(pipe.ends[0] + 1, &wanted, nullptr, nullptr, &limit), 1);
  EXPECT_TRUE(FD_ISSET(pipe.ends[0], &wanted));
  EXPECT_EQ(limit.tv_sec, 4);
  EXPECT_EQ(limit.tv_usec, 0);
  writer.join();
}

TEST(Read, OfAPipeWaitsForAnotherThread) {
  const Pipe pipe;
  const Stopwatch time;
  std::thread writer{[&pipe] {
    sleep_for(milliseconds{20});
    EXPECT_EQ(write(pipe.ends[1], "x", 1), 1);
  }};
  char byte = 0;

  EXPECT_EQ(read(pipe.ends[0], &byte, 1), 1);
  EXPECT_EQ(time.passed(), milliseconds{20});
  writer.join();
}

TEST(Read, OfASocketHasALimitOfTime) {
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  const timeval limit{.tv_sec = 2, .tv_usec = 500'000};
  ASSERT_EQ(setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit), 0);
  const Stopwatch time;
  char byte = 0;

  EXPECT_EQ(recv(ends[0], &byte, 1, 0), -1);
  EXPECT_EQ(errno, EAGAIN);
  EXPECT_EQ(time.passed(), milliseconds{2500});
  close(ends[0]);
  close(ends[1]);
}

TEST(Write, OfMoreThanAPipeTakesWaitsForItsReader) {
  const Pipe pipe;
  const std::string text(300'000, 'x');
  std::size_t got = 0;
  std::thread reader{[&] {
    std::string part(7'000, ' ');
    while (got < text.size()) {
      sleep_for(milliseconds{1});
      const ssize_t size = read(pipe.ends[0], part.data(), part.size());
      ASSERT_GT(size, 0);
      got += static_cast<std::size_t>(size);
    }
  }};

  EXPECT_EQ(write(pipe.ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  reader.join();
  EXPECT_EQ(got, text.size());
}

}  // namespace
}  // namespace preload_test
