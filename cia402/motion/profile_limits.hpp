#pragma once

#include <cstdint>

namespace cia402 {

/// What a positioning may do (position units; s).
struct ProfileLimits {
  double velocity = 0.0;      ///< not negative; 0 holds on the way
  double acceleration = 1.0;  ///< positive
  double deceleration = 1.0;  ///< positive
  double jerk = 0.0;          ///< positive; 0 = not limited: a trapezoid of the velocity

  friend bool operator==(const ProfileLimits&, const ProfileLimits&) = default;
};

/// What the advance of a positioning can stop at.
enum class ProfileEvent : std::uint8_t {
  None,
  Arrived,  ///< came to rest at the target
  Passed,   ///< is at the target and moves; another target is to be given now
};

/// What is left of the time (s), and why.
struct ProfileAdvance {
  double left = 0.0;
  ProfileEvent event = ProfileEvent::None;
};

}  // namespace cia402
