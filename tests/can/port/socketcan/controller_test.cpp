#include "can/port/socketcan/controller.hpp"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>

#include "can/port/socketcan/netlink.hpp"

namespace {

using bus::netlink::after;
using bus::netlink::attribute;
using bus::netlink::front;

void append(std::vector<std::byte>& bytes, const void* data, std::size_t size) {
  const auto* begin = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
  bytes.resize((bytes.size() + 3) & ~std::size_t{3});
}

/// The kernel's description of an interface of @p kind.
std::vector<std::byte> description(std::uint16_t type, const std::string& kind) {
  std::vector<std::byte> bytes;
  nlmsghdr header{};
  header.nlmsg_type = type;
  append(bytes, &header, sizeof header);
  const ifinfomsg about{};
  append(bytes, &about, sizeof about);
  const auto length = static_cast<unsigned short>(sizeof(rtattr) + kind.size() + 1);
  const rtattr outer{static_cast<unsigned short>(sizeof(rtattr) + ((length + 3U) & ~3U)), IFLA_LINKINFO};
  append(bytes, &outer, sizeof outer);
  const rtattr inner{length, IFLA_INFO_KIND};
  append(bytes, &inner, sizeof inner);
  append(bytes, kind.c_str(), kind.size() + 1);
  return bytes;
}

TEST(Controller, IsWhatTheKernelCallsCan) {
  EXPECT_TRUE(bus::describes_controller(description(RTM_NEWLINK, "can")));
  for (const char* const kind : {"vcan", "vxcan", "ca", "", "dummy"})
    EXPECT_FALSE(bus::describes_controller(description(RTM_NEWLINK, kind))) << kind;
  EXPECT_FALSE(bus::describes_controller(description(NLMSG_ERROR, "can")));
}

TEST(Controller, IsNotFoundInAMessageThatEndsEarly) {
  const std::vector<std::byte> whole = description(RTM_NEWLINK, "can");
  for (std::size_t size = 0; size < whole.size() - 4; ++size)
    EXPECT_FALSE(bus::describes_controller(std::span{whole}.first(size))) << size;
}

TEST(RestartRequest, NamesTheInterfaceAndTheRestart) {
  const auto request = bus::restart_request(7);

  const auto header = front<nlmsghdr>(request);
  ASSERT_LE(header->nlmsg_len, request.size());
  EXPECT_EQ(header->nlmsg_type, RTM_NEWLINK);
  EXPECT_EQ(header->nlmsg_flags, NLM_F_REQUEST | NLM_F_ACK);
  const auto body = after(std::span{request}.first(header->nlmsg_len), sizeof(nlmsghdr));
  EXPECT_EQ(front<ifinfomsg>(body)->ifi_index, 7);
  const auto information = attribute(after(body, sizeof(ifinfomsg)), IFLA_LINKINFO);
  const auto kind = attribute(information, IFLA_INFO_KIND);
  EXPECT_STREQ(reinterpret_cast<const char*>(kind.data()), "can");
  const auto restart = attribute(attribute(information, IFLA_INFO_DATA), IFLA_CAN_RESTART);
  EXPECT_EQ(front<std::uint32_t>(restart), 1U);
}

TEST(RestartController, OfAnInterfaceWithoutOneIsDoneAtOnce) {
  constexpr int kLoopback = 1;

  EXPECT_EQ(bus::restart_controller(kLoopback), bus::Restart::Done);
}

}  // namespace
