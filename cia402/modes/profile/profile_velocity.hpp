#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/profile/velocity_lead.hpp"
#include "cia402/motion/window.hpp"

namespace cia402 {

/// The objects of profile velocity, in position units and seconds.
struct ProfileVelocitySettings {
  double target = 0.0;               ///< 60FFh
  double acceleration = 1.0;         ///< 6083h
  double deceleration = 1.0;         ///< 6084h
  double window = 0.0;               ///< 606Dh
  std::uint16_t window_time = 0;     ///< 606Eh (ms)
  double threshold = 0.0;            ///< 606Fh
  std::uint16_t threshold_time = 0;  ///< 6070h (ms)
};

/// Profile velocity (6060h = 3; CiA 402-2): follows 60FFh along ramps, whenever that was written.
class ProfileVelocity {
 public:
  /// The ramp begins at the present velocity.
  void enter(const Motion& present) noexcept;
  /// The ramp begins anew.
  void resume(const Motion& present) noexcept { enter(present); }
  void leave() noexcept {}
  /// Bit 8 is halt, which is led outside; there is no other bit.
  void controlword(std::uint16_t, std::uint16_t) noexcept {}
  /// The next 1 ms.
  Demand cycle(const ProfileVelocitySettings& settings, const Limits& limits, const Actual& actual) noexcept;
  /// Bit 10: the actual velocity is in the window around 60FFh, as it is written now; bit 12: speed zero, until
  /// the velocity has been above the threshold for its time.
  ModeBits bits(const ProfileVelocitySettings& settings) const noexcept;

 private:
  VelocityLead lead_{};
  Window in_window_{};
  Window above_threshold_{};
  double actual_velocity_ = 0.0;
  bool is_reached_ = false;
  bool is_zero_ = true;
};

}  // namespace cia402
