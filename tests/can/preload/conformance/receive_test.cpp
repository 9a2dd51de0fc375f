#include <array>
#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>
#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

/// A sender and a receiver, and room that shows what was written into it.
class Receive : public testing::Test {
 protected:
  static constexpr unsigned char kUntouched = 0xA5;

  Receive() { room_.fill(kUntouched); }

  /// Whether the room is as it was from byte @p from on.
  [[nodiscard]] bool untouched_from(std::size_t from) const {
    for (std::size_t i = from; i < room_.size(); ++i)
      if (room_[i] != kUntouched) return false;
    return true;
  }
  [[nodiscard]] can_frame received() const {
    can_frame copy{};
    std::memcpy(&copy, room_.data(), sizeof copy);
    return copy;
  }
  void send(canid_t id) const { ASSERT_EQ(sender_.send(frame(id, {1, 2, 3})), 0); }

  CanSocket sender_, receiver_;
  std::array<unsigned char, 256> room_{};
};

TEST_F(Receive, GivesOneFrameWhateverTheRoom) {
  send(0x101);
  send(0x102);

  EXPECT_EQ(read(receiver_.fd(), room_.data(), room_.size()), 16);
  EXPECT_EQ(received().can_id, 0x101u);
  EXPECT_TRUE(untouched_from(16));
  EXPECT_EQ(recv(receiver_.fd(), room_.data(), room_.size(), 0), 16);
  EXPECT_EQ(received().can_id, 0x102u);
  EXPECT_TRUE(untouched_from(16));
}

TEST_F(Receive, CutsAFrameToTheRoom) {
  send(0x101);
  send(0x102);

  EXPECT_EQ(read(receiver_.fd(), room_.data(), 10), 10);
  EXPECT_EQ(received().can_id, 0x101u);
  EXPECT_TRUE(untouched_from(10));
  EXPECT_EQ(receiver_.receive_id(), 0x102u);
}

TEST_F(Receive, TellsOnlyWhatItGaveWithTruncFlag) {
  send(0x101);

  EXPECT_EQ(recv(receiver_.fd(), room_.data(), 10, MSG_TRUNC), 10);
}

TEST_F(Receive, OfNothingByReadTakesNothing) {
  send(0x101);

  EXPECT_EQ(read(receiver_.fd(), room_.data(), 0), 0);
  EXPECT_EQ(receiver_.receive_id(), 0x101u);
}

TEST_F(Receive, OfNothingByRecvTakesAFrame) {
  send(0x101);
  send(0x102);

  EXPECT_EQ(recv(receiver_.fd(), room_.data(), 0, 0), 0);
  EXPECT_EQ(receiver_.receive_id(), 0x102u);
}

TEST_F(Receive, LeavesAFrameThatIsPeekedAt) {
  send(0x101);

  EXPECT_EQ(recv(receiver_.fd(), room_.data(), room_.size(), MSG_PEEK), 16);
  EXPECT_EQ(received().can_id, 0x101u);
  EXPECT_EQ(receiver_.receive_id(), 0x101u);
}

TEST_F(Receive, DoesNotWaitIfToldSo) {
  EXPECT_EQ(error_of(recv(receiver_.fd(), room_.data(), room_.size(), MSG_DONTWAIT)), EAGAIN);
  EXPECT_EQ(error_of(recv(receiver_.fd(), room_.data(), room_.size(), MSG_ERRQUEUE)), EAGAIN);
}

TEST_F(Receive, GivesUpAfterItsLimit) {
  const timeval limit{.tv_sec = 0, .tv_usec = 1000};
  ASSERT_EQ(error_of(setsockopt(receiver_.fd(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit)), 0);

  EXPECT_EQ(error_of(read(receiver_.fd(), room_.data(), room_.size())), EAGAIN);
}

TEST_F(Receive, FillsSeveralParts) {
  send(0x101);
  const std::array<iovec, 3> parts{iovec{room_.data(), 4}, iovec{room_.data() + 4, 4},
                                   iovec{room_.data() + 8, 100}};

  EXPECT_EQ(readv(receiver_.fd(), parts.data(), 3), 16);

  EXPECT_EQ(received().can_id, 0x101u);
  EXPECT_EQ(received().data[2], 3);
  EXPECT_TRUE(untouched_from(16));
}

TEST_F(Receive, TellsTheInterface) {
  send(0x101);
  send(0x102);
  ASSERT_EQ(receiver_.bind_to(0), 0);
  sockaddr_can address{};
  socklen_t length = sizeof address;

  EXPECT_EQ(
      recvfrom(receiver_.fd(), room_.data(), room_.size(), 0, reinterpret_cast<sockaddr*>(&address), &length), 16);

  EXPECT_EQ(length, 8u);
  EXPECT_EQ(address.can_family, AF_CAN);
  EXPECT_EQ(address.can_ifindex, interface_index());
  length = 4;
  address = {};
  EXPECT_EQ(
      recvfrom(receiver_.fd(), room_.data(), room_.size(), 0, reinterpret_cast<sockaddr*>(&address), &length), 16);
  EXPECT_EQ(length, 8u);
  EXPECT_EQ(address.can_family, AF_CAN);
  EXPECT_EQ(address.can_ifindex, 0);
}

TEST_F(Receive, TellsByFlagsWhereAFrameIsFrom) {
  ASSERT_EQ(receiver_.set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, 1), 0);
  send(0x101);
  ASSERT_EQ(receiver_.send(frame(0x102)), 0);
  iovec part{room_.data(), room_.size()};
  sockaddr_can address{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_name = &address;
  message.msg_namelen = sizeof address;

  EXPECT_EQ(recvmsg(receiver_.fd(), &message, 0), 16);
  EXPECT_EQ(message.msg_flags, MSG_DONTROUTE);
  EXPECT_EQ(message.msg_namelen, 8u);
  EXPECT_EQ(message.msg_controllen, 0u);
  EXPECT_EQ(address.can_ifindex, interface_index());
  part.iov_len = 8;
  EXPECT_EQ(recvmsg(receiver_.fd(), &message, 0), 8);
  EXPECT_EQ(message.msg_flags, MSG_DONTROUTE | MSG_CONFIRM | MSG_TRUNC);
}

TEST_F(Receive, TakesManyMessages) {
  send(0x101);
  send(0x102);
  std::array<can_frame, 4> frames{};
  std::array<iovec, 4> parts{};
  std::array<mmsghdr, 4> messages{};
  for (std::size_t i = 0; i < messages.size(); ++i) {
    parts[i] = {&frames[i], sizeof frames[i]};
    messages[i].msg_hdr.msg_iov = &parts[i];
    messages[i].msg_hdr.msg_iovlen = 1;
  }

  EXPECT_EQ(recvmmsg(receiver_.fd(), messages.data(), 2, 0, nullptr), 2);
  EXPECT_EQ(frames[1].can_id, 0x102u);
  EXPECT_EQ(messages[1].msg_len, 16u);
  send(0x103);
  EXPECT_EQ(recvmmsg(receiver_.fd(), messages.data(), 4, MSG_WAITFORONE, nullptr), 1);
  EXPECT_EQ(frames[0].can_id, 0x103u);
  EXPECT_EQ(error_of(recvmmsg(receiver_.fd(), messages.data(), 4, MSG_DONTWAIT, nullptr)), EAGAIN);
  timespec limit{.tv_sec = 0, .tv_nsec = 1};
  send(0x104);
  send(0x105);
  EXPECT_EQ(recvmmsg(receiver_.fd(), messages.data(), 2, 0, &limit), 1);
}

TEST_F(Receive, KnowsTheTimeOfTheLastFrame) {
  timeval stamp{};
  timespec fine{};
  EXPECT_EQ(error_of(ioctl(receiver_.fd(), SIOCGSTAMP, &stamp)), ENOENT);
  timespec before{}, after{};
  clock_gettime(CLOCK_REALTIME, &before);
  send(0x101);
  ASSERT_EQ(receiver_.receive_id(), 0x101u);

  ASSERT_EQ(error_of(ioctl(receiver_.fd(), SIOCGSTAMP, &stamp)), 0);
  ASSERT_EQ(error_of(ioctl(receiver_.fd(), SIOCGSTAMPNS, &fine)), 0);

  clock_gettime(CLOCK_REALTIME, &after);
  EXPECT_GE(stamp.tv_sec, before.tv_sec);
  EXPECT_LE(stamp.tv_sec, after.tv_sec);
  EXPECT_LT(stamp.tv_usec, 1'000'000);
  EXPECT_GE(fine.tv_sec, before.tv_sec);
  EXPECT_LE(fine.tv_sec, after.tv_sec);
}

}  // namespace
}  // namespace conformance
