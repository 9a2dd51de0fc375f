#pragma once

#include "can/preload/socket/parts.hpp"
#include "can/userbus/name.hpp"

namespace preload {

/// What came with a message.
struct Received {
  userbus::Trailer trailer;
  bool truncated;  ///< there was less room than the message needed
};

/// Receives one message of CAN socket @p name at @p descriptor into @p room; nothing behind what is returned is
/// written to. Returns its bytes, or -1 with errno: ENETDOWN once if the hub has gone. @p flags as for recv(2).
ssize_t receive(int descriptor, const userbus::Name& name, const Parts& room, int flags,
                Received& received) noexcept;

/// The same for recvmsg(2): with address, control data and flags.
ssize_t receive_message(int descriptor, const userbus::Name& name, msghdr& message, int flags) noexcept;

}  // namespace preload
