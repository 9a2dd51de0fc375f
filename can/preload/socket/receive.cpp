#include "can/preload/socket/receive.hpp"

#include <cerrno>
#include <cstring>

#include "can/preload/down.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/address.hpp"
#include "can/preload/socket/control.hpp"
#include "can/preload/socket/state.hpp"

namespace preload {

namespace {

using userbus::Kind;
using userbus::Name;
using userbus::Trailer;

/// What recv(2)'s flags mean for a CAN socket; the rest would mean something else to the kernel's socket below.
constexpr int kKeptFlags = MSG_DONTWAIT | MSG_PEEK;

/// Whether the message of @p size bytes at @p data tells that the bus is cut.
bool tells_cut(const void* data, ssize_t size) noexcept {
  Trailer trailer{};
  memcpy(&trailer, static_cast<const char*>(data) + size - sizeof trailer, sizeof trailer);
  return (trailer.flags & userbus::kLinkDown) != 0;
}

/// Takes the next message away, which was looked at only.
void drop_message(int descriptor) noexcept {
  char byte = 0;
  iovec part{&byte, sizeof byte};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  next().recvmsg(descriptor, &message, MSG_DONTWAIT);
}

/// Reads a message of the hub, trailer included, into @p room bytes at @p data. -1 with errno.
ssize_t read_message(int descriptor, const Name& name, void* data, size_t room, int flags) noexcept {
  iovec part{data, room};
  for (;;) {
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    const ssize_t size = next().recvmsg(descriptor, &message, flags & kKeptFlags);
    if (size >= static_cast<ssize_t>(sizeof(Trailer))) {
      if (!tells_cut(data, size)) return size;
      if ((flags & MSG_PEEK) != 0) drop_message(descriptor);
      errno = ENETDOWN;
      return -1;
    }
    if (size < 0 && errno == ECONNRESET) continue;  // the hub has gone: first what it left
    if (size < 0) return -1;
    if (size > 0) continue;  // not of our hub
    take_down(descriptor, name);
    errno = ENETDOWN;
    return -1;
  }
}

/// Gives the program the message of @p size bytes at @p data, at the end of which the trailer is.
ssize_t hand_over(const char* data, ssize_t size, const Parts& room, Received& received) noexcept {
  const size_t payload = static_cast<size_t>(size) - sizeof(Trailer);
  memcpy(&received.trailer, data + payload, sizeof(Trailer));
  const size_t given = scatter(data, payload, room);
  received.truncated = given < payload;
  return static_cast<ssize_t>(given);
}

ssize_t receive_frame(int descriptor, const Name& name, const Parts& room, int flags,
                      Received& received) noexcept {
  char data[sizeof(userbus::FrameMessage)];
  const ssize_t size = read_message(descriptor, name, data, sizeof data, flags);
  return size < 0 ? size : hand_over(data, size, room, received);
}

ssize_t receive_broadcast(int descriptor, const Name& name, const Parts& room, int flags,
                          Received& received) noexcept {
  char data[userbus::kLongestMessage];
  const ssize_t size = read_message(descriptor, name, data, sizeof data, flags);
  if (size < 0) return size;
  const ssize_t given = hand_over(data, size, room, received);
  received.truncated = false;  // the kernel's broadcast manager does not tell either
  return given;
}

void add_stamps(ControlData& control, const Stamps& stamps, int64_t time_ns) noexcept {
  constexpr int64_t kSecond = 1'000'000'000;
  constexpr int64_t kMicrosecond = 1000;
  const int single = stamps.single();
  if (single == SO_TIMESTAMP_OLD || single == SO_TIMESTAMP_NEW) {
    const int64_t stamp[] = {time_ns / kSecond, time_ns % kSecond / kMicrosecond};
    control.add(single, stamp, sizeof stamp);
  } else if (single != 0) {
    const int64_t stamp[] = {time_ns / kSecond, time_ns % kSecond};
    control.add(single, stamp, sizeof stamp);
  }
  if (const int stamping = stamps.timestamping(); stamping != 0) {
    const int64_t stamp[6] = {time_ns / kSecond, time_ns % kSecond};  // of software; legacy; of hardware
    control.add(stamping, stamp, sizeof stamp);
  }
}

}  // namespace

ssize_t receive(int descriptor, const Name& name, const Parts& room, int flags, Received& received) noexcept {
  if ((flags & MSG_ERRQUEUE) != 0) {  // nothing is ever in it
    errno = EAGAIN;
    return -1;
  }
  const auto read = name.kind == Kind::BroadcastManager ? receive_broadcast : receive_frame;
  const ssize_t size = read(descriptor, name, room, flags, received);
  if (size >= 0) note_received(descriptor, name, received.trailer.time_ns);
  return size;
}

ssize_t receive_message(int descriptor, const Name& name, msghdr& message, int flags) noexcept {
  Received received{};
  const ssize_t size = receive(descriptor, name, {message.msg_iov, message.msg_iovlen}, flags, received);
  if (size < 0) return size;
  const SocketState state = state_or_default(descriptor, name);
  if (message.msg_name != nullptr)
    give_address(received.trailer.interface_index, message.msg_name, message.msg_namelen);
  ControlData control{message};
  add_stamps(control, state.stamps, received.trailer.time_ns);
  if (state.counts_dropped && received.trailer.dropped != 0)
    control.add(SO_RXQ_OVFL, &received.trailer.dropped, sizeof received.trailer.dropped);
  constexpr unsigned kOrigin = MSG_DONTROUTE | MSG_CONFIRM;
  message.msg_flags =
      static_cast<int>(received.trailer.flags & kOrigin) | control.finish() | (received.truncated ? MSG_TRUNC : 0);
  return size;
}

}  // namespace preload
