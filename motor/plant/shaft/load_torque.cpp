#include "motor/plant/shaft/load_torque.hpp"

namespace motor {
namespace {

/// Steps are counted, so a point that falls on a step is met up to rounding (s).
constexpr double kSameTime = 1e-9;

}  // namespace

TorqueLine ProfileTorque::line_at(double time) noexcept {
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

}  // namespace motor
