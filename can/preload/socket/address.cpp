#include "can/preload/socket/address.hpp"

#include <cstring>

namespace preload {

bool is_can_address(const void* address, socklen_t length) noexcept {
  if (length < kAddressSize) return false;
  sa_family_t family = AF_UNSPEC;
  memcpy(&family, address, sizeof family);
  return family == AF_CAN;
}

int interface_of(const void* address) noexcept {
  int index = 0;
  memcpy(&index, static_cast<const char*>(address) + offsetof(sockaddr_can, can_ifindex), sizeof index);
  return index;
}

void give_address(int index, void* address, socklen_t& length) noexcept {
  sockaddr_can full{};
  full.can_family = AF_CAN;
  full.can_ifindex = index;
  memcpy(address, &full, length < kAddressSize ? length : kAddressSize);
  length = kAddressSize;
}

}  // namespace preload
