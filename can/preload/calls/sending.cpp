// The calls that send: write, writev, send, sendto, sendmsg.
#include "can/preload/calls/exported.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/send.hpp"

using preload::is_can;
using preload::next;

namespace {

constexpr preload::Destination kNoAddress{nullptr, 0};

ssize_t send_data(int descriptor, const userbus::Name& name, const void* data, size_t size, int flags) noexcept {
  const iovec part{const_cast<void*>(data), size};
  return preload::send(descriptor, name, {&part, 1}, flags, kNoAddress);
}

}  // namespace

PRELOAD_EXPORT ssize_t write(int descriptor, const void* data, size_t size) {
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().write(descriptor, data, size);
  return send_data(descriptor, name, data, size, 0);
}

PRELOAD_EXPORT ssize_t writev(int descriptor, const iovec* parts, int count) {
  userbus::Name name{};
  if (count <= 0 || !is_can(descriptor, name)) return next().writev(descriptor, parts, count);
  const preload::Parts all{parts, static_cast<size_t>(count)};
  return preload::size_of(all) == 0 ? 0 : preload::send(descriptor, name, all, 0, kNoAddress);
}

PRELOAD_EXPORT ssize_t send(int descriptor, const void* data, size_t size, int flags) {
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().send(descriptor, data, size, flags);
  return send_data(descriptor, name, data, size, flags);
}

PRELOAD_EXPORT ssize_t sendto(int descriptor, const void* data, size_t size, int flags, const sockaddr* address,
                              socklen_t length) {
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().sendto(descriptor, data, size, flags, address, length);
  const iovec part{const_cast<void*>(data), size};
  return preload::send(descriptor, name, {&part, 1}, flags, {address, length});
}

PRELOAD_EXPORT ssize_t sendmsg(int descriptor, const msghdr* message, int flags) {
  userbus::Name name{};
  if (!is_can(descriptor, name)) return next().sendmsg(descriptor, message, flags);
  return preload::send(descriptor, name, {message->msg_iov, message->msg_iovlen}, flags,
                       {message->msg_name, message->msg_namelen});
}
