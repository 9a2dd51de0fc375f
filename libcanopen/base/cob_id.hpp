#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace canopen {

/// Bits of a COB-ID object (CiA 301, 7.5.2: 1005h, 1014h, 1200h, 1400h, 1800h).
namespace cob_id {
inline constexpr std::uint32_t kInvalid = 1U << 31;       ///< PDO, SDO, EMCY: does not exist
inline constexpr std::uint32_t kNoRemote = 1U << 30;      ///< TPDO: no RTR allowed
inline constexpr std::uint32_t kProduce = 1U << 30;       ///< SYNC: the node produces it
inline constexpr std::uint32_t kIdentifier = 0x7FF;       ///< the 11-bit identifier
inline constexpr std::uint32_t kMustBeZero = 0x3FFFF800;  ///< bits 11..29 of an 11-bit identifier
}  // namespace cob_id

/// Function codes of the generic pre-defined connection set (CiA 301, 7.3.5).
namespace function_code {
inline constexpr std::uint32_t kNmt = 0x000;
inline constexpr std::uint32_t kSync = 0x080;
inline constexpr std::uint32_t kEmcy = 0x080;
inline constexpr std::uint32_t kSdoResponse = 0x580;
inline constexpr std::uint32_t kSdoRequest = 0x600;
inline constexpr std::uint32_t kErrorControl = 0x700;
}  // namespace function_code

/// True for identifiers that no configurable service may use (CiA 301, table "restricted CAN-IDs").
constexpr bool is_restricted(std::uint32_t identifier) noexcept {
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

}  // namespace canopen
