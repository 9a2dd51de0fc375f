#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/profile/velocity_lead.hpp"

namespace cia402 {

/// The objects of velocity mode, in position units and seconds.
struct VelocitySettings {
  double target = 0.0;      ///< 6042h
  double minimum = 0.0;     ///< 6046h:1, of the amount
  double maximum = 0.0;     ///< 6046h:2, of the amount
  VelocitySlopes slopes{};  ///< 6048h, 6049h
};

/// Bits of the controlword in velocity mode.
struct VelocityBits {
  static constexpr std::uint16_t kEnableRamp = 0x0010;
  static constexpr std::uint16_t kUnlockRamp = 0x0020;
  static constexpr std::uint16_t kReferenceRamp = 0x0040;
};

/// Velocity (vl; 6060h = 2; CiA 402-2): follows 6042h along a ramp. Without reference (bit 6 = 0) the ramp leads
/// to 0, locked (bit 5 = 0) it stays where it is, and not enabled (bit 4 = 0) its output is 0 at once.
class Velocity {
 public:
  /// The ramp begins at the present velocity.
  void enter(const Motion& present) noexcept { lead_.start(present.velocity); }
  /// The ramp begins anew.
  void resume(const Motion& present) noexcept { enter(present); }
  void leave() noexcept {}
  /// The bits act as levels in every cycle.
  void controlword(std::uint16_t, std::uint16_t) noexcept {}
  /// The next 1 ms, with the controlword @p word.
  Demand cycle(std::uint16_t word, const VelocitySettings& settings, const Limits& limits,
               const Actual& actual) noexcept;
  /// This mode has no bits of its own.
  static ModeBits bits() noexcept { return {}; }

 private:
  VelocityLead lead_{};
};

}  // namespace cia402
