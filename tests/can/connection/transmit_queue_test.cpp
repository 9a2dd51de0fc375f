#include "can/connection/transmit_queue.hpp"

#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/fake_port.hpp"

namespace {

using namespace std::chrono_literals;
using bus::SendStatus;
using bus::TransmitQueue;
using canopen::Delivery;
using canopen::Frame;
using canopen::TimePoint;

constexpr TimePoint kStart{1s};

Frame frame(std::uint32_t id, std::uint8_t value) {
  return {.id = id, .length = 1, .data = {value}};
}

struct Fixture : testing::Test {
  fakes::FakePort port;
  bool full = true;
  TransmitQueue queue{port, 8, 3};

  Fixture() {
    port.rule = [this](std::size_t) { return full ? SendStatus::Full : SendStatus::Sent; };
    queue.retry(kStart);
  }
  void ordered(std::uint32_t id, std::uint8_t value) { queue.send(frame(id, value), Delivery::Ordered); }
  void replaceable(std::uint32_t id, std::uint8_t value) { queue.send(frame(id, value), Delivery::Replaceable); }
  void open() {
    full = false;
    queue.retry(kStart + 1ms);
  }
};
using TransmitQueueTest = Fixture;

TEST_F(TransmitQueueTest, WritesAtOnceWhileTheBusTakesFrames) {
  full = false;

  ordered(0x581, 1);
  replaceable(0x181, 2);

  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 1), frame(0x181, 2)}));
  EXPECT_EQ(queue.next_retry(), canopen::kNever);
  EXPECT_EQ(queue.counters(), (TransmitQueue::Counters{.sent = 2}));
}

TEST_F(TransmitQueueTest, SendsWhatWaitedInOrderOnceThereIsRoom) {
  ordered(0x581, 1);
  replaceable(0x181, 2);
  ordered(0x081, 3);

  open();

  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 1), frame(0x181, 2), frame(0x081, 3)}));
  EXPECT_EQ(queue.waiting(), 0u);
  EXPECT_EQ(queue.counters(), (TransmitQueue::Counters{.sent = 3, .queued = 3, .refused = 1}));
}

TEST_F(TransmitQueueTest, DoesNotLetAFrameOvertakeThoseThatWait) {
  ordered(0x581, 1);
  full = false;

  ordered(0x081, 2);

  EXPECT_TRUE(port.sent.empty());
  queue.retry(kStart + 250us);
  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 1), frame(0x081, 2)}));
}

TEST_F(TransmitQueueTest, AsksAgainOneFrameTimeAfterARefusalAndNotEarlier) {
  ordered(0x581, 1);
  ASSERT_EQ(port.calls, 1u);
  EXPECT_EQ(queue.next_retry(), kStart + 250us);

  queue.retry(kStart + 249us);
  EXPECT_EQ(port.calls, 1u);

  queue.retry(kStart + 250us);
  EXPECT_EQ(port.calls, 2u);
  EXPECT_EQ(queue.next_retry(), kStart + 500us);
}

TEST_F(TransmitQueueTest, AsksTheBusOnceHoweverManyFramesAreHandedOver) {
  for (std::uint8_t i = 0; i < 8; ++i) ordered(0x581, i);

  EXPECT_EQ(port.calls, 1u);
}

TEST_F(TransmitQueueTest, PutsANewerTpdoInThePlaceOfTheWaitingOne) {
  replaceable(0x181, 1);
  ordered(0x581, 2);
  replaceable(0x181, 3);

  open();

  EXPECT_EQ(port.sent, (std::vector{frame(0x181, 3), frame(0x581, 2)}));
  EXPECT_EQ(queue.counters().replaced, 1u);
}

TEST_F(TransmitQueueTest, DoesNotReplaceAcrossAnOrderedFrameOfTheSameIdentifier) {
  replaceable(0x701, 1);
  ordered(0x701, 2);
  replaceable(0x701, 3);
  replaceable(0x701, 4);

  open();

  EXPECT_EQ(port.sent, (std::vector{frame(0x701, 1), frame(0x701, 2), frame(0x701, 4)}));
}

TEST_F(TransmitQueueTest, NeverReplacesAnOrderedFrame) {
  ordered(0x581, 1);
  ordered(0x581, 2);

  open();

  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 1), frame(0x581, 2)}));
}

TEST_F(TransmitQueueTest, TellsRemoteAndExtendedFramesOfTheSameNumberApart) {
  Frame remote = frame(0x181, 0);
  remote.remote = true;
  Frame extended = frame(0x181, 0);
  extended.extended = true;
  replaceable(0x181, 1);
  queue.send(remote, Delivery::Replaceable);
  queue.send(extended, Delivery::Replaceable);

  open();

  EXPECT_EQ(port.sent, (std::vector{frame(0x181, 1), remote, extended}));
}

TEST_F(TransmitQueueTest, AcceptsNoInputWhileLessThanTheMarginIsLeft) {
  for (std::uint8_t i = 0; i < 5; ++i) ordered(0x581, i);
  EXPECT_TRUE(queue.accepts_input());
  ordered(0x581, 5);
  EXPECT_FALSE(queue.accepts_input());

  open();

  EXPECT_TRUE(queue.accepts_input());
}

TEST_F(TransmitQueueTest, GivesUpTheOldestTpdoWhenAnOrderedFrameFindsNoPlace) {
  ordered(0x581, 0);
  replaceable(0x181, 1);
  replaceable(0x281, 2);
  for (std::uint8_t i = 3; i < 8; ++i) ordered(0x581, i);

  ordered(0x081, 8);
  open();

  const std::vector expected{frame(0x581, 0), frame(0x281, 2), frame(0x581, 3), frame(0x581, 4),
                             frame(0x581, 5), frame(0x581, 6), frame(0x581, 7), frame(0x081, 8)};
  EXPECT_EQ(port.sent, expected);
  EXPECT_EQ(queue.counters().dropped, 1u);
}

TEST_F(TransmitQueueTest, CountsAFrameThatFindsOnlyOrderedOnesAsDropped) {
  for (std::uint8_t i = 0; i < 8; ++i) ordered(0x581, i);

  ordered(0x581, 8);
  replaceable(0x181, 9);

  EXPECT_EQ(queue.waiting(), 8u);
  EXPECT_EQ(queue.counters().dropped, 2u);
}

TEST_F(TransmitQueueTest, DropsAndCountsWhileTheLinkIsDown) {
  port.rule = [](std::size_t) { return SendStatus::Down; };

  ordered(0x581, 1);
  replaceable(0x181, 2);

  EXPECT_EQ(queue.waiting(), 0u);
  EXPECT_EQ(queue.next_retry(), canopen::kNever);
  EXPECT_EQ(queue.counters(), (TransmitQueue::Counters{.dropped = 2}));
}

TEST_F(TransmitQueueTest, DropsWhatWaitsWhenTheLinkGoesDownMeanwhile) {
  ordered(0x581, 1);
  ordered(0x581, 2);
  port.rule = [](std::size_t) { return SendStatus::Down; };

  queue.retry(kStart + 1ms);

  EXPECT_EQ(queue.waiting(), 0u);
  EXPECT_EQ(queue.counters().dropped, 2u);
}

TEST_F(TransmitQueueTest, SendsAgainAfterTheLinkCameBack) {
  port.rule = [](std::size_t call) { return call == 0 ? SendStatus::Down : SendStatus::Sent; };

  ordered(0x581, 1);
  ordered(0x581, 2);

  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 2)}));
}

TEST_F(TransmitQueueTest, ForgetsWhatWaitsWhenTold) {
  ordered(0x581, 1);
  replaceable(0x181, 2);

  queue.discard();
  open();

  EXPECT_TRUE(port.sent.empty());
  EXPECT_EQ(queue.counters().dropped, 2u);
}

TEST_F(TransmitQueueTest, GoesOnBehindAFrameThatFailsForGood) {
  ordered(0x581, 1);
  ordered(0x581, 2);
  port.rule = [](std::size_t call) { return call == 1 ? SendStatus::Failed : SendStatus::Sent; };

  queue.retry(kStart + 1ms);

  EXPECT_EQ(port.sent, (std::vector{frame(0x581, 2)}));
  EXPECT_EQ(queue.counters().dropped, 1u);
}

// Frames as an SDO block, an EMCY and heartbeats make them: every one ordered.
std::vector<Frame> burst() {
  std::vector<Frame> frames;
  for (std::uint8_t i = 0; i < 20; ++i) frames.push_back(frame(i % 3 == 0 ? 0x081u : 0x581u, i));
  return frames;
}

TEST(TransmitQueue, KeepsTheOrderWhicheverCallIsRefused) {
  for (std::size_t refused = 0; refused < 20; ++refused)
    for (std::size_t times = 1; times <= 3; ++times) {
      fakes::FakePort port;
      port.rule = [=](std::size_t call) {
        return call >= refused && call < refused + times ? SendStatus::Full : SendStatus::Sent;
      };
      TransmitQueue queue{port, 32, 4};
      queue.retry(kStart);

      for (const Frame& f : burst()) queue.send(f, Delivery::Ordered);
      while (queue.next_retry() != canopen::kNever) queue.retry(queue.next_retry());

      EXPECT_EQ(port.sent, burst()) << "refused from call " << refused << ", " << times << " times";
      EXPECT_EQ(queue.counters().dropped, 0u);
    }
}

TEST(TransmitQueue, LosesNoOrderedFrameAndNoNewestValueUnderRandomRefusals) {
  std::mt19937 random{402};
  fakes::FakePort port;
  port.rule = [&](std::size_t) { return random() % 3 != 0 ? SendStatus::Full : SendStatus::Sent; };
  TransmitQueue queue{port, 64, 16};
  TimePoint now = kStart;
  std::vector<Frame> ordered;
  std::map<std::uint32_t, Frame> newest;

  for (std::uint32_t i = 0; i < 20'000; ++i) {
    queue.retry(now += 100us);
    Frame f{.id = 0x581, .length = 4};
    for (std::size_t b = 0; b < 4; ++b) f.data[b] = static_cast<std::uint8_t>(i >> (8 * b));
    const bool is_answer = queue.accepts_input() && random() % 4 == 0;
    if (!is_answer) f.id = 0x181 + random() % 8;
    queue.send(f, is_answer ? Delivery::Ordered : Delivery::Replaceable);
    if (is_answer) {
      ordered.push_back(f);
    } else {
      newest[f.id] = f;
    }
  }
  while (queue.next_retry() != canopen::kNever) queue.retry(queue.next_retry());

  std::vector<Frame> answers;
  std::map<std::uint32_t, Frame> last;
  const auto serial = [](const Frame& f) { return f.data[0] | f.data[1] << 8 | f.data[2] << 16; };
  for (const Frame& f : port.sent) {
    if (f.id == 0x581) answers.push_back(f);
    if (last.contains(f.id)) {
      EXPECT_LT(serial(last[f.id]), serial(f));
    }
    last[f.id] = f;
  }
  last.erase(0x581);
  EXPECT_EQ(answers, ordered);
  EXPECT_EQ(last, newest);
  EXPECT_EQ(queue.counters().dropped, 0u);
  EXPECT_GT(queue.counters().replaced, 0u);
}

}  // namespace
