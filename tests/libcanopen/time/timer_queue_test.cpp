#include "libcanopen/base/timer_queue.hpp"

#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using canopen::kNever;
using canopen::TimePoint;
using canopen::TimerQueue;

constexpr TimePoint at(std::chrono::milliseconds time) {
  return TimePoint{time};
}

TEST(TimerQueue, IsEmptyAtFirst) {
  TimerQueue timers{3};

  EXPECT_EQ(timers.earliest(), kNever);
  EXPECT_FALSE(timers.take_due(at(1h)));
}

TEST(TimerQueue, GivesDueTimersInTheOrderOfTheirDeadlines) {
  TimerQueue timers{3};
  timers.arm(0, at(30ms));
  timers.arm(1, at(10ms));
  timers.arm(2, at(20ms));

  EXPECT_EQ(timers.take_due(at(20ms)), 1U);
  EXPECT_EQ(timers.take_due(at(20ms)), 2U);
  EXPECT_EQ(timers.take_due(at(20ms)), std::nullopt);
  EXPECT_EQ(timers.earliest(), at(30ms));
}

TEST(TimerQueue, MovesATimerThatIsArmedAgain) {
  TimerQueue timers{2};
  timers.arm(0, at(10ms));
  timers.arm(1, at(20ms));

  timers.arm(0, at(30ms));
  EXPECT_EQ(timers.earliest(), at(20ms));
  timers.arm(0, at(5ms));
  EXPECT_EQ(timers.earliest(), at(5ms));

  EXPECT_EQ(timers.take_due(at(1s)), 0U);
  EXPECT_EQ(timers.take_due(at(1s)), 1U);
  EXPECT_FALSE(timers.take_due(at(1s)));
}

TEST(TimerQueue, ForgetsCancelledTimers) {
  TimerQueue timers{2};
  timers.arm(0, at(10ms));
  timers.arm(1, at(20ms));

  timers.cancel(0);
  timers.cancel(0);

  EXPECT_FALSE(timers.is_armed(0));
  EXPECT_TRUE(timers.is_armed(1));
  EXPECT_EQ(timers.earliest(), at(20ms));
  timers.clear();
  EXPECT_EQ(timers.earliest(), kNever);
  EXPECT_FALSE(timers.is_armed(1));
}

/// What the heap must agree with: a plain array of deadlines.
class Reference {
 public:
  void arm(std::size_t timer, TimePoint when) { deadlines_[timer] = when; }
  void cancel(std::size_t timer) { deadlines_[timer] = kNever; }
  TimePoint deadline(std::size_t timer) const { return deadlines_[timer]; }
  TimePoint earliest() const { return *std::ranges::min_element(deadlines_); }

  static constexpr std::size_t kTimers = 23;

 private:
  std::array<TimePoint, kTimers> deadlines_ = [] {
    std::array<TimePoint, kTimers> none{};
    none.fill(kNever);
    return none;
  }();
};

TEST(TimerQueue, AgreesWithAPlainArrayOverManyRandomSteps) {
  std::mt19937 random{20251121};
  TimerQueue timers{Reference::kTimers};
  Reference reference;
  TimePoint now{};

  for (int step = 0; step < 20000; ++step) {
    const std::size_t timer = random() % Reference::kTimers;
    const TimePoint when = now + std::chrono::milliseconds{random() % 50};
    switch (random() % 4) {
      case 0:
        timers.cancel(timer);
        reference.cancel(timer);
        break;
      case 1:
        now += std::chrono::milliseconds{random() % 3};
        while (const auto due = timers.take_due(now)) {
          ASSERT_EQ(reference.deadline(*due), reference.earliest());
          ASSERT_LE(reference.deadline(*due), now);
          reference.cancel(*due);
        }
        ASSERT_GT(reference.earliest(), now);
        break;
      default:
        timers.arm(timer, when);
        reference.arm(timer, when);
    }
    ASSERT_EQ(timers.earliest(), reference.earliest()) << "step " << step;
    ASSERT_EQ(timers.is_armed(timer), reference.deadline(timer) != kNever);
  }
}

}  // namespace
