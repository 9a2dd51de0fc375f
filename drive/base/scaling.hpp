#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "drive/base/references.hpp"
#include "drive/base/units.hpp"

namespace drive {

/// The nearest integer of type @p Int, saturating at its ends.
template <class Int>
Int saturated(double value) noexcept {
  constexpr auto kLow = static_cast<double>(std::numeric_limits<Int>::min());
  constexpr auto kHigh = static_cast<double>(std::numeric_limits<Int>::max());
  constexpr double kHalf = 0.5;
  const double bounded = std::clamp(value, kLow, kHigh);
  return static_cast<Int>(bounded + (bounded < 0.0 ? -kHalf : kHalf));  // which cuts off
}

/// 6094h: speeds on the bus are multiplied by the numerator and divided by the denominator.
struct SpeedFactor {
  double numerator = 1.0;    ///< p8798[0]
  double denominator = 1.0;  ///< p8798[1]
};

/// Speeds and accelerations on the bus, in increments of the encoder, or in rpm of an axis without one; torques
/// relative to the rated one.
class BusScaling {
 public:
  /// Rated torque and, with @p has_encoder, encoder from @p references.
  explicit BusScaling(const References& references, const SpeedFactor& factor = {},
                      bool has_encoder = true) noexcept
      : per_radian_{(has_encoder ? increments_per_radian(references) : 1.0 / kRpm) * factor.denominator /
                    factor.numerator},
        per_newton_metre_{1000.0 / references.rated_torque} {}

  /// What 60FFh has for one rad/s.
  double per_radian() const noexcept { return per_radian_; }
  /// 60FFh (increments/s or rpm) in rad/s.
  double speed_from_bus(std::int32_t bus) const noexcept { return static_cast<double>(bus) / per_radian_; }
  /// Speed (rad/s) as 60FFh, 606Bh or 606Ch show it (increments/s).
  std::int32_t speed_to_bus(double speed) const noexcept { return saturated<std::int32_t>(speed * per_radian_); }

  /// 6071h (per mille of the rated torque) in N·m.
  double torque_from_bus(std::int16_t bus) const noexcept { return static_cast<double>(bus) / per_newton_metre_; }
  /// Torque (N·m) as 6071h, 6074h or 6077h show it (per mille of the rated torque).
  std::int16_t torque_to_bus(double torque) const noexcept {
    return saturated<std::int16_t>(torque * per_newton_metre_);
  }

  /// Slope of a ramp of @p time (s) from @p maximum_speed (rad/s) as 6083h..6085h show it (increments/s²); a ramp
  /// of no time reads FFFFFFFFh.
  std::uint32_t slope_to_bus(double maximum_speed, double time) const noexcept {
    if (!(time > 0.0)) return kNoRamp;
    return saturated<std::uint32_t>(maximum_speed * per_radian_ / time);
  }
  /// Ramp time (s) for 6083h..6085h (increments/s²), clipped to 0..@p longest (s). Zero never arrives and has no
  /// answer; FFFFFFFFh is a step, so that what was read can be written back.
  std::optional<double> ramp_time_from_bus(std::uint32_t bus, double maximum_speed,
                                           double longest) const noexcept {
    if (bus == 0) return std::nullopt;
    if (bus == kNoRamp) return 0.0;
    return std::clamp(maximum_speed * per_radian_ / static_cast<double>(bus), 0.0, longest);
  }

 private:
  static constexpr std::uint32_t kNoRamp = 0xFFFFFFFF;

  static double increments_per_radian(const References& references) noexcept {
    return static_cast<double>(references.encoder_pulses) *
           static_cast<double>(std::uint64_t{1} << references.encoder_fine_bits) / (2.0 * std::numbers::pi);
  }

  double per_radian_;        // bus increments a radian
  double per_newton_metre_;  // per mille a newton metre
};

}  // namespace drive
