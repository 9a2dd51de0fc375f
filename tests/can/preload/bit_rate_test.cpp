#include <cerrno>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace preload_test {
namespace {

using conformance::CanSocket;
using conformance::frame;

/// Sends frames of identifier @p id until one is refused; returns how many were not. What refused it is left in
/// @p error.
int fill(const CanSocket& socket, canid_t id, int& error) {
  constexpr int kMost = 1000;
  int sent = 0;
  while (sent < kMost && (error = socket.send(frame(id, {1, 2, 3, 4, 5, 6, 7, 8}))) == 0) ++sent;
  return sent;
}

/// A socket that receives what one test sends, and not what of others may still be under way.
struct Listener : CanSocket {
  Listener(canid_t id, canid_t mask) {
    EXPECT_EQ(set_filters({{.can_id = id, .can_mask = mask}}), 0);
    // what came before the filter was there
    for (can_frame other; recv(fd(), &other, sizeof other, MSG_DONTWAIT) > 0;) continue;
  }
};

TEST(BusWithABitRate, RefusesWhatItsQueueHasNoRoomFor) {
  const CanSocket blocking, other;
  ASSERT_EQ(fcntl(other.fd(), F_SETFL, O_NONBLOCK), 0);

  for (const CanSocket* const socket : {&blocking, &other}) {
    int error = 0;
    const int sent = fill(*socket, 0x101, error);

    EXPECT_EQ(error, ENOBUFS);
    EXPECT_GT(sent, 10);  // what the queue of an interface has
    EXPECT_LT(sent, 200);
  }
}

TEST(BusWithABitRate, HasRoomAgainWhenFramesHaveLeft) {
  const CanSocket sender;
  const Listener receiver{0x120, 0x7F0};
  int error = 0;
  const int sent = fill(sender, 0x123, error);

  for (int i = 0; i < sent; ++i) ASSERT_EQ(receiver.receive_id(), 0x123u);

  pollfd wanted{sender.fd(), POLLOUT, 0};
  EXPECT_EQ(poll(&wanted, 1, 5000), 1);
  EXPECT_EQ(sender.send(frame(0x124)), 0);
  EXPECT_EQ(receiver.receive_id(), 0x124u);
}

TEST(BusWithABitRate, StaysReachableWhileItIsBusy) {
  const CanSocket sender;
  int error = 0;
  fill(sender, 0x131, error);

  EXPECT_EQ(sender.set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, 1), 0);
}

TEST(BusWithABitRate, CarriesWhatAClosedSocketHadSent) {
  const Listener receiver{0x140, 0x7F0};
  int sent = 0;
  {
    const CanSocket sender;
    int error = 0;
    sent = fill(sender, 0x141, error);
  }

  for (int i = 0; i < sent; ++i) EXPECT_EQ(receiver.receive_id(), 0x141u) << i << " of " << sent;
}

}  // namespace
}  // namespace preload_test
