#pragma once

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "can/userbus/time.hpp"

namespace preload {

/// Becomes a member of the process's present bus (userbus::default_path); @p flags as for userbus::join. -1 with
/// errno, and the first time a line on standard error, if that fails.
int join_bus(userbus::Kind kind, int flags) noexcept;

/// The same for a short question, quietly, and only if somebody serves the bus already.
int join_served_bus() noexcept;

/// Becomes a member of kind Clock of the process's present bus, for @p process (0: one that is to be started,
/// which inherits the descriptor). -1, with a line on standard error the first time, if that fails.
int join_time(int process) noexcept;

/// Says once in a process why the bus does not do what it is to do: "libcan-preload: the CAN bus PATH REASON".
void report_bus(const char* reason) noexcept;

// userbus::ask for the calls of a program, whose threads cannot be cancelled meanwhile.

/// Tells the hub something that needs no answer but success. Returns 0, or -1 with errno.
int tell(int descriptor, userbus::Operation operation, int value, const void* payload = nullptr,
         size_t size = 0) noexcept;

/// Asks by a value, for a value or for a payload, which is stored in @p room bytes at @p reply.
userbus::Answer ask(int descriptor, userbus::Operation operation, int value = 0, void* reply = nullptr,
                    size_t room = 0) noexcept;

/// Asks for a descriptor, which becomes the caller's: stored at @p passed, -1 if none came.
userbus::Answer ask_for_descriptor(int descriptor, userbus::Operation operation, int& passed) noexcept;

/// Asks by a text of @p size bytes, for a value.
userbus::Answer ask_about(int descriptor, userbus::Operation operation, const char* text, size_t size) noexcept;

}  // namespace preload
