// Frames that a queue holds back until it is told to let them go.
#include <vector>

#include <gtest/gtest.h>

#include "can/connection/transmit_queue.hpp"
#include "tests/fakes/fake_port.hpp"

namespace {

using namespace std::chrono_literals;
using bus::SendStatus;
using bus::TransmitQueue;
using canopen::Delivery;
using canopen::Frame;
using canopen::TimePoint;

constexpr TimePoint kNow{1s};

Frame numbered(std::uint32_t id, std::uint8_t value) {
  return {.id = id, .length = 1, .data = {value}};
}

class HeldFrames : public testing::Test {
 protected:
  HeldFrames() {
    port.rule = [this](std::size_t) { return full ? SendStatus::Full : SendStatus::Sent; };
    queue.retry(kNow);
  }
  void ordered(std::uint32_t id, std::uint8_t value) { queue.send(numbered(id, value), Delivery::Ordered); }
  void replaceable(std::uint32_t id, std::uint8_t value) {
    queue.send(numbered(id, value), Delivery::Replaceable);
  }
  void open() {
    full = false;
    queue.retry(kNow + 1ms);
  }

  fakes::FakePort port;
  bool full = true;
  TransmitQueue queue{port, 8, 3};
};

TEST_F(HeldFrames, GoOutInOrderWhenTheyAreReleased) {
  full = false;
  queue.hold();
  ordered(0x581, 1);
  replaceable(0x181, 2);
  replaceable(0x181, 3);
  EXPECT_TRUE(port.sent.empty());

  queue.release();
  ordered(0x582, 4);

  EXPECT_EQ(port.sent,
            (std::vector{numbered(0x581, 1), numbered(0x181, 2), numbered(0x181, 3), numbered(0x582, 4)}));
  EXPECT_EQ(queue.counters(), (TransmitQueue::Counters{.sent = 4}));
  EXPECT_EQ(port.together, std::vector<std::size_t>{3});
}

TEST_F(HeldFrames, GoOutWhenThereAreMoreThanThereIsRoomFor) {
  full = false;
  queue.hold();
  for (std::size_t i = 0; i <= TransmitQueue::kMostHeld; ++i) ordered(0x581, static_cast<std::uint8_t>(i));

  EXPECT_EQ(port.sent.size(), TransmitQueue::kMostHeld) << "the last one is held back again";
  queue.release();
  ASSERT_EQ(port.sent.size(), TransmitQueue::kMostHeld + 1);
  for (std::size_t i = 0; i < port.sent.size(); ++i) EXPECT_EQ(port.sent[i].data[0], i);
}

TEST_F(HeldFrames, WaitFromTheFirstOneOnThatTheBusHasNoRoomFor) {
  port.rule = [](std::size_t call) { return call < 2 ? SendStatus::Sent : SendStatus::Full; };
  queue.hold();
  for (std::uint8_t value = 1; value <= 4; ++value) ordered(0x581, value);

  queue.release();

  EXPECT_EQ(port.sent, (std::vector{numbered(0x581, 1), numbered(0x581, 2)}));
  EXPECT_EQ(queue.waiting(), 2U);
  port.rule = {};
  queue.retry(kNow + 1ms);
  EXPECT_EQ(port.sent.size(), 4U);
  EXPECT_EQ(port.sent.back(), numbered(0x581, 4));
}

TEST_F(HeldFrames, WaitWhereTheBusIsFullWhenTheyAreReleased) {
  queue.hold();
  ordered(0x581, 1);
  ordered(0x582, 2);
  queue.release();
  EXPECT_EQ(queue.waiting(), 2U);

  open();

  EXPECT_EQ(port.sent, (std::vector{numbered(0x581, 1), numbered(0x582, 2)}));
}

}  // namespace
