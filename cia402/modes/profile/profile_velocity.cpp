#include "cia402/modes/profile/profile_velocity.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

void ProfileVelocity::enter(const Motion& present) noexcept {
  lead_.start(present.velocity);
  in_window_.restart();
  above_threshold_.satisfy();
  actual_velocity_ = present.velocity;
  is_reached_ = false;
  is_zero_ = !(std::abs(present.velocity) > 0.0);
}

Demand ProfileVelocity::cycle(const ProfileVelocitySettings& settings, const Limits& limits,
                              const Actual& actual) noexcept {
  const VelocitySlopes slopes{.acceleration = std::min(settings.acceleration, limits.acceleration),
                              .deceleration = std::min(settings.deceleration, limits.deceleration)};
  const Demand demand = lead_.cycle(settings.target, slopes, limits, actual);
  actual_velocity_ = actual.velocity;
  is_reached_ =
      in_window_.update(std::abs(actual.velocity - settings.target) <= settings.window, settings.window_time);
  is_zero_ = !above_threshold_.update(std::abs(actual.velocity) > settings.threshold, settings.threshold_time);
  return demand;
}

ModeBits ProfileVelocity::bits(const ProfileVelocitySettings& settings) const noexcept {
  const bool inside = std::abs(actual_velocity_ - settings.target) <= settings.window;
  return {.bit_10 = is_reached_ && inside, .bit_12 = is_zero_};
}

}  // namespace cia402
