#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/cyclic/set_point_clock.hpp"

namespace cia402 {

/// Cyclic synchronous torque mode (cst): the torque demand is the set-point, at once. The speed cap is held by the
/// torque control, and software limits do not act.
///
/// Where a controlword and a set-point come together, enter(), resume() and controlword() are called before
/// set_point().
class CyclicTorque {
 public:
  /// Becomes active in Operation enabled, or operation gets enabled, with @p word in force: goes on with the
  /// torque of
  /// @p present; without motion and torque it holds the position, until a set-point comes.
  void enter(const Motion& present, std::uint16_t word) noexcept;
  /// A halt is released, and the axis at rest at @p present: it holds the position until a set-point comes.
  void resume(const Motion& present) noexcept;
  /// Operation disabled, fault, other mode.
  void leave() noexcept;
  /// A write of 6040h. From a halt (bit 8) on set-points are ignored, until resume().
  void controlword(std::uint16_t word) noexcept;
  /// @p torque (6071h; N·m) at @p instant of the running cycle; 60B2h is added to it.
  void set_point(double torque, const Offsets& offsets, TimeNs instant, const CyclicSettings& settings) noexcept;
  /// To the end of the cycle; not called while a halt or another stop brakes.
  Demand cycle(const CyclicSettings& settings, const Actual& actual) noexcept;
  /// At the end of the last cycle, or at the set-point that came after it.
  Demand demand() const noexcept;

  /// Bit 12: follows the set-points.
  ModeBits bits() const noexcept;
  /// Too many set-points in a row are missing (8700h).
  bool is_lost() const noexcept { return is_lost_; }

 private:
  void begin(const Motion& present, bool holds_position) noexcept;
  void advance(TimeNs until, const CyclicSettings& settings) noexcept;
  void lead_to(double torque, const CyclicSettings& settings) noexcept;

  SetPointClock clock_{};
  Motion demand_{};
  TimeNs now_{};         // in the running cycle
  double wanted_ = 0.0;  // N·m, before its limits
  bool holds_position_ = true;
  bool is_active_ = false;
  bool is_halted_ = false;
  bool is_limited_ = false;
  bool is_lost_ = false;
};

}  // namespace cia402
