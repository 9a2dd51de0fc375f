#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drive/messages/cause.hpp"
#include "drive/speed_messages/target_monitor.hpp"

namespace drive {

/// Messages about the speed: target reached, standstill, overspeed, blocked. All speeds in rad/s.
class SpeedMessages {
 public:
  static constexpr double kAsRampInput = std::numeric_limits<double>::infinity();

  struct Settings {
    using Block = SpeedMessages;

    double threshold_1 = 0.0;              ///< p2141, r2199.1
    double hysteresis_1 = 0.0;             ///< p2142
    double hysteresis_3 = 0.0;             ///< p2150, r2197.3
    double threshold_2 = 0.0;              ///< p2155, r2197.1
    double zero_speed_threshold = 0.0;     ///< p2161, statusword bit 12
    double overspeed_hysteresis = 0.0;     ///< p2162, F07901
    double target_window = 0.0;            ///< p2163, statusword bit 10
    double target_hysteresis = 0.0;        ///< p2164
    double target_off_delay = 0.0;         ///< p2166 (s)
    double target_on_delay = 0.0;          ///< p2167 (s), r2199.4
    double blocked_speed_threshold = 0.0;  ///< p2175, F07900
    double blocked_delay = 0.0;            ///< p2177 (s), F07900
  };
  struct Inputs {
    using Block = SpeedMessages;

    double setpoint = kAsRampInput;  ///< p2151, r1119 if it is infinite

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// What a cycle has come to.
  struct Seen {
    double duration = 0.0;         ///< (s)
    double speed = 0.0;            ///< r0063
    double ramp_input = 0.0;       ///< r1119
    double forward_limit = 0.0;    ///< of the speed
    double backward_limit = 0.0;   ///< not positive
    bool at_torque_limit = false;  ///< although it should turn
  };
  void run(const Seen& seen) noexcept {
    const double setpoint = std::isinf(inputs.setpoint) ? seen.ramp_input : inputs.setpoint;
    target_reached_ = monitor_.update(
        seen.duration, setpoint - seen.speed,
        {settings.target_window, settings.target_hysteresis, settings.target_off_delay, settings.target_on_delay});
    const double speed = std::abs(seen.speed);
    if (speed >= settings.threshold_1)
      reaches_threshold_1_ = true;
    else if (speed < settings.threshold_1 - settings.hysteresis_1)
      reaches_threshold_1_ = false;
    if (seen.speed >= 0.0)
      turns_forward_ = true;
    else if (seen.speed < -settings.hysteresis_3)
      turns_forward_ = false;
    overspeed_ = std::max(seen.speed - seen.forward_limit, seen.backward_limit - seen.speed);
    has_overspeed_ = overspeed_ > settings.overspeed_hysteresis;
    const bool stuck = seen.at_torque_limit && std::abs(seen.speed) < settings.blocked_speed_threshold;
    stuck_ = stuck ? 1.0 : 0.0;
  }
  /// F07900 is there, or not.
  void tell_blocked(bool blocked) noexcept { blocked_ = blocked; }

  bool target_reached() const noexcept { return target_reached_; }  ///< r2197.7
  bool target_kept() const noexcept { return monitor_.is_kept(); }  ///< r2199.4
  /// Whether time alone will change target_kept().
  bool awaits_target() const noexcept { return monitor_.awaits(); }
  bool reaches_threshold_1() const noexcept { return reaches_threshold_1_; }  ///< r2199.1
  bool turns_forward() const noexcept { return turns_forward_; }              ///< r2197.3, or stands
  bool is_blocked() const noexcept { return blocked_; }                       ///< r2198.6
  bool has_overspeed() const noexcept { return has_overspeed_; }              ///< r2197.6
  /// r2199.0: whether @p speed is below p2161.
  bool is_zero(double speed) const noexcept { return std::abs(speed) < settings.zero_speed_threshold; }
  double overspeed() const noexcept { return overspeed_; }  ///< speed beyond its limits, negative within them
  double stuck() const noexcept {
    return stuck_;
  }  ///< 1 = at the torque limit, slower than p2175, but should turn

  Settings settings{};
  Inputs inputs{};

 private:
  TargetMonitor monitor_;
  double overspeed_ = 0.0;
  double stuck_ = 0.0;
  bool has_overspeed_ = false;
  bool target_reached_ = false;
  bool reaches_threshold_1_ = false;
  bool turns_forward_ = true;
  bool blocked_ = false;
};

// clang-format off
template <>
inline constexpr auto causes_of<SpeedMessages> = std::array{
    CauseRow<SpeedMessages>{7900, &SpeedMessages::stuck, Side::Above, cause::kYes, cause::kNone, &SpeedMessages::Settings::blocked_delay, Pulses::On, nullptr, cause::kNone, "p2175, p2177"},
    CauseRow<SpeedMessages>{7901, &SpeedMessages::overspeed, Side::Above, &SpeedMessages::Settings::overspeed_hysteresis, cause::kNone, cause::kAtOnce, Pulses::Any, nullptr, cause::kNone, "p1082, p1083, p1086, p0322 with p2162"},
};
// clang-format on

}  // namespace drive
