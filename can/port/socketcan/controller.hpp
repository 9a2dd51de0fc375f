#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "can/port/port.hpp"

namespace bus {

/// Whether the kernel's description @p message of an interface (RTM_NEWLINK) is that of a CAN controller, and not
/// of a virtual interface, which has none.
bool describes_controller(std::span<const std::byte> message) noexcept;

/// The request to the kernel to restart the controller of the interface with index @p index from bus-off.
std::array<std::byte, 64> restart_request(int index) noexcept;

/// Brings the controller of the interface with index @p index back from bus-off. A controller that is not off, and
/// an interface without one, can be used at once. Takes a few system calls.
[[nodiscard]] Restart restart_controller(int index) noexcept;

}  // namespace bus
