#pragma once

namespace preload {

/// Whether @p descriptor is a CAN socket, for which the hub gives a turn by itself. Asks the kernel once.
bool is_on_bus(int descriptor) noexcept;
/// Likewise, if that is known already.
bool is_known_on_bus(int descriptor) noexcept;
/// The program closes @p descriptor, or puts another in its place.
void forget_descriptor(int descriptor) noexcept;

}  // namespace preload
