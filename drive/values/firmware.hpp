#pragma once

#include <cstdint>

namespace drive {

/// The firmware that the unit shows (r0018, r0964, 100Ah): V04.80.65.00, two digits each.
inline constexpr std::uint32_t kFirmware = 4'806'500;
/// What lies behind version and subversion has so many values.
inline constexpr std::uint32_t kFirmwarePatches = 10'000;

}  // namespace drive
