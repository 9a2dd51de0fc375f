#pragma once

#include <sys/types.h>

namespace userbus {

/// Whether a process of @p user may be hub or member where this process takes part: this process's own user, root,
/// and whom $CAN_BUS_USER names (a number). Root trusts no other hub unasked: it could read and forge what root's
/// programs say.
bool is_trusted_user(uid_t user) noexcept;

/// Whether the process at the other end of @p descriptor, as the kernel knows it (SO_PEERCRED), is of such a user.
bool is_trusted_peer(int descriptor) noexcept;

}  // namespace userbus
