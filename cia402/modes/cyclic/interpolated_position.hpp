#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/cyclic/position_interpolation.hpp"

namespace cia402 {

/// Interpolated position mode (ip), linear: like csp, but only while bit 4 of the controlword is set, and with a
/// bit that tells when the position is reached.
///
/// Where a controlword and a set-point come together, enter(), resume() and controlword() are called before
/// set_point().
class InterpolatedPosition {
 public:
  /// As CyclicPosition; @p word tells whether bit 4 is set already, which counts.
  void enter(const Motion& present, std::uint16_t word) noexcept;
  void resume(const Motion& present) noexcept;
  void leave() noexcept;
  /// A write of 6040h: bit 4 enables the interpolation, without it the axis brakes with 6084h and holds.
  void controlword(std::uint16_t word) noexcept;
  /// @p position (60C1h:1; position units) at @p instant of the running cycle; ignored while bit 4 is 0.
  void set_point(double position, TimeNs instant, const CyclicSettings& settings, const Limits& limits) noexcept;
  /// To the end of the cycle; not called while a halt or another stop brakes.
  Demand cycle(const CyclicSettings& settings, const Limits& limits, const Actual& actual) noexcept;
  /// At the end of the last cycle, or at the set-point that came after it.
  Demand demand() const noexcept;

  /// Bit 10: the demand stands, and the axis has been within 6067h of it for 6068h. Bit 12: the interpolation is
  /// active. Bit 13: @p has_following_error, as it is monitored.
  ModeBits bits(bool has_following_error) const noexcept;
  /// Too many set-points in a row are missing (8700h).
  bool is_lost() const noexcept { return is_lost_; }

 private:
  void watch_window(const CyclicSettings& settings, const Actual& actual) noexcept;

  PositionInterpolation position_{};
  TimeNs in_window_{};  // since the demand and the axis stand there
  bool is_active_ = false;
  bool is_enabled_ = false;  // bit 4
  bool is_halted_ = false;
  bool has_reached_ = false;
  bool is_lost_ = false;
};

}  // namespace cia402
