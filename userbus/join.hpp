#pragma once

#include "userbus/path.hpp"

namespace userbus {

/// Why a bus could not be joined.
enum class JoinError : uint8_t {
  None,
  System,     ///< a system call failed: errno
  Denied,     ///< the path belongs to somebody else, or must not be opened
  InUse,      ///< something at the path is no bus
  NoHub,      ///< the program canhub was not found where it was looked for
  BitRate,    ///< nobody serves the path, and $CAN_BITRATE is no bit rate
  NotServed,  ///< canhub could not serve the path
};

/// Outcome of join(): a descriptor, or -1 and the reason.
struct Joined {
  int descriptor;
  JoinError error;
};

/// Becomes a member of the bus at @p path: connected, named, and greeted by the hub; not bound to an interface
/// yet. If nobody serves the path, the program @p hub (its path) is started to do so, and one whose hub is just
/// closing starts the next, with the bit rate $CAN_BITRATE if that is set; not if @p hub is nullptr. @p flags:
/// SOCK_NONBLOCK and SOCK_CLOEXEC as for socket(2).
Joined join(const Path& path, const char* hub, Kind kind, int flags) noexcept;

/// One sentence for @p error, without the path; uses errno for JoinError::System.
const char* text_of(JoinError error) noexcept;

}  // namespace userbus
