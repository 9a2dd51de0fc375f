// The calls that send: write, writev, send, sendto, sendmsg.
#include "can/preload/calls/exported.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/send.hpp"
#include "can/preload/time/wait/readiness.hpp"

using preload::is_can;
using preload::may_write_out;
using preload::next;

namespace {

constexpr preload::Destination kNoAddress{nullptr, 0};

ssize_t send_data(int descriptor, const userbus::Name& name, const void* data, size_t size, int flags) noexcept {
  const iovec part{const_cast<void*>(data), size};
  return preload::send(descriptor, name, {&part, 1}, flags, kNoAddress);
}

/// To a pipe that is waited for in parts.
ssize_t write_in_parts(int descriptor, const void* data, size_t size, size_t part) noexcept {
  const auto* const bytes = static_cast<const char*>(data);
  size_t done = 0;
  while (done < size) {
    if (done > 0 && !may_write_out(descriptor)) break;
    const ssize_t written = next().write(descriptor, bytes + done, size - done < part ? size - done : part);
    if (written < 0) break;
    done += static_cast<size_t>(written);
  }
  return done > 0 ? static_cast<ssize_t>(done) : -1;
}

ssize_t write_out(int descriptor, const void* data, size_t size) noexcept {
  if (!may_write_out(descriptor)) return -1;
  const size_t part = preload::part_to_write(descriptor, size);
  return part == 0 ? next().write(descriptor, data, size) : write_in_parts(descriptor, data, size, part);
}

}  // namespace

PRELOAD_EXPORT ssize_t write(int descriptor, const void* data, size_t size) {
  userbus::Name name{};
  if (!is_can(descriptor, name)) return write_out(descriptor, data, size);
  return send_data(descriptor, name, data, size, 0);
}

PRELOAD_EXPORT ssize_t writev(int descriptor, const iovec* parts, int count) {
  userbus::Name name{};
  if (count <= 0 || !is_can(descriptor, name))
    return may_write_out(descriptor) ? next().writev(descriptor, parts, count) : -1;
  const preload::Parts all{parts, static_cast<size_t>(count)};
  return preload::size_of(all) == 0 ? 0 : preload::send(descriptor, name, all, 0, kNoAddress);
}

PRELOAD_EXPORT ssize_t send(int descriptor, const void* data, size_t size, int flags) {
  userbus::Name name{};
  if (!is_can(descriptor, name))
    return may_write_out(descriptor, flags) ? next().send(descriptor, data, size, flags) : -1;
  return send_data(descriptor, name, data, size, flags);
}

PRELOAD_EXPORT ssize_t sendto(int descriptor, const void* data, size_t size, int flags, const sockaddr* address,
                              socklen_t length) {
  userbus::Name name{};
  if (!is_can(descriptor, name))
    return may_write_out(descriptor, flags) ? next().sendto(descriptor, data, size, flags, address, length) : -1;
  const iovec part{const_cast<void*>(data), size};
  return preload::send(descriptor, name, {&part, 1}, flags, {address, length});
}

PRELOAD_EXPORT ssize_t sendmsg(int descriptor, const msghdr* message, int flags) {
  userbus::Name name{};
  if (!is_can(descriptor, name))
    return may_write_out(descriptor, flags) ? next().sendmsg(descriptor, message, flags) : -1;
  return preload::send(descriptor, name, {message->msg_iov, message->msg_iovlen}, flags,
                       {message->msg_name, message->msg_namelen});
}
