#pragma once

#include <cstddef>

namespace drive {
class ControlUnit;
}

/// What parameters show of the control unit.
namespace drive::unit_value {

/// r0002.
double operating_display(const ControlUnit& unit, std::size_t index) noexcept;
/// r0102.
double object_count(const ControlUnit& unit, std::size_t index) noexcept;
/// r8743: the drive object behind CANopen module @p index; 0 = none.
double module_object(const ControlUnit& unit, std::size_t index) noexcept;
/// r8935.
double mac_address(const ControlUnit& unit, std::size_t index) noexcept;

}  // namespace drive::unit_value
