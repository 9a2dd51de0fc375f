#include <array>
#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

int send_to(const CanSocket& socket, const can_frame& sent, const sockaddr_can& address,
            socklen_t length = sizeof(sockaddr_can)) {
  return error_of(sendto(socket.fd(), &sent, sizeof sent, 0, reinterpret_cast<const sockaddr*>(&address), length));
}

TEST(Send, WorksByEveryCall) {
  const CanSocket sender, receiver;
  std::array<can_frame, 6> frames{};
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = frame(0x100 + static_cast<canid_t>(i), {1, 2});
  const std::array<iovec, 2> parts{iovec{&frames[2], 5},
                                   iovec{reinterpret_cast<char*>(&frames[2]) + 5, sizeof(can_frame) - 5}};
  iovec fourth{&frames[3], sizeof(can_frame)}, fifth{&frames[4], sizeof(can_frame)},
      sixth{&frames[5], sizeof(can_frame)};
  std::array<mmsghdr, 2> many{};
  many[0].msg_hdr = {nullptr, 0, &fifth, 1, nullptr, 0, 0};
  many[1].msg_hdr = {nullptr, 0, &sixth, 1, nullptr, 0, 0};
  const msghdr one{nullptr, 0, &fourth, 1, nullptr, 0, 0};

  EXPECT_EQ(write(sender.fd(), &frames[0], sizeof(can_frame)), 16);
  EXPECT_EQ(send(sender.fd(), &frames[1], sizeof(can_frame), 0), 16);
  EXPECT_EQ(writev(sender.fd(), parts.data(), 2), 16);
  EXPECT_EQ(sendmsg(sender.fd(), &one, 0), 16);
  EXPECT_EQ(sendmmsg(sender.fd(), many.data(), 2, 0), 2);
  EXPECT_EQ(many[1].msg_len, 16u);

  for (const can_frame& sent : frames) {
    const auto received = receiver.receive();
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(std::memcmp(&*received, &sent, sizeof sent), 0);
  }
}

TEST(Send, NeedsAFrameOfItsSize) {
  const CanSocket socket;
  const std::array<char, 128> data{};

  for (const std::size_t size : {0u, 1u, 15u, 17u, 72u, 128u}) {
    EXPECT_EQ(error_of(send(socket.fd(), data.data(), size, 0)), EINVAL) << size;
    EXPECT_EQ(error_of(write(socket.fd(), data.data(), size)), EINVAL) << size;
  }
}

TEST(Send, RefusesALengthOver8) {
  const CanSocket socket;
  can_frame wrong = frame(0x123);
  wrong.can_dlc = 9;

  EXPECT_EQ(socket.send(wrong), EINVAL);
}

TEST(Send, NeedsAnInterface) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  EXPECT_EQ(socket.send(frame(0x123)), ENXIO);
  ASSERT_EQ(socket.bind_to(0), 0);
  EXPECT_EQ(socket.send(frame(0x123)), ENXIO);
  EXPECT_EQ(send_to(socket, frame(0x123), address_of(0)), ENXIO);
  EXPECT_EQ(send_to(socket, frame(0x123), address_of(99999)), ENXIO);
}

TEST(Send, GoesToTheAddressGiven) {
  const CanSocket unbound{SOCK_RAW, CAN_RAW};
  const CanSocket all{SOCK_RAW, CAN_RAW};
  const CanSocket receiver;
  ASSERT_EQ(all.bind_to(0), 0);

  EXPECT_EQ(send_to(unbound, frame(0x101), address_of(interface_index())), 0);
  EXPECT_EQ(send_to(all, frame(0x102), address_of(interface_index()), 8), 0);

  EXPECT_EQ(receiver.receive_id(), 0x101u);
  EXPECT_EQ(receiver.receive_id(), 0x102u);
}

TEST(Send, RefusesAnAddressThatIsNone) {
  const CanSocket socket;
  sockaddr_can address = address_of(interface_index());

  EXPECT_EQ(send_to(socket, frame(0x123), address, 7), EINVAL);
  address.can_family = AF_INET;
  EXPECT_EQ(send_to(socket, frame(0x123), address), EINVAL);
}

TEST(Send, RefusesBeforeItSends) {
  const CanSocket sender, receiver;
  can_frame wrong = frame(0x123);
  wrong.can_dlc = 9;
  EXPECT_EQ(sender.send(wrong), EINVAL);

  EXPECT_EQ(sender.send(frame(0x124)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x124u);
}

TEST(Send, DoesNotWaitForWhoDoesNotRead) {
  const CanSocket sender, deaf, receiver;
  ASSERT_EQ(receiver.set_filters({{.can_id = 0x7FF, .can_mask = CAN_SFF_MASK}}), 0);

  for (int i = 0; i < 10'000; ++i) ASSERT_EQ(sender.send(frame(0x123)), 0);
  ASSERT_EQ(sender.send(frame(0x7FF)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x7FFu);
}

}  // namespace
}  // namespace conformance
