#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include "can/userbus/protocol.hpp"

namespace userbus {

/// What the name of a member's socket tells.
struct Name {
  Kind kind;
  uint64_t number;  ///< its digits: no two sockets of one machine have the same
};

/// Fills @p address with the name of a new member; returns its length for bind(2).
socklen_t make_name(Kind kind, uint64_t number, sockaddr_un& address) noexcept;

/// Reads a name of @p length bytes (as getsockname(2) or accept(2) gives it); false if it is none of a member.
bool read_name(const sockaddr_un& address, socklen_t length, Name& name) noexcept;

/// Asks the kernel for the name of @p descriptor; false, with errno untouched, if it is no member's.
bool name_of(int descriptor, Name& name) noexcept;

}  // namespace userbus
