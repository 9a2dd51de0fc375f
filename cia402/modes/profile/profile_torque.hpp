#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"

namespace cia402 {

/// The objects of profile torque.
struct ProfileTorqueSettings {
  double target = 0.0;       ///< 6071h (N·m)
  double slope = 1.0;        ///< 6087h (N·m/s), positive
  std::int16_t profile = 0;  ///< 6088h: 0 linear, 1 sin²
};

/// Profile torque (6060h = 4; CiA 402-2): follows 6071h along ramps, whenever that was written. Torque limits and
/// the speed cap are those of the control.
class ProfileTorque {
 public:
  /// The ramp begins at the present torque.
  void enter(const Motion& present) noexcept;
  /// The ramp begins anew.
  void resume(const Motion& present) noexcept { enter(present); }
  void leave() noexcept {}
  /// Bit 8 is halt, which is led outside; there is no other bit.
  void controlword(std::uint16_t, std::uint16_t) noexcept {}
  /// The next 1 ms.
  Demand cycle(const ProfileTorqueSettings& settings, const Actual& actual) noexcept;
  /// Bit 10: the torque demand is 6071h, as it is written now.
  ModeBits bits(const ProfileTorqueSettings& settings) const noexcept {
    return {.bit_10 = torque_ == settings.target};
  }

 private:
  void begin(const ProfileTorqueSettings& settings) noexcept;
  double ramped() const noexcept;

  double torque_ = 0.0;   // N·m
  double from_ = 0.0;     // N·m, of the ramp
  double elapsed_ = 0.0;  // s, in it
  ProfileTorqueSettings ramp_{};
};

}  // namespace cia402
