#pragma once

#include <cstddef>

#include "can/userbus/protocol.hpp"

namespace userbus {

/// True for what a CAN interface is called: lower-case letters with "can" in them, then digits (vcan0, can1,
/// slcan12); 15 characters at most. Such names are the hub's.
constexpr bool is_can_name(const char* name, size_t size) noexcept {
  if (size >= sizeof InterfaceEntry::name) return false;
  size_t at = 0;
  bool can = false;
  for (; at < size && name[at] >= 'a' && name[at] <= 'z'; ++at)
    can = can || (at >= 2 && name[at - 2] == 'c' && name[at - 1] == 'a' && name[at] == 'n');
  if (at == size) return false;
  for (; at < size && name[at] >= '0' && name[at] <= '9'; ++at) continue;
  return can && at == size;
}

}  // namespace userbus
