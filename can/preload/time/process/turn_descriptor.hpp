#pragma once

namespace preload {

/// Moves @p socket out of the way of the program, to a great number; closed on exec. Returns its new number.
int hide(int socket) noexcept;

/// Joins over @p socket as this process, and waits for the first turn.
void take_part(int socket) noexcept;

/// Whether @p descriptor is one that the program must not touch, as it is this library's.
bool is_hidden(int descriptor) noexcept;

}  // namespace preload
