#include <atomic>

#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

/// Takes some processor time.
void compute() {
  std::atomic<int> count{0};
  while (++count < 1'000'000) continue;
}

TEST(BusClock, StandsWhileAProgramComputes) {
  const Stopwatch time;
  compute();

  EXPECT_EQ(time.passed(), nanoseconds{0});
}

TEST(BusClock, IsTheSameForAllClocks) {
  sleep_for(milliseconds{1500});

  EXPECT_EQ(shown(CLOCK_BOOTTIME), shown(CLOCK_MONOTONIC));
  EXPECT_EQ(shown(CLOCK_MONOTONIC_RAW), shown(CLOCK_MONOTONIC));
  EXPECT_EQ(shown(CLOCK_MONOTONIC_COARSE), shown(CLOCK_MONOTONIC));
  EXPECT_EQ(shown(CLOCK_REALTIME_COARSE), shown(CLOCK_REALTIME));
  timeval day{};
  gettimeofday(&day, nullptr);
  EXPECT_EQ(seconds{day.tv_sec} + microseconds{day.tv_usec},
            std::chrono::duration_cast<microseconds>(shown(CLOCK_REALTIME)));
  EXPECT_EQ(seconds{time(nullptr)}, std::chrono::duration_cast<seconds>(shown(CLOCK_REALTIME)));
}

TEST(BusClock, BeganWithTheYear2025) {
  constexpr std::int64_t kBegin = 1'735'689'600;

  EXPECT_GE(shown(CLOCK_REALTIME), seconds{kBegin});
  EXPECT_LT(shown(CLOCK_REALTIME), seconds{kBegin} + std::chrono::hours{24});
}

TEST(BusClock, LeavesProcessorTimeAlone) {
  const nanoseconds before = shown(CLOCK_PROCESS_CPUTIME_ID);
  compute();

  EXPECT_GT(shown(CLOCK_PROCESS_CPUTIME_ID), before);
}

TEST(BusClock, GoesOnForWhomOnlyLooksAtIt) {
  const Stopwatch time;
  while (time.passed() < microseconds{50}) continue;

  EXPECT_LT(time.passed(), milliseconds{1});
}

TEST(Sleep, TakesExactlyTheTimeThatIsAskedFor) {
  const Stopwatch time;
  sleep_for(nanoseconds{1});
  EXPECT_EQ(time.passed(), nanoseconds{1});
  usleep(250);
  EXPECT_EQ(time.passed(), nanoseconds{250'001});
  EXPECT_EQ(sleep(3), 0u);
  EXPECT_EQ(time.passed(), seconds{3} + nanoseconds{250'001});
  const timespec end = instant(milliseconds{10}, CLOCK_REALTIME);
  EXPECT_EQ(clock_nanosleep(CLOCK_REALTIME, TIMER_ABSTIME, &end, nullptr), 0);
  EXPECT_EQ(time.passed(), seconds{3} + milliseconds{10} + nanoseconds{250'001});
}

TEST(Sleep, OfAnHourCostsNothing) {
  const Stopwatch time;
  sleep(3600);

  EXPECT_EQ(time.passed(), std::chrono::hours{1});
}

TEST(Sleep, DoesNotWaitForWhatIsPast) {
  const Stopwatch time;
  const timespec past = instant(-seconds{1});

  EXPECT_EQ(clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &past, nullptr), 0);
  EXPECT_EQ(time.passed(), nanoseconds{0});
}

TEST(Sleep, RefusesWhatIsNoTime) {
  const timespec wrong{.tv_sec = 0, .tv_nsec = 1'000'000'000};

  EXPECT_EQ(clock_nanosleep(CLOCK_MONOTONIC, 0, &wrong, nullptr), EINVAL);
  EXPECT_EQ(nanosleep(&wrong, nullptr), -1);
  EXPECT_EQ(errno, EINVAL);
}

}  // namespace
}  // namespace preload_test
