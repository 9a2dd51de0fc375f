#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drive/axis_inputs.hpp"
#include "drive/parameters.hpp"
#include "drive/ramp_function_generator.hpp"

namespace drive {

/// The ramps that the setpoint can follow.
enum class Ramp : std::uint8_t {
  Setpoint,     ///< p1120 up, p1121 down
  Off1,         ///< p1121
  Off3,         ///< p1135
  TorqueLimit,  ///< a step
};
inline constexpr std::size_t kRampCount = 4;

/// Fixed setpoints p1001 to p1015 (rad/s); number 0 is no setpoint.
using FixedSetpoints = std::array<double, 16>;

/// From the main setpoint to the setpoint of the speed controller: choice and sum of setpoints, inversion,
/// inhibited directions, minimum speed, limits, ramp-function generator, setpoints behind the ramp. All speeds in
/// rad/s.
class SetpointChannel {
 public:
  /// Takes over ramps and limits. Not @p extended there is nothing in front of the setpoints behind the ramp but
  /// the ramps of OFF1 and OFF3, without rounded ends.
  void configure(const AxisParameters& parameters, const FixedSetpoints& fixed, bool extended = true) noexcept;

  /// The pulses come on: the ramp goes on from @p speed.
  void start(double speed) noexcept;
  /// The setpoint goes to zero on @p ramp, from @p speed where the motor is not yet as fast as its setpoint.
  void brake(Ramp ramp, double speed) noexcept;
  /// Chooses the setpoint of this cycle from @p inputs, of which @p jogs lets p1058 and p1059 lead.
  void choose(const AxisInputs& inputs, bool jogs) noexcept;
  /// A cycle without setpoint: the ramp goes to zero.
  void follow_zero() noexcept;
  /// A cycle with the setpoint that was chosen from @p inputs.
  void follow(const AxisInputs& inputs) noexcept;
  /// The torque leads: the ramp is where the motor is, at @p speed, so that speed control can take over.
  void track(double speed) noexcept { ramp_generator_.start(speed - behind_); }
  /// The setpoint waits at zero, for the holding brake.
  void wait() noexcept { target_ = behind_ = 0.0; }
  /// Limits of this cycle (before follow()).
  void limit(const AxisInputs& inputs) noexcept;
  /// Advances by @p dt (s) and returns total().
  double step(double dt) noexcept {
    if (moves_) ramp_generator_.step(dt, target_, slopes_[static_cast<std::size_t>(ramp_)]);
    return total();
  }

  double fixed_setpoint() const noexcept { return fixed_setpoint_; }   ///< r1024
  double sum() const noexcept { return sum_; }                         ///< r1078, in front of inversion and limits
  double directed() const noexcept { return directed_; }               ///< r1114, behind the inhibited directions
  double input() const noexcept { return target_; }                    ///< r1119
  double output() const noexcept { return ramp_generator_.output(); }  ///< r1150
  /// r1170, behind the ramp and within the limits.
  double total() const noexcept {
    const double sum = ramp_generator_.output() + behind_;
    return sum > forward_ ? forward_ : sum < backward_ ? backward_ : sum;
  }
  /// Slope of the ramp now (rad/s²).
  double acceleration() const noexcept { return moves_ ? ramp_generator_.acceleration() : 0.0; }
  double forward_limit() const noexcept { return forward_; }
  double backward_limit() const noexcept { return backward_; }  ///< not positive

 private:
  double jog_setpoint(const AxisInputs& inputs) const noexcept;
  double limited(double setpoint) const noexcept;
  void lead_ramp(const AxisInputs& inputs) noexcept;

  // Follows from the parameters.
  std::array<RampSlopes, kRampCount> slopes_{};
  FixedSetpoints fixed_{};
  double maximum_ = 0.0;
  double minimum_ = 0.0;
  double positive_ = 0.0;
  double negative_ = 0.0;
  std::array<double, 2> jog_{};

  Ramp ramp_ = Ramp::Setpoint;
  bool moves_ = true;
  double forward_ = 0.0;
  double backward_ = 0.0;
  double fixed_setpoint_ = 0.0;
  double sum_ = 0.0;
  double directed_ = 0.0;
  double target_ = 0.0;
  double behind_ = 0.0;  // p1155 and p1160
  RampFunctionGenerator ramp_generator_;
};

}  // namespace drive
