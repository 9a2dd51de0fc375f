#pragma once

#include <cstddef>

#include <linux/can.h>
#include <sys/socket.h>

namespace preload {

/// Bytes of an address that CAN_RAW and CAN_BCM need and give: family and interface.
inline constexpr socklen_t kAddressSize = offsetof(sockaddr_can, can_ifindex) + sizeof(int);
static_assert(kAddressSize == 8);

/// Whether @p length bytes at @p address name a CAN interface.
bool is_can_address(const void* address, socklen_t length) noexcept;

/// The interface index in @p address.
int interface_of(const void* address) noexcept;

/// Gives a program the address of interface @p index: as much of it as fits in @p length bytes, which becomes what
/// it would have needed.
void give_address(int index, void* address, socklen_t& length) noexcept;

}  // namespace preload
