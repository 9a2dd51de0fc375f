#pragma once

#include <cstdint>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/pdo/mapping.hpp"

namespace canopen {

/// Sub-indices of a PDO communication record (CiA 301, 7.5.2.35 and 7.5.2.37).
namespace pdo_sub {
inline constexpr std::uint8_t kCobId = 1;
inline constexpr std::uint8_t kTransmissionType = 2;
inline constexpr std::uint8_t kInhibitTime = 3;
inline constexpr std::uint8_t kEventTimer = 5;
inline constexpr std::uint8_t kSyncStart = 6;
}  // namespace pdo_sub

/// Highest synchronous transmission type (CiA 301, tables "RPDO transmission types", "TPDO transmission types").
inline constexpr std::uint8_t kLastSynchronousType = 0xF0;

/// Whether sub-index 0 of a mapping counts the entries by itself (Policy::count_follows_entries).
enum class MappingCount : std::uint8_t {
  Follows,  ///< with every entry that is written
  Zero,     ///< 0 was written to it: entries do not count before it is written again (CiA 301, 7.5.2.36)
  Awaited,  ///< as Zero, but entries were written since: they count when the PDO becomes valid
};

/// What is in force of one PDO.
struct PdoSettings {
  Identifier identifier = 0;  ///< 0 while the PDO is not valid
  std::uint16_t number = 0;   ///< 0 for 1400h or 1800h
  std::uint8_t transmission_type = 0;
  bool remote_allowed = false;  ///< TPDO: remote frames are answered
  MappingCount mapping_count = MappingCount::Follows;
  MappingPlan plan{};

  bool is_valid() const noexcept { return identifier != 0; }
  /// Valid and with something mapped; a PDO without mapping is disabled (CiA 301, 7.5.2.36).
  bool is_active() const noexcept { return is_valid() && plan.length() != 0; }
  /// A TPDO that remote frames may ask for (bit 30 of its COB-ID).
  bool is_requestable() const noexcept { return is_active() && remote_allowed; }
};

}  // namespace canopen
