#pragma once

#include <cstdint>

namespace cia402 {

/// What a fault is on the bus: error code (603Fh, EMCY; CiA 301, table "emergency error code classes", CiA 402-2)
/// and bits of the error register 1001h.
struct ErrorCode {
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;

  friend bool operator==(const ErrorCode&, const ErrorCode&) = default;
};

/// Errors that the axis itself finds.
namespace error {
inline constexpr ErrorCode kFollowingError{0x8611, 0x21};
inline constexpr ErrorCode kSetPointsMissing{0x8700, 0x11};
inline constexpr ErrorCode kConnectionAbort{0x8130, 0x11};
}  // namespace error

/// What a fault or alarm @p number of the drive is.
ErrorCode error_code_of(std::uint16_t number) noexcept;

}  // namespace cia402
