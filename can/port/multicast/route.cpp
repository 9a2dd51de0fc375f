#include "can/port/multicast/route.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <netinet/in.h>

#include "os/descriptor.hpp"

namespace bus {

namespace {

constexpr std::size_t kAlignment = 4;
constexpr std::size_t kAnswerSize = 4096;

/// RTM_GETROUTE for one destination.
struct Question {
  nlmsghdr header{};
  rtmsg route{};
  rtattr attribute{};
  std::array<std::byte, sizeof(in6_addr)> destination{};
};
static_assert(sizeof(Question) == sizeof(nlmsghdr) + sizeof(rtmsg) + sizeof(rtattr) + sizeof(in6_addr));

Question ask_for(const SocketAddress& destination) noexcept {
  const bool six = destination.storage.ss_family == AF_INET6;
  const std::size_t size = six ? sizeof(in6_addr) : sizeof(in_addr);
  const std::size_t offset = six ? offsetof(sockaddr_in6, sin6_addr) : offsetof(sockaddr_in, sin_addr);
  Question question;
  question.header.nlmsg_len = static_cast<std::uint32_t>(offsetof(Question, destination) + size);
  question.header.nlmsg_type = RTM_GETROUTE;
  question.header.nlmsg_flags = NLM_F_REQUEST;
  question.route.rtm_family = static_cast<unsigned char>(destination.storage.ss_family);
  question.route.rtm_dst_len = static_cast<unsigned char>(8 * size);
  question.attribute.rta_type = RTA_DST;
  question.attribute.rta_len = static_cast<unsigned short>(sizeof(rtattr) + size);
  std::memcpy(question.destination.data(), reinterpret_cast<const std::byte*>(&destination.storage) + offset,
              size);
  return question;
}

template <class T>
T front(std::span<const std::byte> bytes) noexcept {
  T value{};
  std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof value));
  return value;
}

/// Index of the interface in the kernel's @p answer; 0 with errno set if it is a refusal.
unsigned interface_in(std::span<const std::byte> answer) noexcept {
  const auto header = front<nlmsghdr>(answer);
  errno = ENETUNREACH;
  if (header.nlmsg_type == NLMSG_ERROR && answer.size() >= sizeof(nlmsghdr) + sizeof(nlmsgerr))
    errno = -front<nlmsgerr>(answer.subspan(sizeof(nlmsghdr))).error;
  if (header.nlmsg_type != RTM_NEWROUTE || answer.size() < sizeof(nlmsghdr) + sizeof(rtmsg)) return 0;
  for (auto rest = answer.subspan(sizeof(nlmsghdr) + sizeof(rtmsg)); rest.size() >= sizeof(rtattr);) {
    const auto attribute = front<rtattr>(rest);
    if (attribute.rta_len < sizeof(rtattr)) break;
    if (attribute.rta_type == RTA_OIF) return front<unsigned>(rest.subspan(sizeof(rtattr)));
    const std::size_t aligned = (attribute.rta_len + kAlignment - 1) / kAlignment * kAlignment;
    rest = rest.subspan(std::min(rest.size(), aligned));
  }
  return 0;
}

}  // namespace

std::string interface_towards(const SocketAddress& destination) {
  const os::Descriptor socket{::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE)};
  const Question question = ask_for(destination);
  const auto size = static_cast<ssize_t>(question.header.nlmsg_len);
  if (!socket || ::send(socket.get(), &question, question.header.nlmsg_len, 0) != size) return {};
  std::array<std::byte, kAnswerSize> answer{};
  const ssize_t got = ::recv(socket.get(), answer.data(), answer.size(), 0);
  if (got < static_cast<ssize_t>(sizeof(nlmsghdr))) return {};
  const unsigned index = interface_in(std::span{answer}.first(static_cast<std::size_t>(got)));
  std::array<char, IF_NAMESIZE> name{};
  return index != 0 && ::if_indextoname(index, name.data()) != nullptr ? std::string{name.data()} : std::string{};
}

}  // namespace bus
