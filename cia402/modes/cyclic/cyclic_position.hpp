#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/cyclic/position_interpolation.hpp"

namespace cia402 {

/// Cyclic synchronous position mode (csp).
///
/// Where a controlword and a set-point come together, enter(), resume() and controlword() are called before
/// set_point(); so the set-point counts.
class CyclicPosition {
 public:
  /// Becomes active in Operation enabled, or operation gets enabled, with @p word in force: a motion is braked
  /// with 6084h, then the position is held until a set-point comes.
  void enter(const Motion& present, std::uint16_t word) noexcept;
  /// A halt is released, and the axis at rest at @p present.
  void resume(const Motion& present) noexcept;
  /// Operation disabled, fault, other mode.
  void leave() noexcept;
  /// A write of 6040h. From a halt (bit 8) on set-points are ignored, until resume().
  void controlword(std::uint16_t word) noexcept;
  /// @p position (607Ah; position units) at @p instant of the running cycle.
  void set_point(double position, const Offsets& offsets, TimeNs instant, const CyclicSettings& settings,
                 const Limits& limits) noexcept;
  /// To the end of the cycle; not called while a halt or another stop brakes.
  Demand cycle(const CyclicSettings& settings, const Limits& limits) noexcept;
  /// At the end of the last cycle, or at the set-point that came after it.
  Demand demand() const noexcept;

  /// Bit 12: follows the set-points. Bit 13: @p has_following_error, as it is monitored.
  ModeBits bits(bool has_following_error) const noexcept;
  /// Too many set-points in a row are missing (8700h).
  bool is_lost() const noexcept { return is_lost_; }

 private:
  PositionInterpolation position_{};
  Offsets offsets_{};
  bool is_active_ = false;
  bool is_halted_ = false;
  bool is_lost_ = false;
};

}  // namespace cia402
