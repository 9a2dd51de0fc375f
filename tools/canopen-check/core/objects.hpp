#pragma once

#include <cstdint>

#include "libcanopen/base/cob_id.hpp"

namespace conformance {

namespace cob_id = canopen::cob_id;
namespace function_code = canopen::function_code;

// Objects of the communication profile (CiA 301, 7.5.2) that more than one group of checks works with.
inline constexpr std::uint16_t kDeviceType = 0x1000, kErrorRegister = 0x1001, kCobIdSync = 0x1005,
                               kCyclePeriod = 0x1006, kFirstName = 0x1008, kLastName = 0x100A, kGuardTime = 0x100C,
                               kLifeTimeFactor = 0x100D, kStore = 0x1010, kRestore = 0x1011, kCobIdEmcy = 0x1014,
                               kConsumers = 0x1016, kHeartbeatTime = 0x1017, kIdentity = 0x1018,
                               kSyncOverflow = 0x1019;
/// CiA 301 reserves it: no node has it.
inline constexpr std::uint16_t kReserved = 0x1004;

// PDO parameters: communication parameters of RPDOs and TPDOs, each followed by the mappings 200h further on.
inline constexpr std::uint16_t kFirstRpdo = 0x1400, kFirstTpdo = 0x1800, kMostPdos = 512, kMappingOffset = 0x200;

/// True for communication parameters and mappings of PDOs.
[[nodiscard]] constexpr bool belongs_to_pdo(std::uint16_t index) noexcept {
  return index >= kFirstRpdo && index < 0x1C00;
}

/// Object @p index as it is numbered for the first axis: those of CiA 402 are 800h apart (6000h to 9FFFh).
[[nodiscard]] constexpr std::uint16_t of_first_axis(std::uint16_t index) noexcept {
  constexpr std::uint16_t kFirst = 0x6000, kEnd = 0xA000, kDistance = 0x800;
  if (index < kFirst || index >= kEnd) return index;
  return static_cast<std::uint16_t>(kFirst + (index - kFirst) % kDistance);
}

/// The NMT state in an answer of node guarding, whose highest bit is the toggle bit.
inline constexpr std::uint8_t kStateBits = 0x7F;

}  // namespace conformance
