#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <linux/can.h>

/// The datagrams of python-can's udp_multicast bus: one MessagePack map a frame. Both functions allocate.
namespace bus::multicast {

/// Longest datagram that is read (bytes). A frame takes some 200; and a map that is nested as deep as it can be
/// must not use up the stack.
inline constexpr std::size_t kLongestDatagram = 1024;

/// The datagram for @p frame, an error frame if CAN_ERR_FLAG is set. Its time stamp is 0: receivers take their
/// own.
[[nodiscard]] std::vector<std::uint8_t> pack(const can_frame& frame);

/// The classical data, remote or error frame (CAN_ERR_FLAG) that @p datagram holds; nothing if it is malformed or
/// a frame of CAN FD.
[[nodiscard]] std::optional<can_frame> unpack(std::span<const std::uint8_t> datagram) noexcept;

}  // namespace bus::multicast
