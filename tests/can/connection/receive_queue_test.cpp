#include "can/connection/receive_queue.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fakes/fake_port.hpp"

namespace bus {
namespace {

using namespace std::chrono_literals;

class ReceiveQueueTest : public testing::Test {
 protected:
  /// So many frames arrive, their identifiers counted on from the last ones.
  void arrive(std::size_t frames) {
    for (std::size_t i = 0; i < frames; ++i) port.arrived.push_back({.id = arrived_++});
  }
  /// Identifiers of all frames that are received; the kind of what came instead of a further one.
  std::vector<std::uint32_t> receive_all(Received::Kind& end) {
    std::vector<std::uint32_t> identifiers;
    canopen::Frame frame;
    for (;;) {
      end = queue.receive(frame).kind;
      if (end != Received::Frame) return identifiers;
      identifiers.push_back(frame.id);
    }
  }
  std::vector<std::uint32_t> receive_all() {
    Received::Kind end{};
    auto identifiers = receive_all(end);
    EXPECT_EQ(end, Received::Nothing);
    return identifiers;
  }
  static std::vector<std::uint32_t> count(std::uint32_t first, std::uint32_t end) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = first; i < end; ++i) numbers.push_back(i);
    return numbers;
  }

  fakes::FakePort port;
  ReceiveQueue queue{port};

 private:
  std::uint32_t arrived_ = 0;
};

TEST_F(ReceiveQueueTest, GivesWhatWasReadAheadBeforeWhatWaitsAtThePort) {
  arrive(3);
  queue.read_ahead();
  EXPECT_TRUE(port.arrived.empty());
  EXPECT_EQ(queue.waiting(), 3U);
  arrive(2);

  EXPECT_EQ(receive_all(), count(0, 5));
}

TEST_F(ReceiveQueueTest, TellsTheLinkBehindTheFramesThatCameBeforeItWent) {
  arrive(2);
  queue.read_ahead();
  port.down = true;
  queue.read_ahead();

  Received::Kind end{};
  EXPECT_EQ(receive_all(end), count(0, 2));
  EXPECT_EQ(end, Received::Down);
  EXPECT_TRUE(receive_all().empty());
}

TEST_F(ReceiveQueueTest, LeavesAtThePortWhatItHasNoRoomFor) {
  arrive(ReceiveQueue::kCapacity + 100);
  for (std::size_t i = 0; i <= ReceiveQueue::kCapacity / ReceiveQueue::kMostAtOnce; ++i) queue.read_ahead();

  EXPECT_EQ(queue.waiting(), ReceiveQueue::kCapacity);
  EXPECT_EQ(port.arrived.size(), 100U);
  EXPECT_EQ(receive_all(), count(0, ReceiveQueue::kCapacity + 100));
}

TEST_F(ReceiveQueueTest, TakesABoundedNumberAtOnce) {
  arrive(ReceiveQueue::kMostAtOnce + 1);

  queue.read_ahead();

  EXPECT_EQ(port.arrived.size(), 1U);
}

TEST_F(ReceiveQueueTest, KeepsTheOrderWhereItsRingBeginsAnew) {
  canopen::Frame frame;
  std::uint32_t expected = 0;
  for (std::size_t i = 0; i < 3 * ReceiveQueue::kCapacity / 1000; ++i) {
    arrive(1000);
    queue.read_ahead();
    const bool is_first = i == 0;
    for (int taken = is_first ? 1 : 0; taken < 1000; ++taken) {  // one stays, so that it is never empty
      ASSERT_EQ(queue.receive(frame).kind, Received::Frame);
      ASSERT_EQ(frame.id, expected++);
    }
  }
  EXPECT_EQ(queue.waiting(), 1U);
}

TEST_F(ReceiveQueueTest, ForgetsWhatItIsToldTo) {
  arrive(3);
  queue.read_ahead();

  queue.discard();

  EXPECT_TRUE(receive_all().empty());
}

TEST_F(ReceiveQueueTest, GoesOnAfterARest) {
  arrive(ReceiveQueue::kMostAtOnce);
  queue.read_ahead();
  arrive(2 * ReceiveQueue::kMostAtOnce);
  queue.read_ahead();
  queue.read_ahead();
  EXPECT_EQ(receive_all().size(), 3 * ReceiveQueue::kMostAtOnce);

  queue.rest();
  arrive(3);
  queue.read_ahead();

  EXPECT_EQ(receive_all().size(), 3U);
}

TEST_F(ReceiveQueueTest, TellsWhenFramesHaveComeAtTheLatest) {
  canopen::Frame frame;
  port.arrival = 5s;
  arrive(1);
  queue.read_ahead();
  port.arrival = 7s;
  arrive(1);

  ASSERT_EQ(queue.receive(frame).kind, Received::Frame);
  EXPECT_EQ(queue.frame_arrival(), std::optional<std::chrono::nanoseconds>{5s}) << "read ahead";
  ASSERT_EQ(queue.receive(frame).kind, Received::Frame);
  EXPECT_EQ(queue.frame_arrival(), std::optional<std::chrono::nanoseconds>{7s}) << "from the port";
}

TEST_F(ReceiveQueueTest, CannotTellWhatThePortCannot) {
  canopen::Frame frame;
  arrive(1);
  queue.read_ahead();

  ASSERT_EQ(queue.receive(frame).kind, Received::Frame);
  EXPECT_EQ(queue.frame_arrival(), std::nullopt);
}

}  // namespace
}  // namespace bus
