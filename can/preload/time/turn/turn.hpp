#pragma once

#include <cstdint>

#include "can/userbus/time.hpp"

namespace preload {

// The turns of this process, which its threads have in common. All is under the TimeLock but the notes.

/// From now on the process takes turns over @p socket, a member of kind Clock that has joined.
void use_turn_socket(int socket) noexcept;
/// That socket; -1: there is none.
int turn_socket() noexcept;
/// Whose process it is; another one has been forked behind the library's back.
int turn_process() noexcept;

/// Whether the process has the turn.
bool has_turn() noexcept;
/// Takes the turn that has come, or waits for it: the present is that of the turn.
userbus::TurnOutcome begin_turn(bool waits) noexcept;
/// Where the thread that waits for the turn is best woken, for userbus::begin_stay().
int processor_of_turns() noexcept;
/// Ends the turn: there is nothing to do before @p until. False if the hub has gone.
bool end_turn(int64_t until) noexcept;
/// Asks for a turn, as something from outside has happened.
void want_turn() noexcept;
/// Before something that the hub, or another process, is to do at the present: makes the hub know that, by a turn
/// that ends and another. To be called without the TimeLock.
void tell_present() noexcept;
/// Whether this process has the turn, and it is this process that asks: none that was forked unseen.
bool acts() noexcept;

/// Whether the process may go on to @p instant by itself.
bool may_go_on_to(int64_t instant) noexcept;
/// Whether a child has ended since this was asked last.
bool take_child_ended() noexcept;

/// A frame has been sent: the hub has to know before time goes on.
void note_sent() noexcept;
/// Something has been done that other processes may find.
void note_touched() noexcept;

}  // namespace preload
