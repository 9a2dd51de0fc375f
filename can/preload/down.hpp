#pragma once

#include "can/userbus/name.hpp"

namespace preload {

/// Puts a socket of kind Down in the place of @p descriptor, the hub of which has gone: nothing comes to it, as if
/// its interface were down. Does nothing if @p descriptor is not the socket @p name any more.
void take_down(int descriptor, const userbus::Name& name) noexcept;

}  // namespace preload
