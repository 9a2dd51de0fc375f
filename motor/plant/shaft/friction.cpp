#include "motor/plant/shaft/friction.hpp"

namespace motor {

Motion reversed(const Grip& grip, double speed, const Motion& moved, double inverse_inertia, double h) noexcept {
  const double before = (moved.speed - speed) / h;
  const double stops_after = -speed / before;
  const double there = 0.5 * speed * stops_after;
  const double after = before + 2.0 * grip.torque * inverse_inertia;
  if (after * grip.direction >= 0.0) return {0.0, there, std::abs(there)};
  const double left = h - stops_after;
  const double back = 0.5 * after * left * left;
  return {after * left, there + back, std::abs(there) + std::abs(back)};
}

}  // namespace motor
