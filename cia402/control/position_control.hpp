#pragma once

#include <cmath>

#include "cia402/base/demand.hpp"

namespace cia402 {

/// The position controller of an axis: proportional, with the velocity of the demand as feed-forward. The drive
/// follows with the next cycle, so the demand of the cycle before is what the actual value is compared with.
class PositionControl {
 public:
  /// Gain (1/s).
  static constexpr double kGain = 50.0;

  /// Position control takes over with the axis at @p position (position units).
  void start(double position) noexcept { demand_ = position; }
  /// Demand and actual value have moved by @p by (position units).
  void shift(double by) noexcept { demand_ += by; }
  /// A cycle with @p demand, the axis being at @p actual at its beginning: velocity for the drive (position
  /// units/s).
  double run(const Demand& demand, double actual) noexcept {
    const double deviation = demand_ - actual;
    demand_ = demand.motion.position;
    return demand.motion.velocity + demand.velocity_offset + kGain * deviation;
  }

 private:
  double demand_ = 0.0;  // of the cycle before
};

/// Whether something has held for a time without a break: windows and monitors (6066h, 6068h, 606Eh, 6070h).
class HoldTimer {
 public:
  /// A cycle in which it @p holds or does not; true if it has for @p milliseconds.
  bool run(bool holds, unsigned milliseconds) noexcept {
    cycles_ = holds ? cycles_ + 1 : 0;
    return holds && cycles_ >= milliseconds;
  }
  void restart() noexcept { cycles_ = 0; }

 private:
  unsigned cycles_ = 0;  // of 1 ms
};

}  // namespace cia402
