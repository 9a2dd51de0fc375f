#pragma once

#include <cstdint>

namespace drive {

/// A length as whole length units (LU) and what rounding has left of them (-0.5..0.5 LU).
struct Length {
  std::int64_t whole = 0;  ///< LU, a half is rounded away from zero
  double rest = 0.0;       ///< LU

  /// LU.
  constexpr double exact() const noexcept { return static_cast<double>(whole) + rest; }
};

/// The encoder and the mechanics behind it, as parameters say them.
struct LengthMechanics {
  std::uint32_t pulses = 2048;  ///< p0408, of an encoder revolution
  std::uint8_t fine_bits = 11;  ///< p0418
  std::int32_t gear_motor = 1;  ///< p2504, revolutions of the motor, positive
  std::int32_t gear_load = 1;   ///< p2505, revolutions of the load for those; negative: it turns the other way
  std::int32_t units_per_load = 10000;  ///< p2506, LU in a revolution of the load, positive

  friend bool operator==(const LengthMechanics&, const LengthMechanics&) = default;
};

/// What a count of the encoder is in length units, as a ratio of whole numbers: p2506·p2505 LU are
/// p0408·2^p0418·p2504 counts. So no number of revolutions makes a length wrong.
class LengthScale {
 public:
  LengthScale() noexcept : LengthScale{LengthMechanics{}} {}
  explicit LengthScale(const LengthMechanics& mechanics) noexcept;

  /// The length of @p counts. Beyond ±2^61 LU, far outside every range of a parameter, it stays there.
  Length length(std::int64_t counts) const noexcept;
  /// r2524: LU in a revolution of the motor, negative if the load turns the other way.
  double units_per_revolution() const noexcept { return units_per_revolution_; }
  /// Whether @p revolutions of the motor are a whole multiple of @p length (LU, positive).
  bool is_multiple(std::int64_t revolutions, std::int64_t length) const noexcept;

 private:
  std::int64_t units_;   // LU in counts_, reduced
  std::int64_t counts_;  // positive
  std::int64_t per_revolution_;
  double units_per_revolution_;
};

}  // namespace drive
