#include "can/connection/message_limit.hpp"

#include <gtest/gtest.h>

namespace bus {
namespace {

using namespace std::chrono_literals;
using Verdict = MessageLimit::Verdict;

constexpr canopen::TimePoint kStart{1000s};

/// Messages of @p limit that are written of @p count at @p now.
unsigned written(MessageLimit& limit, unsigned count, canopen::TimePoint now) {
  unsigned result = 0;
  for (unsigned i = 0; i < count; ++i)
    if (limit.judge(now) != Verdict::LeaveOut) ++result;
  return result;
}

TEST(MessageLimit, WritesTheFirstOnesAndSaysWhichIsTheLast) {
  MessageLimit limit;

  EXPECT_EQ(written(limit, MessageLimit::kMost - 1, kStart), MessageLimit::kMost - 1);
  EXPECT_EQ(limit.due(), canopen::kNever);
  EXPECT_EQ(limit.judge(kStart), Verdict::WriteLast);
  EXPECT_EQ(limit.judge(kStart), Verdict::LeaveOut);
}

TEST(MessageLimit, WritesOnlySoManyOfAFlood) {
  MessageLimit limit;
  unsigned lines = 0;
  for (auto now = kStart; now < kStart + 60s; now += 10ms) lines += written(limit, 1000, now);

  EXPECT_EQ(lines, 6 * MessageLimit::kMost);
}

TEST(MessageLimit, CountsWhatItLeavesOut) {
  MessageLimit limit;
  written(limit, MessageLimit::kMost + 1234, kStart);

  EXPECT_EQ(limit.due(), kStart + MessageLimit::kPeriod);
  EXPECT_EQ(limit.take_left_out(kStart + MessageLimit::kPeriod - 1ns), 0u);
  EXPECT_EQ(limit.take_left_out(kStart + MessageLimit::kPeriod), 1234u);
  EXPECT_EQ(limit.take_left_out(kStart + MessageLimit::kPeriod), 0u);
  EXPECT_EQ(limit.due(), canopen::kNever);
}

TEST(MessageLimit, WritesAgainInTheNextPeriod) {
  MessageLimit limit;
  written(limit, 10'000, kStart);

  EXPECT_EQ(written(limit, 10'000, kStart + MessageLimit::kPeriod), MessageLimit::kMost);
}

TEST(MessageLimit, LeavesMessagesThatAreRareAlone) {
  MessageLimit limit;
  for (auto now = kStart; now < kStart + 3600s; now += 1100ms) ASSERT_EQ(written(limit, 1, now), 1u);
}

}  // namespace
}  // namespace bus
