#include "farm/agent/plan/process.hpp"

#include <gtest/gtest.h>

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using canopen::TimePoint;

constexpr TimePoint kStart{1h};

TEST(Process, IsStartedAgainAfterPausesThatGrow) {
  Process process;
  TimePoint now = kStart;

  for (const auto pause : {1s, 2s, 4s, 8s, 16s, 30s, 30s}) {
    EXPECT_TRUE(process.may_start(now));
    process.start();
    process.on_ended("ended with status 1", now);
    EXPECT_FALSE(process.may_start(now + pause - 1ms));
    EXPECT_EQ(process.next_start(), now + pause);
    now += pause;
  }
  EXPECT_EQ(process.restarts(), 0u);
  EXPECT_EQ(process.problem(), "ended with status 1; it is started again after 30 s");
}

TEST(Process, ThatHasRunWellBeginsWithTheFirstPause) {
  Process process;
  process.start();
  process.on_ended("ended with status 1", kStart);
  process.start();
  process.on_started(kStart);
  process.on_ended("killed by signal 9", kStart + kGoodRun);

  EXPECT_EQ(process.next_start(), kStart + kGoodRun + kFirstPause);
  EXPECT_EQ(process.restarts(), 1u);
}

TEST(Process, ThatWasStoppedHasNoProblem) {
  Process process;
  process.start();
  process.on_started(kStart);
  process.stop();
  process.on_ended("killed by signal 15", kStart);

  EXPECT_TRUE(process.may_start(kStart));
  EXPECT_EQ(process.problem(), "");
  EXPECT_EQ(process.restarts(), 0u);
}

}  // namespace
}  // namespace farm::agent
