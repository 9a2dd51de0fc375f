// getsockopt: what a CAN socket tells a program of itself.
#include <cerrno>
#include <cstring>

#include <linux/can/raw.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/hub.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/options.hpp"

namespace preload {

namespace {

using userbus::Kind;
using userbus::Name;
using userbus::Operation;

/// Where a program wants a value.
struct Room {
  void* data;
  socklen_t* size;  ///< in: of the room; out: of the value
};

/// Gives as much of @p value as there is room for, as the kernel does.
int give(uint32_t value, const Room& room) noexcept {
  if (static_cast<int>(*room.size) < 0) return failed(EINVAL);
  if (*room.size > sizeof value) *room.size = sizeof value;
  memcpy(room.data, &value, *room.size);
  return 0;
}

int give_filters(int descriptor, const Room& room) noexcept {
  can_filter filters[CAN_RAW_FILTER_MAX];
  const userbus::Answer answer = ask(descriptor, Operation::ReadFilters, 0, filters, sizeof filters);
  if (answer.error != 0) return failed(answer.error);
  if (static_cast<int>(*room.size) < 0) return failed(EINVAL);
  const size_t there = *room.size;
  *room.size = static_cast<socklen_t>(answer.size);
  if (there < answer.size) return failed(ERANGE);
  memcpy(room.data, filters, answer.size);
  return 0;
}

int give_raw(int descriptor, int number, const Room& room) noexcept {
  if (number == CAN_RAW_FILTER) return give_filters(descriptor, room);
  const RawOption* const option = raw_option(number);
  if (option == nullptr) return failed(ENOPROTOOPT);
  userbus::MemberState state{};
  const userbus::Answer answer = ask(descriptor, Operation::ReadState, 0, &state, sizeof state);
  if (answer.error != 0) return failed(answer.error);
  return give(state.options[static_cast<size_t>(option->name)], room);
}

/// The error that waits at the kernel's socket. That of a connection whose other end has gone is an interface's
/// that is down.
int give_error(int descriptor, const Room& room) noexcept {
  int error = 0;
  socklen_t size = sizeof error;
  if (next().getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size) != 0) return -1;
  return give(static_cast<uint32_t>(error == ECONNRESET || error == EPIPE ? ENETDOWN : error), room);
}

int give_socket(int descriptor, const Name& name, int number, const Room& room) noexcept {
  const bool raw = name.kind != Kind::BroadcastManager;
  const SocketOption option = socket_option(number);
  switch (option) {
    case SocketOption::Domain:
      return give(AF_CAN, room);
    case SocketOption::Type:
      return give(raw ? SOCK_RAW : SOCK_DGRAM, room);
    case SocketOption::Error:
      return give_error(descriptor, room);
    case SocketOption::Other:
      return next().getsockopt(descriptor, SOL_SOCKET, number, room.data, room.size);
    case SocketOption::SingleStamp:
    case SocketOption::Stamping:
    case SocketOption::CountDropped:
      break;
  }
  SocketState state;
  if (!state_of(descriptor, name, state)) return -1;
  if (option == SocketOption::CountDropped) return give(state.counts_dropped ? 1 : 0, room);
  if (option == SocketOption::Stamping) return give(state.stamps.flags(), room);
  return give(state.stamps.single() == number ? 1 : 0, room);
}

}  // namespace

}  // namespace preload

PRELOAD_EXPORT int getsockopt(int descriptor, int level, int number, void* value, socklen_t* size) noexcept {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name))
    return preload::next().getsockopt(descriptor, level, number, value, size);
  if (level == SOL_SOCKET) return preload::give_socket(descriptor, name, number, {value, size});
  if (name.kind == userbus::Kind::BroadcastManager) return preload::failed(EOPNOTSUPP);
  if (level != SOL_CAN_RAW) return preload::failed(EINVAL);
  if (name.kind == userbus::Kind::Down) return preload::failed(ENETDOWN);
  return preload::give_raw(descriptor, number, {value, size});
}
