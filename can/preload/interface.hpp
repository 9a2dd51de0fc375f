#pragma once

#include <net/if.h>

#include "can/preload/next.hpp"

namespace preload {

/// Index of the hub's first interface.
inline constexpr int kFirstIndex = 1001;

/// Whether a name is one that the hub gives an index to: that of a CAN.
bool is_can_interface(const char* name) noexcept;

/// The hub's index of @p name, asked through CAN socket @p member, or through one of its own if that is -1. 0,
/// with errno, if there is none.
int index_of_interface(const char* name, int member) noexcept;

/// Writes the name of the hub's interface @p index, asked likewise; false, with errno, if there is none.
bool name_of_interface(int index, int member, char (&name)[IF_NAMESIZE]) noexcept;

}  // namespace preload
