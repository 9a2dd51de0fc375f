#include "can/preload/socket/send.hpp"

#include <cerrno>

#include <fcntl.h>
#include <linux/can.h>
#include <linux/can/bcm.h>
#include <poll.h>
#include <sys/time.h>

#include "can/preload/hub.hpp"
#include "can/preload/interface.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/address.hpp"
#include "can/preload/socket/state.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

using userbus::Kind;
using userbus::Name;
using userbus::Trailer;

ssize_t failed(int error) noexcept {
  errno = error;
  return -1;
}

bool exists(int index, int descriptor) noexcept {
  char name[IF_NAMESIZE];
  return index > 0 && name_of_interface(index, descriptor, name);
}

/// What the failure of the kernel's socket below means on a CAN: a queue that is full does not make one wait, it
/// is ENOBUFS. A limit of time for sending that is over stays EAGAIN.
int can_error(int error, int descriptor, bool waited) noexcept {
  if (error == EPIPE || error == ECONNRESET || error == ENOTCONN) return ENETDOWN;
  if (error != EAGAIN) return error;
  const bool timed_out = waited && (fcntl(descriptor, F_GETFL) & O_NONBLOCK) == 0;
  return timed_out ? EAGAIN : ENOBUFS;
}

/// The limit of time for sending of @p descriptor as poll(2) takes it (ms); -1: none.
int send_limit(int descriptor) noexcept {
  constexpr long kMillisecondsInSecond = 1000;
  constexpr long kMicrosecondsInMillisecond = 1000;
  timeval limit{};
  socklen_t size = sizeof limit;
  if (next().getsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &limit, &size) != 0) return -1;
  if (limit.tv_sec == 0 && limit.tv_usec == 0) return -1;
  return static_cast<int>(limit.tv_sec * kMillisecondsInSecond + limit.tv_usec / kMicrosecondsInMillisecond);
}

/// A virtual CAN passes a frame while it is sent, so that its socket is writable again afterwards, and programs
/// rely on that: they poll without waiting before each frame of a burst. The hub takes frames a little later. So a
/// socket that may wait does it behind its frame, until the hub has made room for the next one.
void wait_for_room(int descriptor) noexcept {
  const int error = errno;
  pollfd room{descriptor, POLLOUT, 0};
  if (poll(&room, 1, 0) == 0 && (fcntl(descriptor, F_GETFL) & O_NONBLOCK) == 0)
    poll(&room, 1, send_limit(descriptor));
  errno = error;
}

/// Sends @p frame to interface @p index; 0: to that which the socket is bound to.
ssize_t send_to_hub(int descriptor, can_frame& frame, int index, bool wait) noexcept {
  Trailer trailer{};
  trailer.interface_index = index;
  if (by_turns()) trailer.time_ns = present();
  iovec parts[] = {{&frame, sizeof frame}, {&trailer, sizeof trailer}};
  msghdr message{};
  message.msg_iov = parts;
  message.msg_iovlen = index == 0 && trailer.time_ns == 0 ? 1 : 2;
  const ssize_t size = next().sendmsg(descriptor, &message, MSG_NOSIGNAL | (wait ? 0 : MSG_DONTWAIT));
  if (size < 0) return failed(can_error(errno, descriptor, wait));
  if (by_turns()) note_sent();
  if (wait) wait_for_room(descriptor);
  return sizeof frame;
}

ssize_t send_frame(int descriptor, const Name& name, const Parts& parts, int flags,
                   const Destination& to) noexcept {
  int index = 0;
  if (to.address != nullptr) {
    if (!is_can_address(to.address, to.length)) return failed(EINVAL);
    index = interface_of(to.address);
  }
  SocketState state;
  if (!state_of(descriptor, name, state)) return -1;
  if (to.address == nullptr ? state.interface_index <= 0 : !exists(index, descriptor)) return failed(ENXIO);
  can_frame frame{};
  if (size_of(parts) != sizeof frame) return failed(EINVAL);
  gather(parts, &frame, sizeof frame);
  if (frame.can_dlc > CAN_MAX_DLEN) return failed(EINVAL);
  if (state.is_cut()) return failed(ENETDOWN);
  return send_to_hub(descriptor, frame, index, (flags & MSG_DONTWAIT) == 0 && !state.has_queue());
}

ssize_t send_broadcast(int descriptor, const Name& name, const Parts& parts, const Destination& to) noexcept {
  SocketState state;
  if (!state_of(descriptor, name, state)) return -1;
  if (state.interface_index < 0) return failed(ENOTCONN);
  char message[userbus::kLongestMessage - sizeof(userbus::Request)];
  const size_t size = size_of(parts);
  if (size < sizeof(bcm_msg_head) || size > sizeof message) return failed(EINVAL);
  int index = 0;
  if (state.interface_index == 0 && to.address != nullptr) {
    if (!is_can_address(to.address, to.length)) return failed(EINVAL);
    index = interface_of(to.address);
    if (index != 0 && !exists(index, descriptor)) return failed(ENODEV);
  }
  gather(parts, message, sizeof message);
  tell_present();
  if (by_turns()) note_sent();
  if (tell(descriptor, userbus::Operation::Broadcast, index, message, size) != 0) return -1;
  return static_cast<ssize_t>(size);
}

}  // namespace

ssize_t send(int descriptor, const Name& name, const Parts& parts, int flags, const Destination& to) noexcept {
  switch (name.kind) {
    case Kind::Raw:
      return send_frame(descriptor, name, parts, flags, to);
    case Kind::BroadcastManager:
      return send_broadcast(descriptor, name, parts, to);
    case Kind::Port:  // never recognised as ours
    case Kind::Clock:
    case Kind::Down:
      return failed(ENETDOWN);
  }
  return failed(ENETDOWN);
}

}  // namespace preload
