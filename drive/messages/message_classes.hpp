#pragma once

#include <cstdint>

#include "drive/messages/fault_table.hpp"

namespace drive {

/// The bit of r3113 that message @p number sets, as the classes of messages of the list manual have it.
std::uint16_t namur_bit(std::uint16_t number) noexcept;

/// The bit of r2135 that message @p number sets while it is of @p kind: 12 and 14 of the motor, 13 and 15 of the
/// power unit, 12 and 13 as a fault, 14 and 15 as an alarm; 0 if it is not about heat.
std::uint16_t thermal_bit(std::uint16_t number, Kind kind) noexcept;

}  // namespace drive
