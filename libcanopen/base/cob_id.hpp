#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "libcanopen/base/frame.hpp"

namespace canopen {

/// Bits of a COB-ID object (CiA 301, 7.5.2: 1005h, 1012h, 1014h, 1200h, 1400h, 1800h).
namespace cob_id {
inline constexpr std::uint32_t kInvalid = 1U << 31;       ///< PDO, SDO, EMCY: does not exist
inline constexpr std::uint32_t kConsume = 1U << 31;       ///< TIME: the node consumes it
inline constexpr std::uint32_t kNoRemote = 1U << 30;      ///< TPDO: no RTR allowed
inline constexpr std::uint32_t kProduce = 1U << 30;       ///< SYNC, TIME: the node produces it
inline constexpr std::uint32_t kDynamic = 1U << 30;       ///< SDO: assigned while running, lost with a reset
inline constexpr std::uint32_t kExtended = 1U << 29;      ///< 29-bit identifier
inline constexpr std::uint32_t kBase = 0x7FF;             ///< bits of an 11-bit identifier
inline constexpr std::uint32_t kLong = 0x1FFFFFFF;        ///< bits of a 29-bit identifier
inline constexpr std::uint32_t kMustBeZero = 0x1FFFF800;  ///< bits 11..28 of an 11-bit identifier
}  // namespace cob_id

/// An identifier within the library: bits 0..10, or bits 0..28 with cob_id::kExtended. 0 is NMT's own and means
/// "none" everywhere else.
using Identifier = std::uint32_t;

/// The identifier in the lower 30 bits of a COB-ID.
constexpr Identifier identifier_in(std::uint32_t word) noexcept {
  return (word & cob_id::kExtended) != 0 ? word & (cob_id::kLong | cob_id::kExtended) : word & cob_id::kBase;
}

/// The identifier of an EMCY, SDO or PDO COB-ID; 0 if bit 31 says that it does not exist.
constexpr Identifier valid_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) != 0 ? 0 : identifier_in(cob_id);
}

/// The identifier under which @p frame travels.
constexpr Identifier identifier_of(const Frame& frame) noexcept {
  return frame.extended ? frame.id | cob_id::kExtended : frame.id;
}

/// An empty data frame of @p length bytes under @p identifier.
constexpr Frame frame_under(Identifier identifier, std::uint8_t length) noexcept {
  return {.id = identifier & cob_id::kLong, .length = length, .extended = (identifier & cob_id::kExtended) != 0};
}

/// Function codes of the generic pre-defined connection set (CiA 301, 7.3.5).
namespace function_code {
inline constexpr std::uint32_t kNmt = 0x000;
inline constexpr std::uint32_t kSync = 0x080;
inline constexpr std::uint32_t kEmcy = 0x080;
inline constexpr std::uint32_t kTime = 0x100;
inline constexpr std::uint32_t kSdoResponse = 0x580;
inline constexpr std::uint32_t kSdoRequest = 0x600;
inline constexpr std::uint32_t kErrorControl = 0x700;
}  // namespace function_code

/// True for identifiers that no configurable service may use (CiA 301, table "restricted CAN-IDs").
constexpr bool is_restricted(Identifier identifier) noexcept {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr std::array kRestricted{
      Range{0x000, 0x000}, Range{0x001, 0x07F}, Range{0x101, 0x180}, Range{0x581, 0x5FF},
      Range{0x601, 0x67F}, Range{0x6E0, 0x6FF}, Range{0x701, 0x77F}, Range{0x780, 0x7FF},
  };
  return std::any_of(kRestricted.begin(), kRestricted.end(),
                     [=](Range r) { return identifier >= r.first && identifier <= r.last; });
}

/// True if the lower 30 bits of @p word name an identifier that a configurable service may take: not restricted,
/// no stray bits, and 11 bits long unless @p extended_allowed.
constexpr bool is_assignable(std::uint32_t word, bool extended_allowed) noexcept {
  if ((word & cob_id::kExtended) != 0) return extended_allowed;
  return (word & cob_id::kMustBeZero) == 0 && !is_restricted(word & cob_id::kBase);
}

}  // namespace canopen
