#include <array>
#include <chrono>
#include <cstring>
#include <ctime>

#include <gtest/gtest.h>
#include <linux/errqueue.h>
#include <linux/net_tstamp.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kNanosecondsInSecond = 1'000'000'000;

std::int64_t nanoseconds(const timespec& time) {
  return time.tv_sec * kNanosecondsInSecond + time.tv_nsec;
}

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return nanoseconds(time);
}

/// A message as recvmsg(2) gives it, with the control data.
class Message {
 public:
  /// Receives with @p room bytes for control data.
  explicit Message(const CanSocket& socket, std::size_t room = kRoom) {
    iovec part{&frame_, sizeof frame_};
    header_.msg_iov = &part;
    header_.msg_iovlen = 1;
    header_.msg_control = room == 0 ? nullptr : control_.data();
    header_.msg_controllen = room;
    size_ = recvmsg(socket.fd(), &header_, 0);
  }

  [[nodiscard]] ssize_t size() const { return size_; }
  [[nodiscard]] canid_t id() const { return frame_.can_id; }
  [[nodiscard]] int flags() const { return header_.msg_flags; }
  [[nodiscard]] std::size_t control_size() const { return header_.msg_controllen; }
  /// Number of control messages.
  [[nodiscard]] int count() {
    int count = 0;
    for (cmsghdr* at = CMSG_FIRSTHDR(&header_); at != nullptr; at = CMSG_NXTHDR(&header_, at)) ++count;
    return count;
  }
  /// The data of control message @p type; false if there is none of that size.
  template <class Value>
  bool find(int type, Value& value) {
    for (cmsghdr* at = CMSG_FIRSTHDR(&header_); at != nullptr; at = CMSG_NXTHDR(&header_, at)) {
      if (at->cmsg_level != SOL_SOCKET || at->cmsg_type != type) continue;
      if (at->cmsg_len != CMSG_LEN(sizeof value)) return false;
      std::memcpy(&value, CMSG_DATA(at), sizeof value);
      return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kRoom = 256;

  can_frame frame_{};
  alignas(cmsghdr) std::array<char, kRoom> control_{};
  msghdr header_{};
  ssize_t size_ = -1;
};

/// A receiver with one frame waiting, and when that was sent.
struct Waiting {
  CanSocket receiver, sender;
  std::int64_t before = now();
};

TEST(TimeStamp, IsInMicroseconds) {
  Waiting waiting;
  ASSERT_EQ(waiting.receiver.set(SOL_SOCKET, SO_TIMESTAMP, 1), 0);
  ASSERT_EQ(waiting.sender.send(frame(0x123)), 0);

  Message message{waiting.receiver};

  timeval stamp{};
  ASSERT_TRUE(message.find(SO_TIMESTAMP, stamp));
  const std::int64_t time = stamp.tv_sec * kNanosecondsInSecond + stamp.tv_usec * 1000;
  EXPECT_GE(time, waiting.before - 1000);
  EXPECT_LE(time, now());
  EXPECT_EQ(message.flags(), MSG_DONTROUTE);
  EXPECT_EQ(message.control_size(), CMSG_SPACE(sizeof stamp));
}

TEST(TimeStamp, IsInNanoseconds) {
  Waiting waiting;
  ASSERT_EQ(waiting.receiver.set(SOL_SOCKET, SO_TIMESTAMPNS, 1), 0);
  ASSERT_EQ(waiting.sender.send(frame(0x123)), 0);

  Message message{waiting.receiver};

  timespec stamp{};
  ASSERT_TRUE(message.find(SO_TIMESTAMPNS, stamp));
  EXPECT_GE(nanoseconds(stamp), waiting.before);
  EXPECT_LE(nanoseconds(stamp), now());
}

TEST(TimeStamp, IsOneOfThree) {
  Waiting waiting;
  constexpr int kFlags = SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE | SOF_TIMESTAMPING_RAW_HARDWARE;
  ASSERT_EQ(waiting.receiver.set(SOL_SOCKET, SO_TIMESTAMPING, kFlags), 0);
  EXPECT_EQ(waiting.receiver.get(SOL_SOCKET, SO_TIMESTAMPING), kFlags);

  // A kernel begins to stamp a little after the first socket has asked.
  scm_timestamping stamps{};
  bool found = false;
  for (const auto end = std::chrono::steady_clock::now() + 10s;
       !found && std::chrono::steady_clock::now() < end;) {
    ASSERT_EQ(waiting.sender.send(frame(0x123)), 0);
    found = Message{waiting.receiver}.find(SO_TIMESTAMPING, stamps);
  }

  ASSERT_TRUE(found);
  EXPECT_GE(nanoseconds(stamps.ts[0]), waiting.before);
  EXPECT_LE(nanoseconds(stamps.ts[0]), now());
  EXPECT_EQ(nanoseconds(stamps.ts[2]), 0);
}

TEST(TimeStamp, IsNotThereUnlessAskedFor) {
  Waiting waiting;
  ASSERT_EQ(waiting.sender.send(frame(0x123)), 0);

  Message message{waiting.receiver};

  EXPECT_EQ(message.count(), 0);
  EXPECT_EQ(message.control_size(), 0u);
}

TEST(TimeStamp, IsCutToTheRoom) {
  Waiting waiting;
  ASSERT_EQ(waiting.receiver.set(SOL_SOCKET, SO_TIMESTAMP, 1), 0);
  for (int i = 0; i < 2; ++i) ASSERT_EQ(waiting.sender.send(frame(0x123)), 0);

  const Message none{waiting.receiver, 0};
  const Message little{waiting.receiver, 20};

  EXPECT_EQ(none.size(), 16);
  EXPECT_EQ(none.flags(), MSG_DONTROUTE | MSG_CTRUNC);
  EXPECT_EQ(little.flags(), MSG_DONTROUTE | MSG_CTRUNC);
  EXPECT_EQ(little.control_size(), 20u);
}

TEST(Overflow, IsCounted) {
  constexpr canid_t kLast = 0x7FF, kMarker = 0x7FE;
  constexpr unsigned kSent = 20'000, kMostMarkers = 5;
  const CanSocket receiver, sender, fence;
  ASSERT_EQ(fence.set_filters({{.can_id = kLast, .can_mask = CAN_SFF_MASK}}), 0);
  ASSERT_EQ(receiver.set(SOL_SOCKET, SO_RXQ_OVFL, 1), 0);
  EXPECT_EQ(receiver.get(SOL_SOCKET, SO_RXQ_OVFL), 1);

  for (unsigned i = 1; i < kSent; ++i) ASSERT_EQ(sender.send(frame(i & 0x3FF)), 0);
  ASSERT_EQ(sender.send(frame(kLast)), 0);
  ASSERT_EQ(fence.receive_id(), kLast);
  unsigned received = 0;
  can_frame queued{};
  while (recv(receiver.fd(), &queued, sizeof queued, MSG_DONTWAIT) == sizeof queued) ++received;
  ASSERT_EQ(sender.send(frame(kMarker)), 0);  // for which there is room now
  std::uint32_t dropped = 0;
  unsigned markers = 1;
  for (canid_t id = 0; id != kMarker; ++received) {
    Message message{receiver};
    for (; message.size() != 16 && markers < kMostMarkers; message = Message{receiver}) {
      ASSERT_EQ(sender.send(frame(kMarker)), 0);  // what waited had filled the queue again
      ++markers;
    }
    ASSERT_EQ(message.size(), 16);
    id = message.id();
    if (id == kMarker) {
      ASSERT_TRUE(message.find(SO_RXQ_OVFL, dropped));
    }
  }

  EXPECT_GT(dropped, 0u);
  EXPECT_EQ(received - 1 + dropped, kSent + markers - 1);
}

}  // namespace
}  // namespace conformance
