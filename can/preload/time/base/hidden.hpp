#pragma once

namespace preload {

// Descriptors of this library, which the program does not see: calls that would close them leave them alone.

/// Moves @p descriptor out of the way of the program, to a great number; closed on exec. Returns its new number.
int hide(int descriptor) noexcept;
/// Closes one.
void close_hidden(int descriptor) noexcept;

/// Whether @p descriptor is one.
bool is_hidden(int descriptor) noexcept;

}  // namespace preload
