#include "can/port/socketcan/controller.hpp"

#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include "can/port/socketcan/netlink.hpp"
#include "os/descriptor.hpp"

namespace bus {
namespace {

constexpr std::string_view kKind = "can";
// Large enough for any link message: the kernel builds them in 8 KiB.
constexpr std::size_t kBufferSize = 32768;

/// Writes parts of a message one behind the other, each padded to four bytes.
struct Writer {
  std::span<std::byte> room;
  std::size_t size = 0;

  template <class T>
  std::size_t put(const T& value) noexcept {
    return put(&value, sizeof value);
  }
  std::size_t put(const void* data, std::size_t length) noexcept {
    const std::size_t at = size;
    std::memcpy(&room[at], data, length);
    size += (length + 3) & ~std::size_t{3};
    return at;
  }
  /// Begins an attribute; close() gives it its length.
  std::size_t open(unsigned short type) noexcept { return put(rtattr{0, type}); }
  void close(std::size_t at) const noexcept {
    const auto length = static_cast<unsigned short>(size - at);
    std::memcpy(&room[at], &length, sizeof length);
  }
};

/// Sends @p request; 0 and the answer in @p answer, or the error.
int ask(const os::Descriptor& socket, std::span<const std::byte> request, std::span<std::byte>& answer) noexcept {
  if (::send(socket.get(), request.data(), request.size(), 0) < 0) return errno;
  const ssize_t size = ::recv(socket.get(), answer.data(), answer.size(), MSG_DONTWAIT);  // it is there by now
  if (size < 0) return errno;
  answer = answer.first(static_cast<std::size_t>(size));
  const auto header = netlink::front<nlmsghdr>(answer);
  if (!header) return EPROTO;
  if (header->nlmsg_type != NLMSG_ERROR) return 0;
  const auto error = netlink::front<nlmsgerr>(netlink::after(answer, sizeof(nlmsghdr)));
  return error ? -error->error : EPROTO;
}

struct DescribeRequest {
  nlmsghdr header{sizeof(DescribeRequest), RTM_GETLINK, NLM_F_REQUEST, 0, 0};
  ifinfomsg about{};
};

/// What an error of the restart says.
Restart outcome_of(int error) noexcept {
  switch (error) {
    case 0:
      return Restart::Started;
    case EBUSY:  // it is not off
      return Restart::Done;
    case EINVAL:  // the interface does it by itself (restart-ms), or is down and will begin anew
      return Restart::Started;
    default:
      return Restart::Refused;
  }
}

}  // namespace

bool describes_controller(std::span<const std::byte> message) noexcept {
  const auto header = netlink::front<nlmsghdr>(message);
  if (!header || header->nlmsg_type != RTM_NEWLINK) return false;
  const auto attributes = netlink::after(message, sizeof(nlmsghdr) + sizeof(ifinfomsg));
  const auto kind = netlink::attribute(netlink::attribute(attributes, IFLA_LINKINFO), IFLA_INFO_KIND);
  const std::string_view text{reinterpret_cast<const char*>(kind.data()), kind.size()};
  return text.substr(0, text.find('\0')) == kKind;
}

std::array<std::byte, 64> restart_request(int index) noexcept {
  std::array<std::byte, 64> bytes{};
  nlmsghdr header{sizeof bytes, RTM_NEWLINK, NLM_F_REQUEST | NLM_F_ACK, 0, 0};
  ifinfomsg about{};
  about.ifi_index = index;
  Writer message{bytes};
  message.put(header);
  message.put(about);
  const std::size_t information = message.open(IFLA_LINKINFO);
  const std::size_t kind = message.open(IFLA_INFO_KIND);
  message.put(kKind.data(), kKind.size() + 1);  // a literal: with its terminator
  message.close(kind);
  const std::size_t data = message.open(IFLA_INFO_DATA);
  const std::size_t restart = message.open(IFLA_CAN_RESTART);
  message.put(std::uint32_t{1});
  message.close(restart);
  message.close(data);
  message.close(information);
  header.nlmsg_len = static_cast<std::uint32_t>(message.size);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

Restart restart_controller(int index) noexcept {
  const os::Descriptor socket{::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE)};
  if (!socket) return Restart::Refused;
  alignas(nlmsghdr) std::array<std::byte, kBufferSize> buffer{};
  std::span<std::byte> answer{buffer};
  DescribeRequest describe;
  describe.about.ifi_index = index;
  if (ask(socket, std::as_bytes(std::span{&describe, 1}), answer) != 0 || !describes_controller(answer))
    return Restart::Done;
  answer = buffer;
  const auto request = restart_request(index);
  const auto header = netlink::front<nlmsghdr>(request);
  return outcome_of(ask(socket, std::span{request}.first(header->nlmsg_len), answer));
}

}  // namespace bus
