#include "os/timer.hpp"

#include <chrono>

#include <gtest/gtest.h>
#include <poll.h>

#include "os/clock.hpp"

namespace os {
namespace {

using namespace std::chrono_literals;

/// Waits until @p timer has rung.
void wait_for(const Timer& timer) {
  pollfd wanted{timer.descriptor(), POLLIN, 0};
  ASSERT_EQ(::poll(&wanted, 1, -1), 1);
}

bool is_readable(const Timer& timer) {
  pollfd wanted{timer.descriptor(), POLLIN, 0};
  return ::poll(&wanted, 1, 0) == 1;
}

TEST(Timer, DoesNotRingBeforeItIsSet) {
  Timer timer;
  EXPECT_FALSE(is_readable(timer));
  EXPECT_FALSE(timer.take());
}

TEST(Timer, RingsNotBeforeItsTime) {
  Timer timer;
  const std::chrono::nanoseconds when = monotonic_time() + 2ms;
  timer.ring_at(when);
  wait_for(timer);
  EXPECT_GE(monotonic_time(), when);
}

TEST(Timer, RingsAtOnceForATimeThatHasPassedBeTheZeroOfTheClock) {
  Timer timer;
  timer.ring_at(0ns);
  wait_for(timer);
}

TEST(Timer, RingsAfterAWhile) {
  Timer timer;
  const std::chrono::nanoseconds before = monotonic_time();
  timer.ring_after(2ms);
  wait_for(timer);
  EXPECT_GE(monotonic_time() - before, 2ms);
}

TEST(Timer, TellsOnceThatItHasRung) {
  Timer timer;
  timer.ring_at(0ns);
  wait_for(timer);
  EXPECT_TRUE(timer.take());
  EXPECT_FALSE(timer.take());
}

TEST(Timer, TakesBackWhatHasRungWhenItIsSetAnewOrStopped) {
  Timer timer;
  timer.ring_at(0ns);
  wait_for(timer);
  timer.ring_after(1h);
  EXPECT_FALSE(is_readable(timer));
  timer.ring_at(0ns);
  wait_for(timer);
  timer.stop();
  EXPECT_FALSE(is_readable(timer));
}

}  // namespace
}  // namespace os
