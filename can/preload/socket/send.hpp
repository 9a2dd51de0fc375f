#pragma once

#include <sys/socket.h>

#include "can/preload/socket/parts.hpp"
#include "can/userbus/name.hpp"

namespace preload {

/// The address that a program gives with a message; nullptr: none.
struct Destination {
  const void* address;
  socklen_t length;
};

/// Sends what is in @p parts from CAN socket @p name at @p descriptor: a frame, or for the broadcast manager a
/// message. Returns its bytes, or -1 with errno; never raises SIGPIPE. @p flags as for send(2).
ssize_t send(int descriptor, const userbus::Name& name, const Parts& parts, int flags,
             const Destination& to) noexcept;

}  // namespace preload
