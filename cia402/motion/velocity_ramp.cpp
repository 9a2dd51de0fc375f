#include "cia402/motion/velocity_ramp.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

double ramped(double velocity, double target, const VelocitySlopes& slopes, double dt) noexcept {
  const double direction = std::abs(velocity) > 0.0 ? std::copysign(1.0, velocity) : std::copysign(1.0, target);
  const double speed = std::abs(velocity);
  const double goal = direction * target;
  if (goal >= speed) return direction * std::min(goal, speed + slopes.acceleration * dt);
  const double slowest = std::max(0.0, goal);
  if (speed - slopes.deceleration * dt >= slowest) return direction * (speed - slopes.deceleration * dt);
  if (goal >= 0.0) return target;
  const double left = std::max(0.0, dt - speed / slopes.deceleration);
  return -direction * std::min(-goal, slopes.acceleration * left);
}

}  // namespace cia402
