#include "bus/interface.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "bus/descriptor.hpp"

namespace bus {

namespace {

/// Asks the kernel @p what about interface @p name; false with errno set when it has no answer.
bool ask(const std::string& name, unsigned long what, ifreq& answer) noexcept {
  if (name.empty() || name.size() >= IFNAMSIZ) {
    errno = ENODEV;
    return false;
  }
  const Descriptor any_socket{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  answer = {};
  std::copy(name.begin(), name.end(), answer.ifr_name);
  return any_socket && ::ioctl(any_socket.get(), what, &answer) == 0;
}

}  // namespace

LinkState query(const std::string& name) noexcept {
  ifreq answer{};
  if (!ask(name, SIOCGIFFLAGS, answer)) return LinkState::Gone;
  return (answer.ifr_flags & IFF_UP) != 0 ? LinkState::Up : LinkState::Down;
}

tl::expected<int, OpenError> can_interface_index(const std::string& name) {
  ifreq answer{};
  if (!ask(name, SIOCGIFHWADDR, answer)) {
    if (errno == ENODEV) return tl::unexpected{OpenError{fmt::format("{}: no such CAN interface", name)}};
    return tl::unexpected{OpenError{fmt::format("{}: {}", name, std::generic_category().message(errno))}};
  }
  if (answer.ifr_hwaddr.sa_family != ARPHRD_CAN)
    return tl::unexpected{OpenError{fmt::format("{}: not a CAN interface", name)}};
  if (!ask(name, SIOCGIFINDEX, answer))
    return tl::unexpected{OpenError{fmt::format("{}: no such CAN interface", name)}};
  return answer.ifr_ifindex;
}

}  // namespace bus
