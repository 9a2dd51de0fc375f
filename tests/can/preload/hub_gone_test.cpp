#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <linux/can/isotp.h>
#include <poll.h>
#include <sys/epoll.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"
#include "tests/can/preload/hub_process.hpp"

namespace preload_test {
namespace {

using conformance::CanSocket;
using conformance::error_of;
using conformance::frame;

/// errno of reading a frame from @p descriptor without waiting.
int error_of_read(int descriptor) {
  can_frame received{};
  return error_of(recv(descriptor, &received, sizeof received, MSG_DONTWAIT));
}

TEST(HubGone, IsToldOnceThenNothingComes) {
  HubProcess hub;
  const CanSocket socket;
  hub.kill();

  EXPECT_EQ(error_of_read(socket.fd()), ENETDOWN);

  for (int i = 0; i < 3; ++i) EXPECT_EQ(error_of_read(socket.fd()), EAGAIN);
  pollfd wanted{socket.fd(), POLLIN, 0};
  EXPECT_EQ(poll(&wanted, 1, 0), 0);
}

TEST(HubGone, WakesWhoWaits) {
  HubProcess hub;
  const CanSocket socket;
  int error = 0;
  std::thread reader{[&] {
    can_frame received{};
    error = error_of(read(socket.fd(), &received, sizeof received));
  }};

  hub.kill();
  reader.join();

  EXPECT_EQ(error, ENETDOWN);
}

TEST(HubGone, LeavesWhatHadArrived) {
  HubProcess hub;
  const CanSocket sender, receiver, fence;
  ASSERT_EQ(sender.send(frame(0x101)), 0);
  ASSERT_EQ(fence.receive_id(), 0x101u);
  ASSERT_EQ(sender.send(frame(0x102)), 0);  // maybe under way when the hub ends
  hub.kill();

  EXPECT_EQ(receiver.receive_id(), 0x101u);
}

TEST(HubGone, RefusesFramesWithoutASignal) {
  HubProcess hub;
  const CanSocket socket;
  hub.kill();

  for (int i = 0; i < 3; ++i) EXPECT_EQ(socket.send(frame(0x101)), ENETDOWN);
  EXPECT_EQ(error_of_read(socket.fd()), ENETDOWN);
  EXPECT_EQ(socket.send(frame(0x101)), ENETDOWN);
}

TEST(HubGone, IsToldByOptionsAndBind) {
  HubProcess hub;
  const CanSocket socket;
  const int index = conformance::interface_index();
  hub.kill();

  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(socket.set(SOL_CAN_RAW, CAN_RAW_LOOPBACK, 1), ENETDOWN);
    EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_LOOPBACK), -ENETDOWN);
    EXPECT_EQ(socket.bind_to(index), ENETDOWN);
    error_of_read(socket.fd());
  }
}

TEST(HubGone, KeepsFlagsAndTimeLimits) {
  HubProcess hub;
  const CanSocket socket{SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW};
  const CanSocket waiting;
  const timeval limit{.tv_sec = 0, .tv_usec = 1000};
  ASSERT_EQ(setsockopt(waiting.fd(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit), 0);
  hub.kill();
  EXPECT_EQ(error_of_read(socket.fd()), ENETDOWN);
  EXPECT_EQ(error_of_read(waiting.fd()), ENETDOWN);

  EXPECT_EQ(fcntl(socket.fd(), F_GETFD), FD_CLOEXEC);
  EXPECT_EQ(fcntl(socket.fd(), F_GETFL) & O_NONBLOCK, O_NONBLOCK);
  EXPECT_FALSE(waiting.receive());  // returns at all
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_DOMAIN), AF_CAN);
}

TEST(HubGone, LeavesEpollQuiet) {
  HubProcess hub;
  const CanSocket socket;
  const int watcher = epoll_create1(EPOLL_CLOEXEC);
  epoll_event event{.events = EPOLLIN, .data = {.u32 = 7}};
  ASSERT_EQ(epoll_ctl(watcher, EPOLL_CTL_ADD, socket.fd(), &event), 0);
  hub.kill();

  EXPECT_EQ(epoll_wait(watcher, &event, 1, 5000), 1);
  EXPECT_EQ(error_of_read(socket.fd()), ENETDOWN);
  EXPECT_EQ(epoll_wait(watcher, &event, 1, 0), 0);
  close(watcher);
}

TEST(HubGone, IsToldOnEveryDuplicate) {
  HubProcess hub;
  const CanSocket socket;
  const int copy = dup(socket.fd());
  hub.kill();

  EXPECT_EQ(error_of_read(socket.fd()), ENETDOWN);
  EXPECT_EQ(error_of_read(copy), ENETDOWN);
  EXPECT_EQ(error_of_read(copy), EAGAIN);
  close(copy);
}

TEST(HubGone, IsToldToABroadcastManager) {
  HubProcess hub;
  const CanSocket manager{SOCK_DGRAM, CAN_BCM};
  const sockaddr_can address = conformance::address_of(conformance::interface_index());
  ASSERT_EQ(error_of(connect(manager.fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address)), 0);
  const bcm_msg_head request{};
  hub.kill();

  EXPECT_EQ(error_of(write(manager.fd(), &request, sizeof request)), ENETDOWN);
  EXPECT_EQ(error_of_read(manager.fd()), ENETDOWN);
  EXPECT_EQ(error_of_read(manager.fd()), EAGAIN);
}

TEST(HubGone, IsFollowedByTheNext) {
  HubProcess first;
  const CanSocket old;
  first.kill();
  const CanSocket sender, receiver;  // starts a hub

  ASSERT_EQ(sender.send(frame(0x101)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x101u);
  EXPECT_EQ(error_of_read(old.fd()), ENETDOWN);
}

TEST(OtherProtocols, AreNotSupported) {
  const auto error_of_socket = [](int type, int protocol) { return error_of(socket(AF_CAN, type, protocol)); };

  EXPECT_EQ(error_of_socket(SOCK_DGRAM, CAN_ISOTP), EPROTONOSUPPORT);
  EXPECT_EQ(error_of_socket(SOCK_DGRAM, CAN_J1939), EPROTONOSUPPORT);
}

}  // namespace
}  // namespace preload_test
