#include "motor/plant/shaft/load_torque.hpp"

#include <algorithm>

namespace motor {
namespace {

/// Steps are counted, so a point that falls on a step is met up to rounding (s).
constexpr double kSameTime = 1e-9;

}  // namespace

ProfileTorque::Line ProfileTorque::at(double time) noexcept {
  const std::size_t count = profile_.count;
  const double length = profile_.points[count - 1].time;
  if (profile_.repeats && length > 0.0) {
    while (time - lap_start_ >= length - kSameTime) {
      lap_start_ = static_cast<double>(++laps_) * length;
      next_ = 0;
    }
  }
  const double now = time - lap_start_ + kSameTime;
  while (next_ < count && now >= profile_.points[next_].time) ++next_;
  if (next_ == count) return {profile_.points[count - 1].torque, 0.0};
  if (next_ == 0) return {profile_.points[0].torque, 0.0};
  const TorqueProfile::Point& from = profile_.points[next_ - 1];
  const TorqueProfile::Point& to = profile_.points[next_];
  const double slope = (to.torque - from.torque) / (to.time - from.time);
  return {from.torque + slope * (time - lap_start_ - from.time), slope};
}

EndStopTorque::Push EndStopTorque::at(double angle, double speed) const noexcept {
  const double above = angle - stops_.upper;
  const double below = angle - stops_.lower;
  if (above <= 0.0 && below >= 0.0) return {};
  const double spring = stops_.stiffness * (above > 0.0 ? above : below);
  const double total = spring + stops_.damping * speed;
  return {spring, above > 0.0 ? std::max(total, 0.0) : std::min(total, 0.0)};
}

double EndStopTorque::stored(double angle) const noexcept {
  const double into = std::max({angle - stops_.upper, stops_.lower - angle, 0.0});
  return 0.5 * stops_.stiffness * into * into;
}

}  // namespace motor
