#pragma once

#include <cstddef>
#include <cstdint>

namespace drive {

class ControlUnit;

/// The firmware that the unit shows (r0018, r0964, 100Ah): V04.80.65.00, two digits each.
inline constexpr std::uint32_t kFirmware = 4'806'500;
/// What lies behind version and subversion has so many values.
inline constexpr std::uint32_t kFirmwarePatches = 10'000;

}  // namespace drive

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
