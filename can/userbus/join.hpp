#pragma once

#include "can/userbus/path.hpp"

namespace userbus {

/// Why a bus could not be joined.
enum class JoinError : uint8_t {
  None,
  System,     ///< a system call failed: errno
  Denied,     ///< the path belongs to somebody else, or must not be opened
  Folder,     ///< others may write to the folder of the path (see own_folder())
  InUse,      ///< something at the path is no bus
  NoHub,      ///< the program canhub was not found where it was looked for
  BitRate,    ///< nobody serves the path, and $CAN_BITRATE is no bit rate
  Time,       ///< likewise $CAN_TIME is no time
  Different,  ///< the path is served, but not as $CAN_BITRATE and $CAN_TIME say
  NotServed,  ///< canhub could not serve the path
};

/// Outcome of join(): a descriptor, or -1 and the reason.
struct Joined {
  int descriptor;
  JoinError error;
};

/// Becomes a member of the bus at @p path: connected, named, and greeted by the hub; not bound to an interface
/// yet. If nobody serves the path, the program @p hub (its path) is started to do so, and one whose hub is just
/// closing starts the next, with the bit rate $CAN_BITRATE if that is set; not if @p hub is nullptr. The hub must
/// be is_trusted_user(). @p flags: SOCK_NONBLOCK and SOCK_CLOEXEC as for socket(2).
Joined join(const Path& path, const char* hub, Kind kind, int flags) noexcept;

/// A hub that closes is followed by one of our own; that it should happen more often than this in a row is no
/// race.
inline constexpr int kMostAttempts = 10;

/// What one attempt to connect came to; Closing: to be tried again at once.
enum class Attempt : uint8_t { Connected, NotServed, Closing, Failed };

/// A descriptor, or -1 and what came instead; the error is that of Attempt::Failed.
struct Connected {
  int descriptor;
  Attempt outcome;
  JoinError error;
};

// The steps of join(), for who cannot wait.

/// A socket of @p kind, named and connected to the hub at @p path, which is_trusted_user() and has not been
/// greeted yet. With SOCK_NONBLOCK among @p flags it waits for nothing.
Connected connect_hub(const Path& path, Kind kind, int flags) noexcept;

/// Gives @p descriptor, a member of a bus with @p bit_rate, the queue in the kernel that its frames shall have.
void set_queue(int descriptor, Kind kind, int bit_rate) noexcept;

/// Frames that the queue of a member has in whose turns nothing is read (docs/explanation/bus-time.md). It is
/// ready for more while a quarter of it is taken: for as many as a burst has room for in real time, in this queue
/// and the hub's.
inline constexpr int kQueueOfTurns = 80;
/// Gives @p descriptor, a member of a process that takes turns, a queue of kQueueOfTurns frames.
void set_queue_of_turns(int descriptor) noexcept;

/// How a hub is to serve; nullptr: as the bus is.
struct HubWishes {
  const char* bit_rate = nullptr;  ///< digits as read_bit_rate() takes them
  const char* time = nullptr;      ///< as read_time() takes it
};

/// $CAN_BITRATE and $CAN_TIME as wishes for start_hub(); JoinError::None if they are none or right.
JoinError wanted_hub(HubWishes& wishes) noexcept;

/// What it means for joining that the program canhub ended with @p status, or could not be started for errno @p
/// error.
JoinError error_of(StartStatus status, int error) noexcept;

/// One sentence for @p error, without the path; uses errno for JoinError::System.
const char* text_of(JoinError error) noexcept;

}  // namespace userbus
