#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

ifreq request_for(const char* name) {
  ifreq request{};
  std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  return request;
}

TEST(Interface, HasAnIndexByItsName) {
  const CanSocket socket;
  ifreq request = request_for(interface_name());

  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFINDEX, &request)), 0);

  EXPECT_GT(request.ifr_ifindex, 0);
  EXPECT_EQ(request.ifr_ifindex, interface_index());
}

TEST(Interface, HasANameByItsIndex) {
  const CanSocket socket;
  ifreq request{};
  request.ifr_ifindex = interface_index();

  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFNAME, &request)), 0);

  EXPECT_STREQ(request.ifr_name, interface_name());
  char name[IF_NAMESIZE];
  EXPECT_STREQ(if_indextoname(static_cast<unsigned>(interface_index()), name), interface_name());
}

TEST(Interface, IsUpAndACan) {
  const CanSocket socket;
  ifreq flags = request_for(interface_name());
  ifreq address = request_for(interface_name());
  ifreq mtu = request_for(interface_name());

  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFFLAGS, &flags)), 0);
  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFHWADDR, &address)), 0);
  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFMTU, &mtu)), 0);

  EXPECT_EQ(flags.ifr_flags & (IFF_UP | IFF_RUNNING | IFF_NOARP), IFF_UP | IFF_RUNNING | IFF_NOARP);
  EXPECT_EQ(address.ifr_hwaddr.sa_family, ARPHRD_CAN);
  EXPECT_TRUE(mtu.ifr_mtu == CAN_MTU || mtu.ifr_mtu == CANFD_MTU) << mtu.ifr_mtu;
}

TEST(Interface, HasAQueueLength) {
  const CanSocket socket;
  ifreq request = request_for(interface_name());

  ASSERT_EQ(error_of(ioctl(socket.fd(), SIOCGIFTXQLEN, &request)), 0);

  EXPECT_GT(request.ifr_qlen, 0);
}

TEST(Interface, CanBeAskedForThroughAnySocket) {
  const int other = socket(AF_UNIX, SOCK_DGRAM, 0);
  ifreq request = request_for(interface_name());

  EXPECT_EQ(error_of(ioctl(other, SIOCGIFINDEX, &request)), 0);

  EXPECT_EQ(request.ifr_ifindex, interface_index());
  close(other);
}

TEST(Interface, IsListedOnceItIsKnown) {
  const CanSocket socket;
  struct if_nameindex* const all = if_nameindex();
  ASSERT_NE(all, nullptr);
  int found = 0;

  for (const struct if_nameindex* entry = all; entry->if_index != 0; ++entry)
    if (std::strcmp(entry->if_name, interface_name()) == 0) found = static_cast<int>(entry->if_index);

  EXPECT_EQ(found, interface_index());
  if_freenameindex(all);
}

TEST(Interface, OfANameThatIsNoneIsNoDevice) {
  const CanSocket socket;
  ifreq request = request_for("nosuch0");

  EXPECT_EQ(error_of(ioctl(socket.fd(), SIOCGIFINDEX, &request)), ENODEV);
  EXPECT_EQ(error_of(ioctl(socket.fd(), SIOCGIFMTU, &request)), ENODEV);
  errno = 0;
  EXPECT_EQ(if_nametoindex("nosuch0"), 0u);
  EXPECT_EQ(errno, ENODEV);
}

TEST(Interface, OfAnIndexThatIsNoneHasNoName) {
  const CanSocket socket;
  ifreq request{};
  request.ifr_ifindex = 99999;
  char name[IF_NAMESIZE];

  EXPECT_EQ(error_of(ioctl(socket.fd(), SIOCGIFNAME, &request)), ENODEV);
  errno = 0;
  EXPECT_EQ(if_indextoname(99999, name), nullptr);
  EXPECT_EQ(errno, ENXIO);
}

}  // namespace
}  // namespace conformance
