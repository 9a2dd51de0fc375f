#include <cerrno>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

constexpr int kPatience = 5000;  // ms

/// What poll(2) says of @p socket, asked for both directions; waits up to @p patience ms for it to be readable.
int events_of(const CanSocket& socket, int patience) {
  pollfd wanted{socket.fd(), POLLIN, 0};
  poll(&wanted, 1, patience);
  wanted.events = POLLIN | POLLOUT;
  poll(&wanted, 1, 0);
  return wanted.revents;
}

TEST(Readiness, IsToldByPoll) {
  const CanSocket sender, receiver;

  EXPECT_EQ(events_of(receiver, 0), POLLOUT);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  EXPECT_EQ(events_of(receiver, kPatience), POLLIN | POLLOUT);
  EXPECT_EQ(receiver.receive_id(), 0x123u);
  EXPECT_EQ(events_of(receiver, 0), POLLOUT);
}

TEST(Readiness, IsToldBySelect) {
  const CanSocket sender, receiver;
  fd_set set;
  FD_ZERO(&set);
  FD_SET(receiver.fd(), &set);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  timeval patience{.tv_sec = 5, .tv_usec = 0};

  EXPECT_EQ(select(receiver.fd() + 1, &set, nullptr, nullptr, &patience), 1);
  EXPECT_TRUE(FD_ISSET(receiver.fd(), &set));
}

TEST(Readiness, IsToldByEpollOnceAnEdge) {
  const CanSocket sender, receiver;
  const int watcher = epoll_create1(EPOLL_CLOEXEC);
  epoll_event event{.events = EPOLLIN | EPOLLET, .data = {.u32 = 7}};
  ASSERT_EQ(epoll_ctl(watcher, EPOLL_CTL_ADD, receiver.fd(), &event), 0);

  EXPECT_EQ(epoll_wait(watcher, &event, 1, 0), 0);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  EXPECT_EQ(epoll_wait(watcher, &event, 1, kPatience), 1);
  EXPECT_EQ(event.data.u32, 7u);
  EXPECT_EQ(epoll_wait(watcher, &event, 1, 0), 0);
  ASSERT_EQ(sender.send(frame(0x124)), 0);
  EXPECT_EQ(epoll_wait(watcher, &event, 1, kPatience), 1);
  close(watcher);
}

TEST(Readiness, StaysWhileABurstIsSent) {
  const CanSocket sender, receiver;
  for (canid_t i = 0; i < 1000; ++i) {
    pollfd wanted{sender.fd(), POLLOUT, 0};
    ASSERT_EQ(poll(&wanted, 1, 0), 1) << "frame " << i;
    ASSERT_EQ(sender.send(frame(0x123)), 0) << "frame " << i;
  }
}

TEST(Readiness, IsNotWaitedForWithoutBlocking) {
  const CanSocket sender, receiver;
  can_frame received{};
  const auto read_error = [&] { return error_of(read(receiver.fd(), &received, sizeof received)); };

  ASSERT_EQ(fcntl(receiver.fd(), F_SETFL, O_NONBLOCK), 0);
  EXPECT_EQ(read_error(), EAGAIN);
  int off = 0;
  ASSERT_EQ(ioctl(receiver.fd(), FIONBIO, &off), 0);
  ASSERT_EQ(sender.send(frame(0x123)), 0);
  EXPECT_EQ(read_error(), 0);
  int on = 1;
  ASSERT_EQ(ioctl(receiver.fd(), FIONBIO, &on), 0);
  EXPECT_EQ(read_error(), EAGAIN);
}

TEST(Readiness, OfOneThatDoesNotBlockIsEnoughToSend) {
  const CanSocket sender, receiver;
  ASSERT_EQ(fcntl(sender.fd(), F_SETFL, O_NONBLOCK), 0);

  ASSERT_EQ(sender.send(frame(0x123)), 0);

  EXPECT_EQ(receiver.receive_id(), 0x123u);
}

}  // namespace
}  // namespace conformance
