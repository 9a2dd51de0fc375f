#include "can/clock/time_share.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/can/clock/clock_bus.hpp"

namespace clock_test {
namespace {

using userbus::TimeMode;

/// A program without another one on a bus in virtual time.
class TimeShare : public ::testing::Test {
 protected:
  hub_test::RunningHub hub_{with_time(TimeMode::Virtual)};
  std::unique_ptr<bus::TimeShare> share_ = join(hub_);
};

TEST(TimeShareOf, ABusWithTheTimeOfTheMachineIsNone) {
  const hub_test::RunningHub hub{0};
  EXPECT_EQ(join(hub), nullptr);
}

TEST_F(TimeShare, BeginsAtTheFirstInstant) {
  EXPECT_EQ(age(*share_), 0s);
  EXPECT_EQ(share_->wall().count(), userbus::kFirstWallTime);
  EXPECT_TRUE(share_->stands_while_acting());
}

TEST_F(TimeShare, IsAtTheInstantThatWasWaitedFor) {
  bus::Party& party = share_->add();
  for (const canopen::Duration until : {1ns, 125'000ns, 3'600'000'000'000ns}) {
    EXPECT_FALSE(share_->wait(party, {.descriptors = {}, .until = instant(until)}));
    EXPECT_EQ(age(*share_), until);
  }
  EXPECT_FALSE(share_->wait(party, {.descriptors = {}, .until = instant(1s)}));
  EXPECT_EQ(age(*share_), 1h) << "an instant that has passed";
}

TEST_F(TimeShare, HasItsThreadsActOneAtATimeInTheOrderOfTheirInstants) {
  std::vector<std::pair<int, canopen::Duration>> acted;
  bus::Party& first = share_->add();
  bus::Party& second = share_->add();
  const auto act = [&](bus::Party& party, int name, canopen::Duration period) {
    for (canopen::Duration next = period; next <= 6ms; next += period) {
      share_->wait(party, {.descriptors = {}, .until = instant(next)});
      acted.emplace_back(name, age(*share_));
    }
    share_->remove(party);
  };
  std::thread other{[&] { act(second, 2, 2ms); }};
  act(first, 1, 3ms);
  other.join();

  const std::vector<std::pair<int, canopen::Duration>> expected{{2, 2ms}, {1, 3ms}, {2, 4ms}, {1, 6ms}, {2, 6ms}};
  EXPECT_EQ(acted, expected);
}

TEST_F(TimeShare, LooksForWhatOneThreadHasForAnotherBeforeTimeGoesOn) {
  bus::Party& worker = share_->add();
  bus::Party& listener = share_->add();
  const Bell bell;
  canopen::Duration heard{};
  std::thread other{[&] {
    pollfd wanted = bell.wanted();
    EXPECT_TRUE(share_->wait(listener, {.descriptors = {&wanted, 1}}));
    EXPECT_EQ(wanted.revents, POLLIN);
    heard = age(*share_);
    share_->remove(listener);
  }};
  for (int i = 1; i <= 100; ++i) {
    share_->wait(worker, {.descriptors = {}, .until = instant(i * 1ms)});
    if (i != 70) continue;
    bell.ring();
    share_->note_handed_over();
  }
  share_->remove(worker);
  other.join();

  EXPECT_EQ(heard, 70ms);
}

TEST_F(TimeShare, WaitsForTheMachineWhereAThreadDoes) {
  bus::Party& party = share_->add();
  const canopen::TimePoint soon{os::machine_time(CLOCK_MONOTONIC) + 5ms};

  EXPECT_FALSE(share_->wait(party, {.descriptors = {}, .machine_until = soon}));

  EXPECT_GE(canopen::TimePoint{os::machine_time(CLOCK_MONOTONIC)}, soon);
  EXPECT_EQ(age(*share_), 0s);
}

TEST_F(TimeShare, IsWokenFromOutside) {
  bus::Party& party = share_->add();
  const Bell bell;
  std::thread outside{[&] { bell.ring(); }};
  pollfd wanted = bell.wanted();

  EXPECT_TRUE(share_->wait(party, {.descriptors = {&wanted, 1}}));

  outside.join();
  EXPECT_EQ(age(*share_), 0s);
}

TEST_F(TimeShare, NoticesWhatComesFromOutsideWhileTimeGoesOnAndOn) {
  bus::Party& busy = share_->add();
  bus::Party& listener = share_->add();
  const Bell bell;
  bool is_heard = false;
  std::thread other{[&] {
    pollfd wanted = bell.wanted();
    share_->wait(listener, {.descriptors = {&wanted, 1}});
    is_heard = true;
    share_->remove(listener);
  }};
  std::thread outside{[&] { bell.ring(); }};
  for (canopen::Duration next = 1ms; !is_heard; next += 1ms)
    share_->wait(busy, {.descriptors = {}, .until = instant(next)});
  share_->remove(busy);
  other.join();
  outside.join();
}

TEST_F(TimeShare, LeavesAndGoesOnByTheMachine) {
  bus::Party& party = share_->add();
  share_->wait(party, {.descriptors = {}, .until = instant(10s)});

  share_->leave();

  EXPECT_GE(age(*share_), 10s);
  share_->wait(party, {.descriptors = {}, .until = instant(10s + 5ms)});
  EXPECT_GE(age(*share_), 10s + 5ms);
}

TEST(TimeShareWithoutHub, GoesOnByTheMachine) {
  auto hub = std::make_unique<hub_test::RunningHub>(with_time(TimeMode::Virtual));
  const auto share = join(*hub);
  bus::Party& party = share->add();
  share->wait(party, {.descriptors = {}, .until = instant(10s)});

  hub.reset();
  share->wait(party, {.descriptors = {}, .until = instant(10s + 5ms)});

  EXPECT_GE(age(*share), 10s + 5ms);
}

TEST(TimeShareOfScaledTime, GoesOnByItself) {
  const hub_test::RunningHub hub{with_time(TimeMode::Scaled, 1000)};
  const auto share = join(hub);
  ASSERT_NE(share, nullptr);
  EXPECT_FALSE(share->stands_while_acting());
  bus::Party& party = share->add();
  const canopen::Duration begin = age(*share);

  EXPECT_FALSE(share->wait(party, {.descriptors = {}, .until = instant(begin + 2s)}));

  EXPECT_GE(age(*share), begin + 2s);
}

}  // namespace
}  // namespace clock_test
