#include "can/port/interface.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <linux/can.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace bus {

namespace {

/// Asks @p socket @p what about interface @p name; false with errno set when it has no answer.
bool ask(const std::string& name, const os::Descriptor& socket, unsigned long what, ifreq& answer) noexcept {
  if (name.empty() || name.size() >= IFNAMSIZ) {
    errno = ENODEV;
    return false;
  }
  answer = {};
  std::copy(name.begin(), name.end(), answer.ifr_name);
  return socket && ::ioctl(socket.get(), what, &answer) == 0;
}

/// A socket to ask: of CAN, which may know interfaces that others do not know, if there is CAN.
os::Descriptor any_socket() noexcept {
  os::Descriptor socket{::socket(AF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW)};
  return socket ? std::move(socket) : os::Descriptor{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
}

}  // namespace

LinkState query(const std::string& name) noexcept {
  ifreq answer{};
  if (!ask(name, any_socket(), SIOCGIFFLAGS, answer)) return LinkState::Gone;
  return (answer.ifr_flags & IFF_UP) != 0 ? LinkState::Up : LinkState::Down;
}

tl::expected<int, OpenError> can_interface_index(const std::string& name, const os::Descriptor& socket) {
  ifreq answer{};
  if (!ask(name, socket, SIOCGIFHWADDR, answer)) {
    if (errno == ENODEV) return tl::unexpected{OpenError{fmt::format("{}: no such CAN interface", name)}};
    return tl::unexpected{OpenError{fmt::format("{}: {}", name, std::generic_category().message(errno))}};
  }
  if (answer.ifr_hwaddr.sa_family != ARPHRD_CAN)
    return tl::unexpected{OpenError{fmt::format("{}: not a CAN interface", name)}};
  if (!ask(name, socket, SIOCGIFINDEX, answer))
    return tl::unexpected{OpenError{fmt::format("{}: no such CAN interface", name)}};
  return answer.ifr_ifindex;
}

}  // namespace bus
