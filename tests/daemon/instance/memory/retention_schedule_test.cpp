#include "daemon/instance/memory/retention_schedule.hpp"

#include <gtest/gtest.h>

namespace axisd {
namespace {

using namespace std::chrono_literals;

constexpr canopen::TimePoint kStart{1h};

TEST(RetentionSchedule, WritesNothingWhileNothingChanges) {
  EXPECT_EQ(RetentionSchedule{}.due(), canopen::kNever);
}

TEST(RetentionSchedule, WritesAFaultAtOnceButNotMoreThanOnceASecond) {
  RetentionSchedule schedule;
  schedule.on_faults(kStart);
  EXPECT_EQ(schedule.due(), kStart);
  schedule.on_write(true, kStart);
  EXPECT_EQ(schedule.due(), canopen::kNever);

  schedule.on_faults(kStart + 300ms);
  schedule.on_faults(kStart + 600ms);
  EXPECT_EQ(schedule.due(), kStart + 1s);
  schedule.on_write(true, kStart + 1s);
  schedule.on_faults(kStart + 5s);

  EXPECT_EQ(schedule.due(), kStart + 5s);
}

TEST(RetentionSchedule, WritesAMovementEveryMinute) {
  RetentionSchedule schedule;
  schedule.on_motion(kStart);
  schedule.on_motion(kStart + 30s);
  EXPECT_EQ(schedule.due(), kStart + 60s);

  schedule.on_write(true, kStart + 60s);
  EXPECT_EQ(schedule.due(), canopen::kNever);
  schedule.on_motion(kStart + 61s);

  EXPECT_EQ(schedule.due(), kStart + 121s);
}

TEST(RetentionSchedule, PrefersAFault) {
  RetentionSchedule schedule;
  schedule.on_motion(kStart);
  schedule.on_faults(kStart + 10s);

  EXPECT_EQ(schedule.due(), kStart + 10s);
}

TEST(RetentionSchedule, TriesAgainAMinuteAfterAFailure) {
  RetentionSchedule schedule;
  schedule.on_faults(kStart);
  schedule.on_write(false, kStart);
  EXPECT_EQ(schedule.due(), kStart + 60s);

  schedule.on_faults(kStart + 2s);

  EXPECT_EQ(schedule.due(), kStart + 60s);
}

}  // namespace
}  // namespace axisd
