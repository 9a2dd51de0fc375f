#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "drive/setpoint_channel/ramp_function_generator.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

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

/// The setpoint behind the ramp that has an input of its own: the position controller leads by it too, faster than
/// the others.
struct SpeedSetpoint2 {
  struct Settings {};
  struct Inputs {
    using Block = SpeedSetpoint2;

    double speed = 0.0;  ///< p1160 (rad/s)

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  Settings settings{};
  Inputs inputs{};
};

/// From the main setpoint to the setpoint of the speed controller: choice and sum of setpoints, inversion,
/// inhibited directions, minimum speed, limits, ramp-function generator, setpoints behind the ramp. All speeds in
/// rad/s.
class SetpointChannel {
 public:
  static constexpr double kAsParameter = std::numeric_limits<double>::infinity();

  struct Settings {
    using Block = SetpointChannel;

    FixedSetpoints fixed{};              ///< p1001 to p1015
    double minimum_speed = 0.0;          ///< p1080
    double maximum_speed = 0.0;          ///< p1082
    double speed_limit_positive = 0.0;   ///< p1083
    double speed_limit_negative = 0.0;   ///< p1086, not positive
    std::int32_t ramp_selection = 0;     ///< p1115: 0 basic, 1 extended with the roundings
    double ramp_up_time = 0.0;           ///< p1120 (s), from zero to p1082
    double ramp_down_time = 0.0;         ///< p1121 (s), from p1082 to zero, also OFF1
    double initial_rounding = 0.0;       ///< p1130 (s)
    double final_rounding = 0.0;         ///< p1131 (s)
    std::int32_t rounding_type = 0;      ///< p1134: 0 continuous, 1 discontinuous
    double off3_ramp_down_time = 0.0;    ///< p1135 (s), 0 = as fast as the torque limit allows
    double off3_initial_rounding = 0.0;  ///< p1136 (s)
    double off3_final_rounding = 0.0;    ///< p1137 (s)
  };
  struct Inputs {
    using Block = SetpointChannel;

    bool fixed_setpoint_bit_0 = false;     ///< p1020
    bool fixed_setpoint_bit_1 = false;     ///< p1021
    bool fixed_setpoint_bit_2 = false;     ///< p1022
    bool fixed_setpoint_bit_3 = false;     ///< p1023
    bool inhibit_negative = false;         ///< p1110
    bool inhibit_positive = false;         ///< p1111
    bool invert_setpoint = false;          ///< p1113
    bool bypass_ramp = false;              ///< p1122
    bool enable_ramp = true;               ///< p1140
    bool continue_ramp = true;             ///< p1141
    bool enable_setpoint = true;           ///< p1142
    bool set_ramp = false;                 ///< p1143
    bool vl_enable_ramp = false;           ///< bit 4 of the controlword, in velocity mode an enable like p1140
    bool vl_unlock_ramp = false;           ///< bit 5, like p1141
    bool vl_reference_ramp = false;        ///< bit 6, like p1142
    double main_setpoint = 0.0;            ///< p1070
    double supplementary_setpoint = 0.0;   ///< p1075
    double forward_limit = kAsParameter;   ///< p1085, p1083 if it is infinite
    double backward_limit = kAsParameter;  ///< p1088, p1086 if it is infinite
    double ramp_setting = 0.0;             ///< p1144
    double speed_setpoint_1 = 0.0;         ///< p1155, behind the ramp
    double speed_setpoint_2 = 0.0;         ///< of SpeedSetpoint2, behind the ramp

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// After a write: takes over ramps and limits, for a motor that turns at @p motor_maximum_speed at the most. Not
  /// @p extended there is nothing in front of the setpoints behind the ramp but the ramps of OFF1 and OFF3,
  /// without rounded ends.
  void configure(double motor_maximum_speed, bool extended = true) noexcept;
  /// A cycle begins with the inputs as they are, which act as effective() has them; in @p velocity_mode bits 4 to
  /// 6 of the controlword are enables. An operator panel that leads gives @p panel (rad/s) as the only setpoint,
  /// and the enables of the ramp.
  void begin_cycle(bool velocity_mode = false, std::optional<double> panel = std::nullopt) noexcept;
  /// The inputs as they act, without those that the function module in force does not have.
  const Inputs& effective() const noexcept { return in_; }
  /// The setpoint that comes in: p1070, or p1155 where there is no extended setpoint channel; that of a panel.
  double incoming() const noexcept {
    return panel_ ? *panel_ : extended_ ? inputs.main_setpoint : inputs.speed_setpoint_1;
  }
  /// Power-off: no input has come yet.
  void power_off() noexcept {
    in_ = inputs = {};
    panel_.reset();
  }

  /// The pulses come on: the ramp goes on from @p speed.
  void start(double speed) noexcept;
  /// The setpoint goes to zero on @p ramp, from @p speed where the motor is not yet as fast as its setpoint.
  void brake(Ramp ramp, double speed) noexcept;
  /// Chooses the setpoint of this cycle, and its limits; where the axis jogs, @p jog leads.
  void choose(std::optional<double> jog) noexcept;
  /// The setpoint goes to zero from @p speed as p8791 = @p option (not negative) says.
  void halt(std::int32_t option, double speed) noexcept;
  /// Time of the ramp of such a halt (s), 0 = none.
  double halt_time(std::int32_t option) const noexcept;
  /// A cycle without setpoint: the ramp goes to zero.
  void follow_zero() noexcept;
  /// A cycle with the setpoint that was chosen.
  void follow() noexcept;
  /// The torque leads: the ramp is where the motor is, at @p speed, so that speed control can take over.
  void track(double speed) noexcept { ramp_generator_.start(speed - behind_); }
  /// A position controller leads with @p speed (rad/s); nothing else counts.
  void follow_position(double speed) noexcept {
    ramp_generator_.start(0.0);
    ramp_ = Ramp::Setpoint;
    target_ = 0.0;
    behind_ = speed;
    moves_ = false;
  }
  /// The setpoint waits at zero, for the holding brake.
  void wait() noexcept { target_ = behind_ = 0.0; }
  /// What begins here is the way of the ramp in this cycle.
  void begin_way() noexcept { output_before_ = ramp_generator_.output(); }
  /// The steps of this cycle come: what has changed of target and slopes leads from now on.
  void plan() noexcept {
    if (moves_) ramp_generator_.lead(target_, slopes_[static_cast<std::size_t>(ramp_)]);
  }
  /// Advances by @p dt (s) and returns total().
  [[gnu::always_inline]] double step(double dt) noexcept {
    if (moves_) ramp_generator_.advance_by(dt);
    return total();
  }
  /// Whether further steps change nothing.
  bool rests() const noexcept { return !moves_ || ramp_generator_.rests(); }
  /// The ramp, to have it where it was again.
  const RampFunctionGenerator& ramp() const noexcept { return ramp_generator_; }
  void set_ramp(const RampFunctionGenerator& ramp) noexcept { ramp_generator_ = ramp; }
  /// The way ends, @p duration (s) later: r1149.
  void end_way(double duration) noexcept {
    mean_acceleration_ = (ramp_generator_.output() - output_before_) / duration;
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
  /// r1149, mean of the last cycle (rad/s²).
  double mean_acceleration() const noexcept { return mean_acceleration_; }
  /// Slope of the ramp now (rad/s²).
  double acceleration() const noexcept { return moves_ ? ramp_generator_.acceleration() : 0.0; }
  double forward_limit() const noexcept { return forward_; }
  double backward_limit() const noexcept { return backward_; }  ///< not positive

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  double limited(double setpoint) const noexcept;
  void lead_ramp() noexcept;
  void limit() noexcept;
  void leave_module_out() noexcept;
  void follow_panel(double speed) noexcept;

  // Follows from the parameters.
  std::array<RampSlopes, kRampCount> slopes_{};
  double maximum_ = 0.0;
  bool extended_ = true;

  Inputs in_{};
  std::optional<double> panel_;  // setpoint of an operator panel that leads
  Ramp ramp_ = Ramp::Setpoint;
  bool moves_ = true;
  double forward_ = 0.0;
  double backward_ = 0.0;
  double fixed_setpoint_ = 0.0;
  double sum_ = 0.0;
  double directed_ = 0.0;
  double target_ = 0.0;
  double behind_ = 0.0;         // p1155 and p1160
  double output_before_ = 0.0;  // of the ramp, at the beginning of its way
  double mean_acceleration_ = 0.0;
  RampFunctionGenerator ramp_generator_;
};

}  // namespace drive
