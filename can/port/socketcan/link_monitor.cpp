#include "can/port/socketcan/link_monitor.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>

#include "can/port/socketcan/netlink.hpp"

namespace bus {

namespace {

// Large enough for any link message: the kernel builds them in 8 KiB.
constexpr std::size_t kBufferSize = 32768;

os::Descriptor open_socket() {
  os::Descriptor socket{::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE)};
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = RTMGRP_LINK;
  if (!socket || ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    throw std::system_error{errno, std::generic_category(), "rtnetlink"};
  return socket;
}

/// Value of attribute IFLA_IFNAME in @p attributes, empty if it is missing.
std::string_view interface_name(std::span<const std::byte> attributes) noexcept {
  const auto value = netlink::attribute(attributes, IFLA_IFNAME);
  const auto* text = reinterpret_cast<const char*>(value.data());
  return {text, ::strnlen(text, value.size())};
}

/// The link after one link message @p payload of type @p type, as far as the message is about it.
KnownLink follow(std::uint16_t type, std::span<const std::byte> payload, std::string_view name,
                 KnownLink link) noexcept {
  const auto about = netlink::front<ifinfomsg>(payload);
  if (!about) return link;
  const bool named = interface_name(netlink::after(payload, sizeof(ifinfomsg))) == name;
  if (type == RTM_NEWLINK && named)
    return {(about->ifi_flags & IFF_UP) != 0 ? LinkState::Up : LinkState::Down, about->ifi_index};
  // Another name on our index is a renaming: nothing of our name is left.
  const bool ours = link.index != 0 && about->ifi_index == link.index;
  const bool lost = type == RTM_DELLINK ? ours || (named && link.index == 0) : ours;
  return lost ? KnownLink{} : link;
}

}  // namespace

bool follow_link_messages(std::span<const std::byte> bytes, std::string_view name, KnownLink& link) noexcept {
  bool changed = false;
  while (const auto header = netlink::front<nlmsghdr>(bytes)) {
    if (header->nlmsg_len < sizeof(nlmsghdr) || header->nlmsg_len > bytes.size()) break;
    const auto payload = bytes.subspan(sizeof(nlmsghdr), header->nlmsg_len - sizeof(nlmsghdr));
    if (header->nlmsg_type == RTM_NEWLINK || header->nlmsg_type == RTM_DELLINK) {
      const KnownLink next = follow(header->nlmsg_type, payload, name, link);
      changed |= std::exchange(link, next) != next;
    }
    bytes = netlink::after(bytes, header->nlmsg_len);
  }
  return changed;
}

LinkMonitor::LinkMonitor(std::string interface) : interface_{std::move(interface)}, socket_{open_socket()} {
  start_again();  // after the subscription, so that no change falls between
}

LinkState LinkMonitor::start_again() noexcept {
  const LinkState state = query(interface_);
  link_ = {state, state == LinkState::Gone ? 0 : static_cast<int>(::if_nametoindex(interface_.c_str()))};
  return state;
}

std::optional<LinkState> LinkMonitor::read() noexcept {
  alignas(nlmsghdr) std::array<std::byte, kBufferSize> buffer{};
  bool changed = false;
  bool lost = false;
  for (;;) {
    // MSG_TRUNC: the length of the message, also where the buffer is too small for it.
    const ssize_t size = ::recv(socket_.get(), buffer.data(), buffer.size(), MSG_DONTWAIT | MSG_TRUNC);
    if (size < 0 && errno != EINTR && errno != ENOBUFS) break;
    // ENOBUFS: messages were lost. Those still queued are older than the loss and must not have the last word.
    lost |= size < 0 ? errno == ENOBUFS : static_cast<std::size_t>(size) > buffer.size();
    if (size < 0 || lost) continue;
    changed |= follow_link_messages(std::span{buffer}.first(static_cast<std::size_t>(size)), interface_, link_);
  }
  if (lost) return start_again();
  return changed ? std::optional{link_.state} : std::nullopt;
}

}  // namespace bus
