#include "drive/positioning/control/position_control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drive {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;
constexpr double kBalancingSlices = 2.0;

/// The share of a step that a first-order lag of @p time (s) has followed after a slice.
double step_share(double time) noexcept {
  return time > 0.0 ? -std::expm1(-PositionControl::kSlice / time) : 1.0;
}

/// @p distance, or on a modulo axis the shortest one.
double shortest(double distance, double modulo_range) noexcept {
  return modulo_range > 0.0 ? distance - modulo_range * std::round(distance / modulo_range) : distance;
}

}  // namespace

double PositionControl::radians(double units) const noexcept {
  const double per_revolution = inputs.units_per_revolution;
  return std::abs(per_revolution) > 0.0 ? units * kRevolution / per_revolution : 0.0;
}

void PositionControl::run(const Slice& slice) noexcept {
  found_ = {};
  requests_tracking_ = slice.requests_tracking;
  const bool before = enabled_;
  enabled_ = inputs.enable_1 && inputs.enable_2 && slice.is_possible;
  if (!enabled_ || !before) rest();
  const double former = setpoint_;
  lead_setpoint();
  if (enabled_) follow_model(former);
  following_error_ = shortest(model_ - inputs.actual_position, slice.modulo_range);
  control(slice.modulo_range);
  watch(slice);
}

/// Without position control the model is where the axis is.
void PositionControl::rest() noexcept {
  past_.fill(inputs.setpoint);
  smoothed_ = setpoint_ = inputs.setpoint;
  model_ = inputs.actual_position;
  integral_ = 0.0;
  standing_ = 0.0;
  position_checked_ = false;
}

/// p2533, and where there is precontrol its balancing by p2535 and p2536.
void PositionControl::lead_setpoint() noexcept {
  smoothed_ += (inputs.setpoint - smoothed_) * step_share(settings.smoothing_time);
  std::move_backward(past_.begin(), past_.end() - 1, past_.end());
  past_.front() = smoothed_;
  if (!(settings.precontrol > 0.0)) {
    setpoint_ = smoothed_;
    return;
  }
  setpoint_ += (delayed() - setpoint_) * step_share(settings.balancing_time);
}

/// The setpoint of p2535 + 2 slices ago, between two of them on the line.
double PositionControl::delayed() const noexcept {
  const double slices = kBalancingSlices + settings.balancing_dead_time;
  const double whole = std::floor(slices);
  const auto place = static_cast<std::size_t>(whole);
  return past_[place] + (past_[place + 1] - past_[place]) * (slices - whole);
}

void PositionControl::control(double modulo_range) noexcept {
  deviation_ = shortest(setpoint_ - inputs.actual_position, modulo_range);
  const double speed = radians(inputs.velocity);
  torque_ = enabled_ ? settings.inertia * (speed - setpoint_speed_) / kSlice : 0.0;
  setpoint_speed_ = speed;
  if (!enabled_) {
    proportional_ = limited_ = precontrol_ = 0.0;
    is_limited_ = false;
    return;
  }
  proportional_ = radians(settings.gain * inputs.gain_share * deviation_);
  const double sum = proportional_ + integral_;
  limited_ = std::clamp(sum, -inputs.output_limit, inputs.output_limit);
  is_limited_ = std::abs(sum) > inputs.output_limit;
  const bool integrates = settings.integral_time > 0.0 && (!is_limited_ || sum * proportional_ < 0.0);
  if (integrates) integral_ += proportional_ * kSlice / settings.integral_time;
  if (!(settings.integral_time > 0.0)) integral_ = 0.0;
  precontrol_ = settings.precontrol * speed;
}

/// An axis that follows at once: dx/dt = Kv·(setpoint - x) + precontrol, over the slice in which the setpoint has
/// come from @p former on a straight line.
void PositionControl::follow_model(double former) noexcept {
  const double gain = settings.gain * inputs.gain_share;
  const double velocity = settings.precontrol * inputs.velocity;
  if (!(gain > 0.0)) {
    model_ += velocity * kSlice;
    return;
  }
  const double ahead = (velocity - (setpoint_ - former) / kSlice) / gain;  // of the setpoint, in the end
  model_ = setpoint_ + ahead + (model_ - former - ahead) * std::exp(-gain * kSlice);
}

void PositionControl::watch(const Slice& slice) noexcept {
  const double error = std::abs(following_error_);
  const double tolerance = settings.following_error_tolerance;
  const bool before = following_;
  following_ = !(tolerance > 0.0) || error <= tolerance;
  const bool stops = inputs.travels_to_fixed_stop;
  found_.following_error = enabled_ && !stops && !following_ && before;
  watch_fixed_stop(slice);
  watch_standstill();
}

/// Function diagram 4025: the stop is where the model has left the axis behind.
void PositionControl::watch_fixed_stop(const Slice& slice) noexcept {
  if (!inputs.travels_to_fixed_stop || !enabled_) {
    fixed_stop_ = stop_left_ = false;
    return;
  }
  if (!fixed_stop_ && std::abs(following_error_) > slice.stop_deviation) {
    fixed_stop_ = true;
    stop_position_ = inputs.actual_position;
  }
  stop_left_ = fixed_stop_ && std::abs(inputs.actual_position - stop_position_) > slice.stop_window;
}

void PositionControl::watch_standstill() noexcept {
  const double distance = std::abs(deviation_);
  const bool in_window = !(settings.positioning_window > 0.0) || distance <= settings.positioning_window;
  in_position_ = inputs.setpoint_fixed && in_window;
  const bool watched = enabled_ && inputs.setpoint_fixed && !inputs.has_task && !inputs.travels_to_fixed_stop;
  if (!watched) {
    standing_ = 0.0;
    position_checked_ = false;
    return;
  }
  const double before = standing_;
  standing_ += kSlice;
  if (!position_checked_ && standing_ >= settings.positioning_time) {
    position_checked_ = true;
    found_.position = !in_window;
  }
  const bool strays = settings.standstill_window > 0.0 && distance > settings.standstill_window;
  found_.standstill = strays && standing_ >= settings.standstill_time && before < standing_;
}

void PositionControl::shift(double by) noexcept {
  for (double& setpoint : past_) setpoint += by;
  smoothed_ += by;
  setpoint_ += by;
  model_ += by;
  stop_position_ += by;
}

void PositionControl::place(double position) noexcept {
  past_.fill(position);
  smoothed_ = setpoint_ = model_ = position;
}

void PositionControl::power_off() noexcept {
  inputs = {};
  enabled_ = fixed_stop_ = stop_left_ = in_position_ = is_limited_ = requests_tracking_ = false;
  proportional_ = integral_ = limited_ = precontrol_ = 0.0;
  rest();
}

std::uint16_t PositionControl::status() const noexcept {
  const auto bit = [](unsigned number, bool set) { return static_cast<unsigned>(set) << number; };
  const bool clamps = inputs.fixed_stop_reached && enabled_;
  return static_cast<std::uint16_t>(bit(3, enabled_) | bit(4, fixed_stop_) | bit(5, stop_left_) |
                                    bit(6, is_limited_) | bit(7, requests_tracking_) | bit(8, clamps));
}

}  // namespace drive
