#pragma once

#include <cstdint>

#include "cia402/base/limits.hpp"

namespace cia402 {

/// Polarity (607Eh): which values masters see with the other sign. It is its own inverse: the same leads from an
/// object to the axis and back.
class Polarity {
 public:
  explicit constexpr Polarity(std::uint8_t value) noexcept
      : inverts_position_{(value & kPositionBit) != 0}, inverts_velocity_{(value & kVelocityBit) != 0} {}

  /// A position (607Ah, 6064h, 607Ch), in whole units or with a fraction.
  template <class Number>
  constexpr Number position(Number value) const noexcept {
    return inverts_position_ ? -value : value;
  }
  /// A velocity (60FFh, 606Ch, 60B1h).
  template <class Number>
  constexpr Number velocity(Number value) const noexcept {
    return inverts_velocity_ ? -value : value;
  }
  /// Limits (607Bh, 607Dh): with the other sign they change places.
  constexpr Span positions(const Span& span) const noexcept {
    return inverts_position_ ? Span{-span.high, -span.low} : span;
  }

 private:
  static constexpr unsigned kPositionBit = 0x80;
  static constexpr unsigned kVelocityBit = 0x40;

  bool inverts_position_;
  bool inverts_velocity_;
};

}  // namespace cia402
