// socket, bind, connect, close: how a program comes to a CAN socket, and leaves it.
#include <cerrno>
#include <cstring>

#include <linux/can.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/hub.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/address.hpp"
#include "can/preload/socket/state.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/turn/touch.hpp"
#include "can/preload/time/wait/descriptors.hpp"
#include "can/preload/time/wait/timer.hpp"
#include "can/userbus/join.hpp"

namespace preload {

namespace {

constexpr int kTypeFlags = SOCK_NONBLOCK | SOCK_CLOEXEC;

/// A protocol of AF_CAN that there is here.
struct Protocol {
  int number;
  int type;
  userbus::Kind kind;
};

constexpr Protocol kProtocols[] = {
    {CAN_RAW, SOCK_RAW, userbus::Kind::Raw},
    {CAN_BCM, SOCK_DGRAM, userbus::Kind::BroadcastManager},
};

int open_socket(int type, int number) noexcept {
  if (number < 0 || number >= CAN_NPROTO) return failed(EINVAL);
  for (const Protocol& protocol : kProtocols) {
    if (protocol.number != number) continue;
    if ((type & ~kTypeFlags) != protocol.type) return failed(EPROTOTYPE);
    const int descriptor = join_bus(protocol.kind, type & kTypeFlags);
    if (descriptor < 0) return descriptor;
    if (by_turns()) userbus::set_queue_of_turns(descriptor);
    expect_can_sockets();
    return descriptor;
  }
  return failed(EPROTONOSUPPORT);
}

/// Has the hub bind @p descriptor to the interface of @p address.
int bind_to(int descriptor, const sockaddr* address) noexcept {
  if (tell(descriptor, userbus::Operation::Bind, interface_of(address)) != 0) return -1;
  state_has_changed();
  return 0;
}

int bind_raw(int descriptor, const sockaddr* address, socklen_t length) noexcept {
  if (!is_can_address(address, length)) return failed(EINVAL);
  return bind_to(descriptor, address);
}

int connect_broadcast_manager(int descriptor, const userbus::Name& name, const sockaddr* address,
                              socklen_t length) noexcept {
  if (length < kAddressSize) return failed(EINVAL);
  SocketState state;
  if (!state_of(descriptor, name, state)) return -1;
  if (state.interface_index >= 0) return failed(EISCONN);
  return bind_to(descriptor, address);
}

}  // namespace

}  // namespace preload

using preload::next;

PRELOAD_EXPORT int socket(int domain, int type, int protocol) noexcept {
  if (domain != AF_CAN) return next().socket(domain, type, protocol);
  return preload::open_socket(type, protocol);
}

PRELOAD_EXPORT int bind(int descriptor, const sockaddr* address, socklen_t length) noexcept {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name)) return next().bind(descriptor, address, length);
  if (name.kind == userbus::Kind::BroadcastManager) return preload::failed(EOPNOTSUPP);
  if (name.kind == userbus::Kind::Down) return preload::failed(ENETDOWN);
  return preload::bind_raw(descriptor, address, length);
}

PRELOAD_EXPORT int connect(int descriptor, const sockaddr* address, socklen_t length) {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name)) return next().connect(descriptor, address, length);
  if (name.kind != userbus::Kind::BroadcastManager) return preload::failed(EOPNOTSUPP);
  return preload::connect_broadcast_manager(descriptor, name, address, length);
}

PRELOAD_EXPORT int close(int descriptor) {
  if (preload::is_hidden(descriptor)) return preload::failed(EBADF);
  if (preload::expects_can_sockets()) preload::forget(descriptor);
  if (preload::by_turns()) {
    preload::note_closing(descriptor);
    preload::forget_descriptor(descriptor);
    preload::forget_timer(descriptor);
  }
  return next().close(descriptor);
}
