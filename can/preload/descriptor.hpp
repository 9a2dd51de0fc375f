#pragma once

#include "can/userbus/name.hpp"

namespace preload {

/// Whether @p descriptor is a CAN socket; tells by @p name which. Costs a look at one flag while the process has
/// none, else a getsockname(2). Leaves errno alone.
bool is_can(int descriptor, userbus::Name& name) noexcept;

/// From now on the process may have CAN sockets.
void expect_can_sockets() noexcept;

/// Whether the process may have CAN sockets.
bool expects_can_sockets() noexcept;

/// Looks whether @p descriptor, which came from another process, is a CAN socket.
void look_at(int descriptor) noexcept;

/// Looks at all descriptors of the process: those it inherited.
void look_at_all() noexcept;

}  // namespace preload
