#include "can/port/multicast/udp_multicast.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "can/connection/connection.hpp"
#include "can/port/multicast/multicast_message.hpp"
#include "can/port/wire.hpp"
#include "tests/can/port/multicast/own_network.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/support/network.hpp"

namespace bus {
namespace {

const auto* const kOwnNetwork =
    testing::AddGlobalTestEnvironment(new network::OwnNetwork);  // GoogleTest deletes it

const MulticastGroup kOnLoopback{"239.74.163.2", 43113, "lo"};
const MulticastGroup kSixOnLoopback{"ff15:7079:7468:6f6e:6465:6d6f:6d63:6173", 43113, "lo"};

/// What @p port receives next, as candump prints it; "" if nothing comes.
std::string next(Port& port) {
  canopen::Frame frame;
  while (network::readable(port.descriptor())) {
    const Received received = port.receive(frame);
    if (received.kind == Received::Frame) return fakes::candump(frame);
    if (received.kind == Received::Error) return std::string{name_of(received.state)};
  }
  return "";
}

/// Sends @p frame, which must go out.
void send(Port& port, const char* frame) {
  ASSERT_EQ(port.send(fakes::frame_of(frame)), SendStatus::Sent) << frame;
}

/// Sends bytes to the group as a program of another kind would.
void send_bytes(const std::vector<std::uint8_t>& bytes) {
  const auto sockets = multicast::open_sockets(kOnLoopback, "lo", 1 << 16);
  ASSERT_EQ(::send(sockets.sender.get(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
}

/// The message of the OpenError that opening @p text throws.
std::string reason_not_to_open(const char* text) {
  try {
    const Connection connection = open(parse_address(text).value());
    return "opened";
  } catch (const OpenError& error) {
    return error.what();
  }
}

class UdpMulticastOn : public testing::TestWithParam<MulticastGroup> {
 protected:
  void SetUp() override {
    // The kernel makes no route on lo for IPv6 groups by itself, and takes only local ones.
    if (GetParam() == kSixOnLoopback) network::ip("-6 route replace local ff15::/16 dev lo");
  }
};

TEST_P(UdpMulticastOn, CarriesEveryKindOfFrameInOrder) {
  UdpMulticast master{GetParam()};
  UdpMulticast drive{GetParam()};
  const std::array frames{"605#4000100000000000", "000#0105", "705#R", "18DA00F1#01", "1FFFFFFF#R8", "080#"};

  for (const char* const frame : frames) send(master, frame);

  for (const char* const frame : frames) EXPECT_EQ(next(drive), frame);
}

TEST_P(UdpMulticastOn, DoesNotHearItself) {
  UdpMulticast master{GetParam()};
  UdpMulticast drive{GetParam()};

  send(drive, "705#00");
  send(master, "000#0105");
  send(drive, "185#0000");

  EXPECT_EQ(next(drive), "000#0105");
  EXPECT_EQ(next(master), "705#00");
  EXPECT_EQ(next(master), "185#0000");
}

INSTANTIATE_TEST_SUITE_P(Groups, UdpMulticastOn, testing::Values(kOnLoopback, kSixOnLoopback));

TEST(UdpMulticast, FindsTheInterfaceByTheRouteToTheGroup) {
  network::ip("route replace 239.74.163.2 dev lo");
  UdpMulticast routed{{"239.74.163.2", 43113, ""}};
  UdpMulticast named{kOnLoopback};

  EXPECT_EQ(routed.interface(), "lo");
  send(routed, "701#05");
  EXPECT_EQ(next(named), "701#05");
}

TEST(UdpMulticast, SaysWhatIsMissingWithoutARoute) {
  EXPECT_EQ(reason_not_to_open("udp-multicast://239.1.2.3:43113"),
            "239.1.2.3: no route to the multicast group (Network is unreachable): add a route or name the "
            "interface (?interface=lo)");
}

TEST(UdpMulticast, NamesAnInterfaceThatIsNotThere) {
  EXPECT_EQ(reason_not_to_open("udp-multicast://239.1.2.3:43113?interface=eth7"),
            "eth7: no such network interface");
}

TEST(UdpMulticast, DeliversOnlyWhatIsWanted) {
  UdpMulticast master{kOnLoopback};
  UdpMulticast drive{kOnLoopback};
  drive.accept_only(std::vector{Filter{.identifier = 0x605}, Filter{.identifier = 0x705, .remote = true}});

  for (const char* const frame : {"604#00", "605#R", "605#40", "705#00", "705#R"}) send(master, frame);

  EXPECT_EQ(next(drive), "605#40");
  EXPECT_EQ(next(drive), "705#R");
}

TEST(UdpMulticast, KeepsGroupsAndPortsApart) {
  UdpMulticast drive{kOnLoopback};
  UdpMulticast other_port{{"239.74.163.2", 43114, "lo"}};
  UdpMulticast other_group{{"239.74.163.3", 43113, "lo"}};
  UdpMulticast master{kOnLoopback};

  send(other_port, "001#");
  send(other_group, "002#");
  send(master, "003#");

  EXPECT_EQ(next(drive), "003#");
}

TEST(UdpMulticast, CountsWhatIsNoFrame) {
  UdpMulticast drive{kOnLoopback};
  UdpMulticast master{kOnLoopback};

  send_bytes({});
  send_bytes({0xC1});
  send_bytes(std::vector<std::uint8_t>(multicast::kLongestDatagram + 1, 0x91));
  send_bytes(std::vector<std::uint8_t>(60'000, 0x91));
  send(master, "003#");

  EXPECT_EQ(next(drive), "003#");
  EXPECT_EQ(drive.rejected(), 4u);
  EXPECT_EQ(drive.dropped(), 4u);
}

TEST(UdpMulticast, TakesErrorFramesForTheErrorState) {
  UdpMulticast drive{kOnLoopback};
  can_frame passive{};
  passive.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL;
  passive.len = CAN_ERR_DLC;
  passive.data[1] = CAN_ERR_CRTL_TX_PASSIVE;

  send_bytes(multicast::pack(passive));

  EXPECT_EQ(next(drive), "error-passive");
  EXPECT_EQ(drive.error_state(), ErrorState::Passive);
}

TEST(UdpMulticast, GoesOnWhenTheInterfaceWasDown) {
  const Connection connection = open(parse_address("udp-multicast://239.74.163.2:43113?interface=lo").value());
  UdpMulticast master{kOnLoopback};
  network::ip("link set lo down");
  ASSERT_TRUE(network::readable(connection.link->descriptor()));
  EXPECT_EQ(connection.link->read(), LinkState::Down);
  EXPECT_NE(connection.port->send(fakes::frame_of("705#00")), SendStatus::Sent);
  network::ip("link set lo up");
  std::optional<LinkState> state;
  while (!state && network::readable(connection.link->descriptor())) state = connection.link->read();
  EXPECT_EQ(state, LinkState::Up);

  ASSERT_TRUE(connection.port->reopen());
  ASSERT_TRUE(master.reopen());

  send(*connection.port, "705#00");
  EXPECT_EQ(next(master), "705#00");
  send(master, "000#0105");
  EXPECT_EQ(next(*connection.port), "000#0105");
}

TEST(UdpMulticast, WaitsForAnInterfaceThatIsDownAtTheStart) {
  network::ip("link set lo down");

  const Connection connection = open(parse_address("udp-multicast://239.74.163.2:43113?interface=lo").value());

  EXPECT_EQ(connection.link->state(), LinkState::Down);
  network::ip("link set lo up");
  ASSERT_TRUE(connection.port->reopen());
  UdpMulticast master{kOnLoopback};
  send(master, "000#0105");
  EXPECT_EQ(next(*connection.port), "000#0105");
}

}  // namespace
}  // namespace bus
