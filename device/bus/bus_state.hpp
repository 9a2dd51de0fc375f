#pragma once

#include <cstdint>

namespace device {

/// Error state of the CAN controller (ISO 11898-1), as far as the unit tells it apart.
enum class BusState : std::uint8_t { Active, Passive, Off };

}  // namespace device
