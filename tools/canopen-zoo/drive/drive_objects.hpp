#pragma once

#include <cstdint>
#include <vector>

#include "libcanopen/od/entry_description.hpp"

namespace zoo {

/// The objects of CiA 402-2 that the drive of the zoo has: an axis with 65536 units in a revolution, in the modes
/// profile position, profile velocity and homing.
[[nodiscard]] std::vector<canopen::EntryDescription> drive_objects();

inline constexpr std::int64_t kUnitsOfRevolution = 65536;
inline constexpr std::int64_t kDriveModes = 0x25;        ///< 6502h: 1, 3 and 6
inline constexpr std::int64_t kDriveType = 0x0002'0192;  ///< 1000h: servo drive of CiA 402

/// What the first four PDOs hold by CiA 402-3: for each of RPDO and TPDO the object beside the first, 0 none.
struct DrivePdo {
  std::int64_t first = 0, second = 0;  ///< as a mapping has them
};
/// Those of RPDOs, or of TPDOs, 1 to 4.
[[nodiscard]] std::vector<DrivePdo> drive_pdos(bool transmitted);

}  // namespace zoo
