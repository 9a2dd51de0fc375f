#include <cerrno>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

/// errno of socket(2).
int error_of_socket(int type, int protocol) {
  const int descriptor = ::socket(AF_CAN, type, protocol);
  const int error = error_of(descriptor);
  if (descriptor >= 0) ::close(descriptor);
  return error;
}

TEST(Socket, OfTheWrongTypeIsRefused) {
  EXPECT_EQ(error_of_socket(SOCK_STREAM, CAN_RAW), EPROTOTYPE);
  EXPECT_EQ(error_of_socket(SOCK_DGRAM, CAN_RAW), EPROTOTYPE);
  EXPECT_EQ(error_of_socket(SOCK_RAW, CAN_BCM), EPROTOTYPE);
}

TEST(Socket, OfAProtocolThatIsNoneIsRefused) {
  EXPECT_EQ(error_of_socket(SOCK_RAW, 0), EPROTONOSUPPORT);
  EXPECT_EQ(error_of_socket(SOCK_RAW, CAN_TP16), EPROTONOSUPPORT);
  EXPECT_EQ(error_of_socket(SOCK_RAW, 99), EINVAL);
  EXPECT_EQ(error_of_socket(SOCK_RAW, -1), EINVAL);
}

TEST(Socket, TakesItsFlags) {
  const CanSocket plain{SOCK_RAW, CAN_RAW};
  const CanSocket flagged{SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW};

  EXPECT_EQ(fcntl(plain.fd(), F_GETFD) & FD_CLOEXEC, 0);
  EXPECT_EQ(fcntl(plain.fd(), F_GETFL) & O_NONBLOCK, 0);
  EXPECT_EQ(fcntl(flagged.fd(), F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
  EXPECT_EQ(fcntl(flagged.fd(), F_GETFL) & O_NONBLOCK, O_NONBLOCK);
}

TEST(Socket, TellsWhatItIs) {
  const CanSocket raw{SOCK_RAW, CAN_RAW};
  const CanSocket manager{SOCK_DGRAM, CAN_BCM};

  EXPECT_EQ(raw.get(SOL_SOCKET, SO_DOMAIN), AF_CAN);
  EXPECT_EQ(raw.get(SOL_SOCKET, SO_TYPE), SOCK_RAW);
  EXPECT_EQ(raw.get(SOL_SOCKET, SO_PROTOCOL), 0);  // CAN sockets do not tell
  EXPECT_EQ(raw.get(SOL_SOCKET, SO_ERROR), 0);
  EXPECT_EQ(manager.get(SOL_SOCKET, SO_DOMAIN), AF_CAN);
  EXPECT_EQ(manager.get(SOL_SOCKET, SO_TYPE), SOCK_DGRAM);
}

TEST(Bind, NeedsAnAddressOfAnInterface) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  sockaddr_can address = address_of(interface_index());
  const auto* const any = reinterpret_cast<const sockaddr*>(&address);

  EXPECT_EQ(error_of(bind(socket.fd(), any, 7)), EINVAL);
  address.can_family = AF_INET;
  EXPECT_EQ(error_of(bind(socket.fd(), any, sizeof address)), EINVAL);
  EXPECT_EQ(socket.bind_to(99999), ENODEV);
  EXPECT_EQ(socket.bind_to(interface_index()), 0);
}

TEST(Bind, TakesTheShortAddress) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  const sockaddr_can address = address_of(interface_index());

  EXPECT_EQ(error_of(bind(socket.fd(), reinterpret_cast<const sockaddr*>(&address), 8)), 0);
}

TEST(Bind, IsToldByTheName) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  const auto bound_to = [&socket] {
    sockaddr_can address{};
    socklen_t length = sizeof address;
    EXPECT_EQ(error_of(getsockname(socket.fd(), reinterpret_cast<sockaddr*>(&address), &length)), 0);
    EXPECT_EQ(length, 8u);
    EXPECT_EQ(address.can_family, AF_CAN);
    return address.can_ifindex;
  };

  EXPECT_EQ(bound_to(), 0);
  EXPECT_EQ(socket.bind_to(interface_index()), 0);
  EXPECT_EQ(bound_to(), interface_index());
  EXPECT_EQ(socket.bind_to(0), 0);
  EXPECT_EQ(bound_to(), 0);
}

TEST(Bind, CanBeRepeated) {
  const CanSocket socket, other;

  EXPECT_EQ(socket.bind_to(interface_index()), 0);
  EXPECT_EQ(socket.bind_to(0), 0);
  EXPECT_EQ(other.send(frame(0x123)), 0);

  EXPECT_EQ(socket.receive_id(), 0x123u);
}

TEST(Connect, IsNotForRawSockets) {
  const CanSocket socket;
  const sockaddr_can address = address_of(interface_index());

  EXPECT_EQ(error_of(connect(socket.fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address)),
            EOPNOTSUPP);
}

TEST(Connect, BindsABroadcastManagerOnce) {
  const CanSocket manager{SOCK_DGRAM, CAN_BCM};
  const auto connect_to = [&manager](int index, socklen_t length) {
    const sockaddr_can address = address_of(index);
    return error_of(connect(manager.fd(), reinterpret_cast<const sockaddr*>(&address), length));
  };

  EXPECT_EQ(manager.bind_to(interface_index()), EOPNOTSUPP);
  EXPECT_EQ(connect_to(interface_index(), 7), EINVAL);
  EXPECT_EQ(connect_to(99999, sizeof(sockaddr_can)), ENODEV);
  EXPECT_EQ(connect_to(interface_index(), sizeof(sockaddr_can)), 0);
  EXPECT_EQ(connect_to(interface_index(), sizeof(sockaddr_can)), EISCONN);
}

}  // namespace
}  // namespace conformance
