#pragma once

#include <csignal>
#include <cstddef>
#include <cstdint>

namespace preload {

// Before a call that may block: waits by turns until it will not. True: make the call. False with errno: EINTR, or
// EAGAIN if the limit of time of the socket is over. True at once for a process that does not live by turns.

/// Before reading from @p descriptor; @p flags as for recv(2).
bool may_read(int descriptor, int flags = 0) noexcept;
/// Before writing to @p descriptor; @p flags as for send(2).
bool may_write(int descriptor, int flags = 0) noexcept;

/// Before a program writes to @p descriptor, which is no CAN socket; notes what others may find.
/// @p flags as for send(2).
bool may_write_out(int descriptor, int flags = 0) noexcept;
/// How much of @p size bytes goes to @p descriptor without waiting in the kernel, when may_write_out() has said
/// so; 0: all, or as much as there is room for.
size_t part_to_write(int descriptor, size_t size) noexcept;

/// Whether a call that can be made again is to be made again after a signal, as SA_RESTART says.
bool restarts_after_signal() noexcept;

}  // namespace preload
