#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/cyclic/set_point_clock.hpp"
#include "cia402/modes/cyclic/set_point_line.hpp"

namespace cia402 {

/// Cyclic synchronous velocity mode (csv): the velocity demand runs on a straight line to the set-point, arriving
/// after T. Towards a software limit it is no higher than 6085h can bring to rest there.
///
/// Where a controlword and a set-point come together, enter(), resume() and controlword() are called before
/// set_point().
class CyclicVelocity {
 public:
  /// Becomes active in Operation enabled, or operation gets enabled, with @p word in force: goes on with the
  /// velocity of @p present, or holds its position if that is 0, until a set-point comes.
  void enter(const Motion& present, std::uint16_t word) noexcept;
  /// A halt is released, and the axis at rest at @p present.
  void resume(const Motion& present) noexcept;
  /// Operation disabled, fault, other mode.
  void leave() noexcept;
  /// A write of 6040h. From a halt (bit 8) on set-points are ignored, until resume().
  void controlword(std::uint16_t word) noexcept;
  /// @p velocity (60FFh; position units/s) at @p instant of the running cycle; 60B1h is added to it.
  void set_point(double velocity, const Offsets& offsets, TimeNs instant, const CyclicSettings& settings,
                 const Limits& limits) noexcept;
  /// To the end of the cycle; not called while a halt or another stop brakes.
  Demand cycle(const CyclicSettings& settings, const Limits& limits, const Actual& actual) noexcept;
  /// At the end of the last cycle, or at the set-point that came after it.
  Demand demand() const noexcept;

  /// Bit 12: follows the set-points.
  ModeBits bits() const noexcept;
  /// Too many set-points in a row are missing (8700h).
  bool is_lost() const noexcept { return is_lost_; }

 private:
  void advance(TimeNs until, const CyclicSettings& settings, const Limits& limits) noexcept;
  void lead_to(double velocity, const Limits& limits) noexcept;

  SetPointClock clock_{};
  SetPointLine line_{};
  Motion demand_{};
  Span towards_limits_{-kEndless, kEndless};  // what 6085h can bring to rest within them
  Offsets offsets_{};
  TimeNs now_{};  // in the running cycle
  bool holds_position_ = true;
  bool is_active_ = false;
  bool is_halted_ = false;
  bool is_limited_ = false;
  bool is_lost_ = false;
};

}  // namespace cia402
