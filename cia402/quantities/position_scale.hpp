#pragma once

#include <cstdint>

namespace cia402 {

/// The encoder and the mechanics behind it, as objects say them; all from 1.
struct PositionMechanics {
  std::uint32_t increments = 65536;     ///< 608Fh:1, of a revolution of the motor (608Fh:2 is 1)
  std::uint32_t motor_revolutions = 1;  ///< 6091h:1, gear ratio
  std::uint32_t shaft_revolutions = 1;  ///< 6091h:2, of the driving shaft for those
  std::uint32_t feed = 65536;           ///< 6092h:1, position units
  std::uint32_t feed_revolutions = 1;   ///< 6092h:2, of the driving shaft for those

  friend bool operator==(const PositionMechanics&, const PositionMechanics&) = default;
};

/// What an increment of the encoder is in position units, as a ratio of whole numbers: 6091h:2 · 6092h:1 units are
/// 608Fh:1 · 6091h:1 · 6092h:2 increments. So no number of revolutions makes a position wrong.
class PositionScale {
 public:
  /// Results beyond it stay there: far outside every object.
  static constexpr std::int64_t kFarthest = std::int64_t{1} << 62;

  PositionScale() noexcept : PositionScale{PositionMechanics{}} {}
  explicit PositionScale(const PositionMechanics& mechanics) noexcept;

  /// Whole position units of @p increments; a half is rounded away from zero.
  std::int64_t units(std::int64_t increments) const noexcept;
  /// The same with its fraction; beyond 2^53 units as near as a double is.
  double exact_units(std::int64_t increments) const noexcept;
  /// Whole increments of @p units; a half is rounded away from zero.
  std::int64_t increments(std::int64_t units) const noexcept;
  /// Position units of a revolution of the motor.
  double units_per_revolution() const noexcept { return units_per_revolution_; }

 private:
  __extension__ using Wide = unsigned __int128;

  std::uint64_t units_;  // in increments_, reduced
  Wide increments_;
  double units_per_revolution_;
};

}  // namespace cia402
