#include "tests/can/preload/conformance/can_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>

#include <sys/time.h>
#include <unistd.h>

namespace conformance {

const char* interface_name() {
  const char* const chosen = std::getenv("CAN_INTERFACE");
  return chosen != nullptr ? chosen : "vcan0";
}

int interface_index() {
  return static_cast<int>(::if_nametoindex(interface_name()));
}

can_frame frame(canid_t id, std::initializer_list<std::uint8_t> data) {
  can_frame made{};
  made.can_id = id;
  made.can_dlc = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), made.data);
  return made;
}

sockaddr_can address_of(int index) {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = index;
  return address;
}

int error_of(ssize_t result) {
  return result < 0 ? errno : 0;
}

CanSocket::CanSocket() : CanSocket{SOCK_RAW, CAN_RAW} {
  if (bind_to(interface_index()) != 0) throw std::runtime_error{"cannot bind to the interface"};
}

CanSocket::CanSocket(int type, int protocol) : fd_{::socket(AF_CAN, type, protocol)} {
  if (fd_ < 0) throw std::runtime_error{"no CAN socket"};
  const timeval limit{.tv_sec = 5, .tv_usec = 0};
  ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
}

CanSocket::~CanSocket() {
  ::close(fd_);
}

int CanSocket::bind_to(int index) const {
  const sockaddr_can address = address_of(index);
  return error_of(::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address));
}

int CanSocket::set(int level, int option, int value) const {
  return error_of(::setsockopt(fd_, level, option, &value, sizeof value));
}

int CanSocket::set_filters(std::initializer_list<can_filter> filters) const {
  return error_of(::setsockopt(fd_, SOL_CAN_RAW, CAN_RAW_FILTER, filters.begin(),
                               static_cast<socklen_t>(filters.size() * sizeof(can_filter))));
}

int CanSocket::get(int level, int option) const {
  int value = 0;
  socklen_t size = sizeof value;
  return ::getsockopt(fd_, level, option, &value, &size) == 0 ? value : -errno;
}

int CanSocket::send(const can_frame& sent) const {
  return error_of(::write(fd_, &sent, sizeof sent));
}

std::optional<can_frame> CanSocket::receive() const {
  can_frame received{};
  if (::read(fd_, &received, sizeof received) != sizeof received) return std::nullopt;
  return received;
}

canid_t CanSocket::receive_id() const {
  const std::optional<can_frame> received = receive();
  return received ? received->can_id : 0;
}

}  // namespace conformance
