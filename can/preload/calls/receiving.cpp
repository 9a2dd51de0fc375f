// The calls that receive: read, readv, recv, recvfrom, recvmsg, and what a fortified program calls in their place.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/address.hpp"
#include "can/preload/socket/receive.hpp"
#include "can/preload/time/wait/readiness.hpp"

namespace preload {

namespace {

using userbus::Name;

ssize_t receive_into(int descriptor, const Name& name, void* data, size_t size, int flags) noexcept {
  const iovec part{data, size};
  Received received{};
  return receive(descriptor, name, {&part, 1}, flags, received);
}

ssize_t receive_from(int descriptor, const Name& name, const iovec& room, int flags, msghdr& address) noexcept {
  Received received{};
  const ssize_t size = receive(descriptor, name, {&room, 1}, flags, received);
  if (size >= 0 && address.msg_name != nullptr)
    give_address(received.trailer.interface_index, address.msg_name, address.msg_namelen);
  return size;
}

/// Descriptors may have come with @p message, and CAN sockets may be among them.
void look_at_arrived(const msghdr& message) noexcept {
  if (expects_can_sockets() || message.msg_control == nullptr) return;
  auto& all = const_cast<msghdr&>(message);
  for (cmsghdr* header = CMSG_FIRSTHDR(&all); header != nullptr; header = CMSG_NXTHDR(&all, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    const auto* const descriptors = reinterpret_cast<const int*>(CMSG_DATA(header));
    const size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (size_t i = 0; i < count; ++i) look_at(descriptors[i]);
  }
}

}  // namespace

}  // namespace preload

using preload::is_can;
using preload::may_read;
using preload::next;

PRELOAD_EXPORT ssize_t read(int descriptor, void* data, size_t size) {
  if (!may_read(descriptor)) return -1;
  userbus::Name name{};
  if (size == 0 || !is_can(descriptor, name)) return next().read(descriptor, data, size);
  return preload::receive_into(descriptor, name, data, size, 0);
}

PRELOAD_EXPORT ssize_t readv(int descriptor, const iovec* parts, int count) {
  if (!may_read(descriptor)) return -1;
  userbus::Name name{};
  if (count <= 0 || !is_can(descriptor, name)) return next().readv(descriptor, parts, count);
  const preload::Parts room{parts, static_cast<size_t>(count)};
  preload::Received received{};
  return preload::size_of(room) == 0 ? 0 : preload::receive(descriptor, name, room, 0, received);
}

PRELOAD_EXPORT ssize_t recv(int descriptor, void* data, size_t size, int flags) {
  if (!may_read(descriptor, flags)) return -1;
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().recv(descriptor, data, size, flags);
  return preload::receive_into(descriptor, name, data, size, flags);
}

PRELOAD_EXPORT ssize_t recvfrom(int descriptor, void* data, size_t size, int flags, sockaddr* address,
                                socklen_t* length) {
  if (!may_read(descriptor, flags)) return -1;
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().recvfrom(descriptor, data, size, flags, address, length);
  msghdr from{};
  from.msg_name = address;
  from.msg_namelen = address != nullptr && length != nullptr ? *length : 0;
  const ssize_t result = preload::receive_from(descriptor, name, {data, size}, flags, from);
  if (result >= 0 && address != nullptr && length != nullptr) *length = from.msg_namelen;
  return result;
}

PRELOAD_EXPORT ssize_t recvmsg(int descriptor, msghdr* message, int flags) {
  if (!may_read(descriptor, flags)) return -1;
  userbus::Name name{};
  if (is_can(descriptor, name)) return preload::receive_message(descriptor, name, *message, flags);
  const ssize_t result = next().recvmsg(descriptor, message, flags);
  if (result >= 0) preload::look_at_arrived(*message);
  return result;
}

// The C library's own check ends the program if `room` is too small.

PRELOAD_EXPORT ssize_t __read_chk(int descriptor, void* data, size_t size, size_t room) {
  if (size > room) return next().read_chk(descriptor, data, size, room);
  return read(descriptor, data, size);
}

PRELOAD_EXPORT ssize_t __recv_chk(int descriptor, void* data, size_t size, size_t room, int flags) {
  if (size > room) return next().recv_chk(descriptor, data, size, room, flags);
  return recv(descriptor, data, size, flags);
}

PRELOAD_EXPORT ssize_t __recvfrom_chk(int descriptor, void* data, size_t size, size_t room, int flags,
                                      sockaddr* address, socklen_t* length) {
  if (size > room) return next().recvfrom_chk(descriptor, data, size, room, flags, address, length);
  return recvfrom(descriptor, data, size, flags, address, length);
}
