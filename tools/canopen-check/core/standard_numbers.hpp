#pragma once

#include <cstdint>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/object_index.hpp"

/// Indices and identifiers that the communication profile fixes, as checks name them.
namespace conformance {

namespace function_code = canopen::function_code;
namespace object = canopen::object;

/// Where the profile objects of logical devices lie (CiA 301, table 40): 6000h to 67FFh are those of the first.
inline constexpr std::uint16_t kFirstAxis = 0x6000, kAxisDistance = 0x800, kEndOfAxes = 0xA000;

}  // namespace conformance
