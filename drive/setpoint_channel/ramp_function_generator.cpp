#include "drive/setpoint_channel/ramp_function_generator.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

constexpr double kRoundingError =
    1e-9;  // s, of the sum of the steps, so that a ramp of n steps ends with the n-th

/// Change of the output while the slope goes between @p low and @p high, with @p time (s) for each rad/s² of it.
double change_between(double low, double high, double time) noexcept {
  return 0.5 * (high * high - low * low) * time;
}

/// 1/time, 0 for a jump of the slope, which takes no part of its own.
double jerk_of(double time) noexcept {
  return time > 0.0 ? 1.0 / time : 0.0;
}

}  // namespace

void RampFunctionGenerator::go_on(double dt) noexcept {
  for (double left = dt; left > 0.0 && part_ < count_;) left -= advance(left);
}

/// The slope that holds where the output is.
double RampFunctionGenerator::slope_limit() const noexcept {
  const bool towards_zero = output_ * target_ < 0.0 || std::abs(target_) < std::abs(output_);
  return towards_zero ? slopes_.down : slopes_.up;
}

void RampFunctionGenerator::plan() noexcept {
  // A step ends at the target, or at zero, from where the other slope leads on.
  while (std::isinf(slope_limit()) && std::abs(target_ - output_) > 0.0) {
    output_ = output_ * target_ < 0.0 ? 0.0 : target_;
    acceleration_ = 0.0;
  }
  part_ = count_ = 0;
  time_ = 0.0;
  start_output_ = output_;
  if (std::abs(target_ - output_) > 0.0 || std::abs(acceleration_) > 0.0) plan_towards(slope_limit());
  if (count_ == 0) return finish();
  acceleration_ = parts_[0].slope;
}

/// Parts to the target with at most @p slope (rad/s², positive and finite).
void RampFunctionGenerator::plan_towards(double slope) noexcept {
  const double build = slopes_.initial_rounding / slope;  // s for each rad/s²
  const double vanish = slopes_.final_rounding / slope;
  double change = target_ - output_;
  double stopping = std::copysign(change_between(0.0, acceleration_, vanish), acceleration_);
  if (slopes_.type == RoundingType::Discontinuous &&
      (acceleration_ * change < 0.0 || std::abs(stopping) > std::abs(change)))
    acceleration_ = stopping = 0.0;
  const double direction = change < stopping ? -1.0 : 1.0;
  change *= direction;
  double at = acceleration_ * direction;
  const auto go = [&](double to, double time) {
    add({direction * at, direction * std::copysign(jerk_of(time), to - at), std::abs(to - at) * time});
    at = to;
  };
  if (at < 0.0) {
    change += change_between(0.0, at, vanish);
    go(0.0, vanish);
  } else if (at > slope) {
    change -= change_between(slope, at, vanish);
    go(slope, vanish);
  }
  change = std::max(0.0, change);
  const double rounded = change_between(at, slope, build) + change_between(0.0, slope, vanish);
  const bool full = rounded <= change;
  const double peak =
      full ? slope : std::max(at, std::sqrt(2.0 * (change + change_between(0.0, at, build)) / (build + vanish)));
  go(peak, build);
  if (full) add({direction * slope, 0.0, (change - rounded) / slope});
  go(0.0, vanish);
}

void RampFunctionGenerator::add(const Part& part) noexcept {
  if (part.duration > 0.0) parts_[count_++] = part;
}

/// Goes on for @p time (s) or to the end of the part, to zero where the slope changes there; returns the time
/// taken.
double RampFunctionGenerator::advance(double time) noexcept {
  const Part& part = parts_[part_];
  const double rest = part.duration - time_;
  const double taken = std::min(time, rest);
  const bool ends = taken + kRoundingError >= rest;
  const double t = ends ? part.duration : time_ + taken;
  const double reached = start_output_ + t * (part.slope + 0.5 * t * part.jerk);
  const bool crosses = output_ * target_ < 0.0 && reached * target_ >= 0.0;
  if (crosses && (slopes_.up < slopes_.down || slopes_.up > slopes_.down)) {
    const double until = std::clamp(time_to_zero(), 0.0, taken);
    output_ = 0.0;
    acceleration_ += until * part.jerk;
    plan();
    return until;
  }
  output_ = reached;
  acceleration_ = part.slope + t * part.jerk;
  time_ = t;
  if (!ends) return taken;
  time_ = 0.0;
  start_output_ = output_;
  if (++part_ == count_)
    finish();
  else
    acceleration_ = parts_[part_].slope;
  return taken;
}

/// When the part that runs brings the output to zero (s from now).
double RampFunctionGenerator::time_to_zero() const noexcept {
  const double way = std::abs(output_);
  const double direction = -std::copysign(1.0, output_);
  const double slope = direction * acceleration_;
  const double jerk = direction * parts_[part_].jerk;
  return 2.0 * way / (slope + std::sqrt(std::max(0.0, slope * slope + 2.0 * jerk * way)));
}

/// At the target, where nothing is left to do.
void RampFunctionGenerator::finish() noexcept {
  output_ = target_;
  acceleration_ = 0.0;
  part_ = count_ = 0;
}

}  // namespace drive
