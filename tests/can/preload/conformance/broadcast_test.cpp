#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

/// A message of the broadcast manager with up to four frames.
union Message {
  bcm_msg_head head;
  std::array<char, sizeof(bcm_msg_head) + 4 * sizeof(can_frame)> bytes;
};

bcm_timeval milliseconds(int ms) {
  return {.tv_sec = ms / 1000, .tv_usec = ms % 1000 * 1000};
}

Message message_of(std::uint32_t operation, canid_t id, std::initializer_list<can_frame> frames = {}) {
  Message message{};
  message.head.opcode = operation;
  message.head.can_id = id;
  message.head.nframes = static_cast<std::uint32_t>(frames.size());
  std::copy(frames.begin(), frames.end(), message.head.frames);
  return message;
}

/// A broadcast manager that is connected to the interface.
class Manager : public CanSocket {
 public:
  Manager() : CanSocket{SOCK_DGRAM, CAN_BCM} {
    const sockaddr_can address = address_of(interface_index());
    EXPECT_EQ(connect(fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }

  /// errno of giving it @p message; 0: done.
  [[nodiscard]] int tell(const Message& message) const {
    const std::size_t size = sizeof message.head + message.head.nframes * sizeof(can_frame);
    const ssize_t written = write(fd(), &message, size);
    EXPECT_TRUE(written < 0 || written == static_cast<ssize_t>(size)) << written;
    return error_of(written);
  }
  /// Its next message; an opcode of 0 if none comes.
  [[nodiscard]] Message next() const {
    Message message{};
    const ssize_t size = read(fd(), &message, sizeof message);
    if (size < 0) return {};
    EXPECT_EQ(size, static_cast<ssize_t>(sizeof message.head + message.head.nframes * sizeof(can_frame)));
    return message;
  }
};

TEST(BroadcastManager, SendsAtIntervals) {
  const Manager manager;
  const CanSocket receiver;
  Message setup = message_of(TX_SETUP, 0x123, {frame(0x123, {7})});
  setup.head.flags = SETTIMER | STARTTIMER;
  setup.head.ival2 = milliseconds(5);

  ASSERT_EQ(manager.tell(setup), 0);

  for (int i = 0; i < 3; ++i) {
    const auto received = receiver.receive();
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->can_id, 0x123u);
    EXPECT_EQ(received->data[0], 7);
  }
}

TEST(BroadcastManager, CountsFirstIntervalsAndTellsTheirEnd) {
  const Manager manager;
  const CanSocket receiver;
  Message setup = message_of(TX_SETUP, 0x123, {frame(0x123, {1}), frame(0x123, {2})});
  setup.head.flags = SETTIMER | STARTTIMER | TX_COUNTEVT;
  setup.head.count = 3;
  setup.head.ival1 = milliseconds(2);

  ASSERT_EQ(manager.tell(setup), 0);

  EXPECT_EQ(manager.next().head.opcode, static_cast<std::uint32_t>(TX_EXPIRED));
  for (const int data : {1, 2, 1}) {
    const auto received = receiver.receive();
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->data[0], data);
  }
}

TEST(BroadcastManager, ReadsAndDeletesWhatItSends) {
  const Manager manager;
  Message setup = message_of(TX_SETUP, 0x123, {frame(0x123, {7})});
  setup.head.flags = SETTIMER | STARTTIMER;
  setup.head.ival2 = milliseconds(50);
  ASSERT_EQ(manager.tell(setup), 0);

  ASSERT_EQ(manager.tell(message_of(TX_READ, 0x123)), 0);
  const Message status = manager.next();

  EXPECT_EQ(status.head.opcode, static_cast<std::uint32_t>(TX_STATUS));
  EXPECT_EQ(status.head.ival2.tv_usec, 50'000);
  ASSERT_EQ(status.head.nframes, 1u);
  EXPECT_EQ(status.head.frames[0].data[0], 7);
  EXPECT_EQ(manager.tell(message_of(TX_DELETE, 0x123)), 0);
  EXPECT_EQ(manager.tell(message_of(TX_DELETE, 0x123)), EINVAL);
  EXPECT_EQ(manager.tell(message_of(TX_READ, 0x123)), EINVAL);
}

TEST(BroadcastManager, SendsOneFrameAtOnce) {
  const Manager manager;
  const CanSocket receiver;

  ASSERT_EQ(manager.tell(message_of(TX_SEND, 0, {frame(0x321, {9})})), 0);

  EXPECT_EQ(receiver.receive_id(), 0x321u);
}

TEST(BroadcastManager, TellsWhenContentChanges) {
  const Manager manager;
  const CanSocket sender;
  ASSERT_EQ(manager.tell(message_of(RX_SETUP, 0x123, {frame(0, {0xFF})})), 0);  // the first byte counts

  ASSERT_EQ(sender.send(frame(0x123, {5, 1})), 0);
  ASSERT_EQ(sender.send(frame(0x123, {5, 2})), 0);
  ASSERT_EQ(sender.send(frame(0x123, {6, 3})), 0);

  for (const int first : {5, 6}) {
    const Message change = manager.next();
    EXPECT_EQ(change.head.opcode, static_cast<std::uint32_t>(RX_CHANGED));
    EXPECT_EQ(change.head.can_id, 0x123u);
    ASSERT_EQ(change.head.nframes, 1u);
    EXPECT_EQ(change.head.frames[0].data[0], first);
  }
}

TEST(BroadcastManager, TellsWhenAFrameStaysAway) {
  const Manager manager;
  Message setup = message_of(RX_SETUP, 0x123);
  setup.head.flags = RX_FILTER_ID | SETTIMER | STARTTIMER;
  setup.head.ival1 = milliseconds(5);
  ASSERT_EQ(manager.tell(setup), 0);

  const Message missed = manager.next();

  EXPECT_EQ(missed.head.opcode, static_cast<std::uint32_t>(RX_TIMEOUT));
  EXPECT_EQ(missed.head.can_id, 0x123u);
  EXPECT_EQ(missed.head.nframes, 0u);
}

TEST(BroadcastManager, StopsListening) {
  const Manager manager;
  const CanSocket sender;
  for (const canid_t id : {0x123u, 0x124u}) {
    Message setup = message_of(RX_SETUP, id);
    setup.head.flags = RX_FILTER_ID;
    ASSERT_EQ(manager.tell(setup), 0);
  }

  ASSERT_EQ(manager.tell(message_of(RX_DELETE, 0x123)), 0);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  ASSERT_EQ(sender.send(frame(0x124)), 0);

  EXPECT_EQ(manager.next().head.can_id, 0x124u);
  EXPECT_EQ(manager.tell(message_of(RX_DELETE, 0x123)), EINVAL);
}

TEST(BroadcastManager, TellsTheInterface) {
  const Manager manager;
  const CanSocket sender;
  Message setup = message_of(RX_SETUP, 0x123);
  setup.head.flags = RX_FILTER_ID;
  ASSERT_EQ(manager.tell(setup), 0);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  Message message{};
  sockaddr_can address{};
  socklen_t length = sizeof address;

  EXPECT_EQ(recvfrom(manager.fd(), &message, sizeof message, 0, reinterpret_cast<sockaddr*>(&address), &length),
            static_cast<ssize_t>(sizeof(bcm_msg_head) + sizeof(can_frame)));

  EXPECT_EQ(length, 8u);
  EXPECT_EQ(address.can_family, AF_CAN);
  EXPECT_EQ(address.can_ifindex, interface_index());
}

TEST(BroadcastManager, NeedsToBeConnected) {
  const CanSocket manager{SOCK_DGRAM, CAN_BCM};
  const Message message = message_of(TX_READ, 0x123);

  EXPECT_EQ(error_of(write(manager.fd(), &message, sizeof message.head)), ENOTCONN);
}

TEST(BroadcastManager, RefusesWhatIsNoMessage) {
  const Manager manager;
  const Message message = message_of(TX_SEND, 0x123, {frame(0x123)});

  EXPECT_EQ(error_of(write(manager.fd(), &message, 10)), EINVAL);
  EXPECT_EQ(error_of(write(manager.fd(), &message, sizeof message.head)), EINVAL);
  EXPECT_EQ(manager.tell(message_of(99, 0x123)), EINVAL);
}

}  // namespace
}  // namespace conformance
