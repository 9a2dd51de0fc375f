#include "cia402/modes/homing/velocity_ramp.hpp"

#include <cmath>

#include "cia402/base/demand.hpp"

namespace cia402 {

void VelocityRamp::advance(double velocity, const Slopes& slopes) noexcept {
  const bool reverses = velocity * velocity_ < 0.0;
  const bool slows = std::abs(velocity) < std::abs(velocity_);
  double left = kCycle;
  if (reverses) left = run_to(0.0, slopes.deceleration, left);
  left = run_to(velocity, slows && !reverses ? slopes.deceleration : slopes.acceleration, left);
  position_ += velocity_ * left;
}

/// Towards @p velocity for at most @p time (s): what is left of it.
double VelocityRamp::run_to(double velocity, double slope, double time) noexcept {
  const double change = velocity - velocity_;
  const double needed = std::abs(change) / slope;
  const bool arrives = needed <= time;
  const double end = arrives ? velocity : velocity_ + std::copysign(slope * time, change);
  const double spent = arrives ? needed : time;
  position_ += 0.5 * (velocity_ + end) * spent;
  velocity_ = end;
  return time - spent;
}

}  // namespace cia402
