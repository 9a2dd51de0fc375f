#pragma once

namespace preload {

// A process that this one starts takes part in the turns from the beginning: its connection is made before it.

/// A connection for a new process, which inherits it; -1 if there is none, and the process joins by itself.
int prepare_child() noexcept;
/// In the parent, when there is the process or none.
void leave_to_child(int socket) noexcept;

/// Joins over @p socket as this process, and waits for the first turn.
void take_part(int socket) noexcept;

/// Has fork(2) do all that, whoever calls it.
void watch_forks() noexcept;

/// Before the process becomes another program by exec: that inherits the connection. Whether there is one.
bool prepare_exec() noexcept;
/// It has stayed what it is.
void resume_after_exec() noexcept;

}  // namespace preload
