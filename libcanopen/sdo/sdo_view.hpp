#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "libcanopen/base/export.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace canopen {

/// Where an SDO server finds an object.
enum class ObjectPlace : std::uint8_t { Dictionary, Application, Nowhere };

/// What each SDO server of a node shows: the objects of the dictionary, others, or none. The two directions of an
/// object of the application are asked about whole values of at most eight bytes, in whatever form they travel.
/// Called as an Application is, with the same limits on what may be called from within.
class CANOPEN_EXPORT SdoView {
 public:
  virtual ~SdoView() = default;
  /// Where server @p server (0 for 1200h, 1 for 1201h) finds @p index. Nowhere is answered with NoObject.
  virtual ObjectPlace place_of(std::uint8_t server, std::uint16_t index) const noexcept = 0;
  /// Reads an object of the application: its value to @p value, least significant byte first; returns its size,
  /// 1..8. A transfer shows the value as it was when it began; another size ends it with CannotTransfer.
  virtual Result<std::size_t> read(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                                   std::span<std::uint8_t, 8> value) noexcept = 0;
  /// Writes one: @p value as it came, 1..8 bytes; whether they are the right number is for the application to
  /// judge (LengthMismatch). If @p sized is false, the client has sent four bytes without saying how many of them
  /// count: as many as the object has, unless that is more (CiA 301, 7.2.4.3.3, expedited transfer without size).
  virtual Result<void> write(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                             std::span<const std::uint8_t> value, bool sized) noexcept = 0;
};

}  // namespace canopen
