#include "cia402/axis/mode_settings.hpp"

#include <algorithm>
#include <limits>

#include "cia402/quantities/position_range.hpp"

namespace cia402 {
namespace {

/// 607Dh, where it is in force: its limits in order, and not both at the ends of their type.
std::optional<Span> software_limits(const AxisValues& values) noexcept {
  return range_in_force(values.software_limit_minimum.get(), values.software_limit_maximum.get());
}

/// A slope in rpm as 6048h and 6049h say it, by the scale of the axis (units/s²).
double vl_slope(const Scaling& scaling, std::uint32_t speed, std::uint16_t time) noexcept {
  return scaling.units_of_rpm(static_cast<double>(speed)) / std::max<double>(time, 1.0);
}

}  // namespace

Limits limits_of(const AxisValues& values, const Scaling& scaling, bool homed) noexcept {
  const double motor = scaling.units_of_rpm(values.max_motor_speed.get());
  Limits limits{.velocity = std::min<double>(values.max_profile_velocity.get(), motor),
                .acceleration = static_cast<double>(values.max_acceleration.get()),
                .deceleration = static_cast<double>(values.max_deceleration.get()),
                .software = homed ? software_limits(values) : std::nullopt,
                .range = range_in_force(values.position_range_minimum.get(), values.position_range_maximum.get())};
  if (limits.range && limits.software &&
      limits.software->high - limits.software->low > limits.range->high - limits.range->low)
    limits.software.reset();
  return limits;
}

OptionCodes option_codes_of(const AxisValues& values) noexcept {
  return {.quick_stop = values.quick_stop_option.get(),
          .shutdown = values.shutdown_option.get(),
          .disable_operation = values.disable_operation_option.get(),
          .halt = values.halt_option.get(),
          .fault_reaction = values.fault_reaction_option.get()};
}

Span torque_limits_of(const AxisValues& values, const Scaling& scaling) noexcept {
  const auto both = std::min(values.max_torque.get(), values.max_current.get());
  return {-scaling.torque().physical(std::min(both, values.negative_torque_limit.get())),
          scaling.torque().physical(std::min(both, values.positive_torque_limit.get()))};
}

ProfilePositionSettings profile_position_of(const AxisValues& values) noexcept {
  const std::uint32_t window = values.position_window.get();
  return {.target = static_cast<double>(values.target_position.get()),
          .velocity = static_cast<double>(values.profile_velocity.get()),
          .end_velocity = static_cast<double>(values.end_velocity.get()),
          .acceleration = static_cast<double>(values.profile_acceleration.get()),
          .deceleration = static_cast<double>(values.profile_deceleration.get()),
          .motion_profile = values.motion_profile_type.get(),
          .jerk = static_cast<double>(values.profile_jerk.get()),
          .option_code = values.positioning_option.get(),
          .position_window = window == kNoWindow ? std::nullopt : std::optional{static_cast<double>(window)},
          .window_time = values.position_window_time.get()};
}

ProfileVelocitySettings profile_velocity_of(const AxisValues& values, const Scaling& scaling) noexcept {
  return {.target = scaling.velocity(values.target_velocity.get()),
          .acceleration = static_cast<double>(values.profile_acceleration.get()),
          .deceleration = static_cast<double>(values.profile_deceleration.get()),
          .window = static_cast<double>(values.velocity_window.get()),
          .window_time = values.velocity_window_time.get(),
          .threshold = static_cast<double>(values.velocity_threshold.get()),
          .threshold_time = values.velocity_threshold_time.get()};
}

ProfileTorqueSettings profile_torque_of(const AxisValues& values, const Scaling& scaling) noexcept {
  const Span limits = torque_limits_of(values, scaling);
  return {.target = std::clamp(scaling.torque().physical(values.target_torque.get()), limits.low, limits.high),
          .slope = scaling.torque().physical(values.torque_slope.get()),
          .profile = values.torque_profile_type.get()};
}

VelocitySettings velocity_of(const AxisValues& values, const Scaling& scaling) noexcept {
  return {.target = scaling.velocity(scaling.units_of_rpm(values.vl_target_velocity.get())),
          .minimum = scaling.units_of_rpm(values.vl_minimum.get()),
          .maximum = scaling.units_of_rpm(values.vl_maximum.get()),
          .slopes = {.acceleration =
                         vl_slope(scaling, values.vl_acceleration_speed.get(), values.vl_acceleration_time.get()),
                     .deceleration = vl_slope(scaling, values.vl_deceleration_speed.get(),
                                              values.vl_deceleration_time.get())}};
}

HomingSettings homing_of(const AxisValues& values, double longest_search) noexcept {
  return {.method = values.homing_method.get(),
          .switch_speed = static_cast<double>(values.homing_switch_speed.get()),
          .zero_speed = static_cast<double>(values.homing_zero_speed.get()),
          .acceleration = static_cast<double>(values.homing_acceleration.get()),
          .deceleration = static_cast<double>(values.profile_deceleration.get()),
          .offset = static_cast<double>(values.home_offset.get()),
          .longest_search = longest_search};
}

CyclicSettings cyclic_of(const AxisValues& values, const Scaling& scaling, std::uint32_t missed_set_points,
                         bool is_supervised) noexcept {
  return {.period = interpolation_period(values.interpolation_time.get(), values.interpolation_time_index.get()),
          .deceleration = static_cast<double>(values.profile_deceleration.get()),
          .quick_stop_deceleration = static_cast<double>(values.quick_stop_deceleration.get()),
          .torque_slope = scaling.torque().physical(values.torque_slope.get()),
          .torque = torque_limits_of(values, scaling),
          .missed_set_points = missed_set_points,
          .is_supervised = is_supervised,
          .position_window = static_cast<double>(values.position_window.get()),
          .position_window_time = std::chrono::milliseconds{values.position_window_time.get()}};
}

Offsets offsets_of(const AxisValues& values, const Scaling& scaling) noexcept {
  return {.position = static_cast<double>(values.position_offset.get()),
          .velocity = scaling.velocity(values.velocity_offset.get()),
          .torque = scaling.torque().physical(values.torque_offset.get())};
}

}  // namespace cia402
