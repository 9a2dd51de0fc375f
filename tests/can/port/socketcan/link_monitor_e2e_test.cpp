#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "can/port/socketcan/link_monitor.hpp"
#include "tests/support/network.hpp"

namespace {

using bus::LinkMonitor;
using bus::LinkState;
using network::VirtualCan;

/// What @p monitor tells next; messages of other interfaces make it readable too.
std::optional<LinkState> next(LinkMonitor& monitor) {
  while (network::readable(monitor.descriptor()))
    if (const auto state = monitor.read()) return state;
  return std::nullopt;
}

void set_up(const std::string& name, bool up) {
  const os::Descriptor any_socket{::socket(AF_UNIX, SOCK_DGRAM, 0)};
  ifreq request{};
  name.copy(request.ifr_name, IFNAMSIZ - 1);
  request.ifr_flags = up ? IFF_UP : 0;
  if (::ioctl(any_socket.get(), SIOCSIFFLAGS, &request) != 0) throw std::runtime_error{"SIOCSIFFLAGS"};
}

TEST(LinkMonitorOnVcan, TellsEveryChangeOfAnInterfaceFromItsMakingToItsEnd) {
  LinkMonitor monitor{"vcanlife"};
  ASSERT_EQ(monitor.state(), LinkState::Gone);

  network::ip("link add dev vcanlife type vcan");
  EXPECT_EQ(next(monitor), LinkState::Down);
  network::ip("link set vcanlife up");
  EXPECT_EQ(next(monitor), LinkState::Up);
  network::ip("link set vcanlife down");
  EXPECT_EQ(next(monitor), LinkState::Down);
  network::ip("link del vcanlife");
  EXPECT_EQ(next(monitor), LinkState::Gone);
}

TEST(LinkMonitorOnVcan, TellsThatAnInterfaceWasReplacedByOneInTheSameState) {
  VirtualCan can{"vcanagain"};
  LinkMonitor monitor{can.name()};
  ASSERT_EQ(monitor.state(), LinkState::Up);

  can.remove();
  can.create();

  EXPECT_EQ(next(monitor), LinkState::Up);
}

TEST(LinkMonitorOnVcan, TakesARenamingForTheEnd) {
  const VirtualCan can{"vcannew"};
  can.down();
  network::ip("link set vcannew name vcanold");
  LinkMonitor monitor{"vcanold"};
  ASSERT_EQ(monitor.state(), LinkState::Down);

  network::ip("link set vcanold name vcannew");

  EXPECT_EQ(next(monitor), LinkState::Gone);
}

TEST(LinkMonitorOnVcan, KnowsTheStateThoughMessagesWereLost) {
  const VirtualCan can{"vcanflap"};
  LinkMonitor monitor{can.name()};

  // Far more messages than the socket holds; the last state is one that the kept messages do not end in.
  for (int i = 0; i < 3000; ++i) set_up(can.name(), i % 2 != 0);
  set_up(can.name(), false);

  EXPECT_EQ(next(monitor), LinkState::Down);
  EXPECT_EQ(monitor.read(), std::nullopt);  // nothing old is left that could speak against it
  EXPECT_EQ(monitor.state(), LinkState::Down);
}

}  // namespace
