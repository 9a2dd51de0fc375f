#include "can/port/interface.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "can/port/socketcan/socket_can.hpp"
#include "os/descriptor.hpp"

namespace {

std::string reason_not_to_open(const std::string& interface) {
  try {
    const bus::SocketCan port{interface};
    return "opened";
  } catch (const bus::OpenError& error) {
    return error.what();
  }
}

// The first obstacle counts: a kernel without CAN has no CAN interface either.
std::string expected(const std::string& with_can) {
  const os::Descriptor probe{::socket(AF_CAN, SOCK_RAW, CAN_RAW)};
  return probe ? with_can : "kernel has no CAN (socket(AF_CAN): Address family not supported by protocol)";
}

/// A socket of a kind that every kernel has.
os::Descriptor any_socket() {
  return os::Descriptor{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
}

TEST(CanInterface, ThatDoesNotExistIsNamed) {
  EXPECT_STREQ(bus::can_interface_index("nocan99", any_socket()).error().what(), "nocan99: no such CAN interface");
}

TEST(CanInterface, ThatIsNoCanIsNamed) {
  EXPECT_STREQ(bus::can_interface_index("lo", any_socket()).error().what(), "lo: not a CAN interface");
}

TEST(CanInterface, WithANameNoInterfaceCanHaveDoesNotExist) {
  const std::string too_long(16, 'x');

  EXPECT_EQ(bus::can_interface_index(too_long, any_socket()).error().what(), too_long + ": no such CAN interface");
  EXPECT_STREQ(bus::can_interface_index("", any_socket()).error().what(), ": no such CAN interface");
}

TEST(SocketCan, SaysWhyItCannotOpen) {
  EXPECT_EQ(reason_not_to_open("nocan99"), expected("nocan99: no such CAN interface"));
  EXPECT_EQ(reason_not_to_open("lo"), expected("lo: not a CAN interface"));
}

TEST(LinkState, OfAnAbsentInterfaceIsGone) {
  EXPECT_EQ(bus::query("nocan99"), bus::LinkState::Gone);
}

TEST(LinkState, OfThePresentLoopbackIsNotGone) {
  EXPECT_NE(bus::query("lo"), bus::LinkState::Gone);
}

}  // namespace
