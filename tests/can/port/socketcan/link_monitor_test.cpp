#include "can/port/socketcan/link_monitor.hpp"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/rtnetlink.h>
#include <net/if.h>

namespace {

using bus::KnownLink;
using bus::LinkState;

void append(std::vector<std::byte>& bytes, const void* data, std::size_t size) {
  const auto* begin = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
  bytes.resize((bytes.size() + 3) & ~std::size_t{3});
}

/// A link message as the kernel sends it: header, ifinfomsg, an attribute nobody asked for, the name.
std::vector<std::byte> message(std::uint16_t type, int index, unsigned flags, const std::string& name) {
  std::vector<std::byte> bytes;
  nlmsghdr header{};
  header.nlmsg_type = type;
  append(bytes, &header, sizeof header);
  ifinfomsg about{};
  about.ifi_index = index;
  about.ifi_flags = flags;
  append(bytes, &about, sizeof about);
  const rtattr other{sizeof(rtattr) + 1, IFLA_OPERSTATE};
  append(bytes, &other, sizeof other);
  append(bytes, "x", 1);
  const rtattr named{static_cast<unsigned short>(sizeof(rtattr) + name.size() + 1), IFLA_IFNAME};
  append(bytes, &named, sizeof named);
  append(bytes, name.c_str(), name.size() + 1);
  header.nlmsg_len = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

std::vector<std::byte> operator+(std::vector<std::byte> a, const std::vector<std::byte>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(LinkMessages, TellThatTheInterfaceCameUp) {
  KnownLink link{LinkState::Down, 4};

  EXPECT_TRUE(bus::follow_link_messages(message(RTM_NEWLINK, 4, IFF_UP, "vcan0"), "vcan0", link));
  EXPECT_EQ(link, (KnownLink{LinkState::Up, 4}));
}

TEST(LinkMessages, TellThatTheInterfaceWentDown) {
  KnownLink link{LinkState::Up, 4};

  EXPECT_TRUE(bus::follow_link_messages(message(RTM_NEWLINK, 4, 0, "vcan0"), "vcan0", link));
  EXPECT_EQ(link, (KnownLink{LinkState::Down, 4}));
}

TEST(LinkMessages, TellThatTheInterfaceIsGone) {
  KnownLink link{LinkState::Up, 4};

  EXPECT_TRUE(bus::follow_link_messages(message(RTM_DELLINK, 4, IFF_UP, "vcan0"), "vcan0", link));
  EXPECT_EQ(link, KnownLink{});
}

TEST(LinkMessages, TellThatTheInterfaceWasRenamed) {
  KnownLink link{LinkState::Up, 4};

  EXPECT_TRUE(bus::follow_link_messages(message(RTM_NEWLINK, 4, IFF_UP, "can7"), "vcan0", link));
  EXPECT_EQ(link.state, LinkState::Gone);
}

TEST(LinkMessages, OfAnotherInterfaceAreNoNews) {
  KnownLink link{LinkState::Up, 4};

  EXPECT_FALSE(bus::follow_link_messages(message(RTM_NEWLINK, 5, 0, "vcan1"), "vcan0", link));
  EXPECT_FALSE(bus::follow_link_messages(message(RTM_DELLINK, 6, 0, "vcan00"), "vcan0", link));
  EXPECT_EQ(link, (KnownLink{LinkState::Up, 4}));
}

TEST(LinkMessages, ThatRepeatTheStateAreNoNews) {
  KnownLink link{LinkState::Up, 4};

  EXPECT_FALSE(bus::follow_link_messages(message(RTM_NEWLINK, 4, IFF_UP | IFF_RUNNING, "vcan0"), "vcan0", link));
}

TEST(LinkMessages, TellAReplacedInterfaceThoughItEndsInTheSameState) {
  KnownLink link{LinkState::Up, 4};
  const auto bytes = message(RTM_DELLINK, 4, 0, "vcan0") + message(RTM_NEWLINK, 9, IFF_UP, "vcan0");

  EXPECT_TRUE(bus::follow_link_messages(bytes, "vcan0", link));
  EXPECT_EQ(link, (KnownLink{LinkState::Up, 9}));
}

TEST(LinkMessages, CutAnywhereAreHarmless) {
  const auto bytes = message(RTM_NEWLINK, 4, IFF_UP, "vcan0") + message(RTM_DELLINK, 4, 0, "vcan0");
  for (std::size_t size = 0; size < bytes.size() / 2; ++size) {
    const std::vector<std::byte> cut{bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
    KnownLink link{LinkState::Down, 4};

    EXPECT_FALSE(bus::follow_link_messages(cut, "vcan0", link)) << size;
  }
}

TEST(LinkMonitor, StartsWithThePresentState) {
  EXPECT_EQ(bus::LinkMonitor{"nocan99"}.state(), LinkState::Gone);
  EXPECT_EQ(bus::LinkMonitor{"lo"}.state(), bus::query("lo"));
}

TEST(LinkMonitor, HasNothingToTellWhileNothingHappens) {
  bus::LinkMonitor monitor{"nocan99"};

  EXPECT_EQ(monitor.read(), std::nullopt);
}

}  // namespace
