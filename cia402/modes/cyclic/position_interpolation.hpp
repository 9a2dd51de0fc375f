#pragma once

#include <optional>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/cyclic/set_point_clock.hpp"
#include "cia402/modes/cyclic/set_point_line.hpp"

namespace cia402 {

/// Position demand of csp and ip: on a straight line from where it is to the set-point, from the instant of the
/// set- point and for T. Before the first set-point it stands, or brakes to rest with 6084h.
///
/// It runs no faster than the speed cap, which then leads it on until the line is caught up, and not beyond the
/// software limits; from outside them it may come back.
class PositionInterpolation {
 public:
  /// From @p present to rest; what was before is forgotten. A cycle begins.
  void hold(const Motion& present) noexcept;
  /// The same from the present demand, within the cycle.
  void brake() noexcept;
  /// A set-point at @p instant of the running cycle. On an axis with 607Bh any of its equal places.
  void set_point(double position, TimeNs instant, const CyclicSettings& settings, const Limits& limits) noexcept;
  /// To the end of the cycle.
  void finish_cycle(const CyclicSettings& settings, const Limits& limits) noexcept;

  /// At the end of the last cycle, or at the set-point that came after it.
  const Motion& demand() const noexcept { return demand_; }
  /// By the speed cap or a software limit.
  bool is_limited() const noexcept { return is_capped_ || is_cut_off_; }
  /// Whether the demand is where the set-points want it.
  bool is_following() const noexcept { return clock_.is_led() && !is_limited(); }
  /// Whether it stands at the last set-point, or where it is held without one.
  bool has_arrived() const noexcept;
  const SetPointClock& clock() const noexcept { return clock_; }

 private:
  void advance(TimeNs until, const CyclicSettings& settings, const Limits& limits) noexcept;
  void follow(TimeNs time, const Limits& limits) noexcept;
  void slow_down(TimeNs time, double deceleration, const Limits& limits) noexcept;
  double place_of(double position, const Limits& limits) const noexcept;
  Span bounds(const Limits& limits) const noexcept;
  double wanted_velocity() const noexcept;

  Motion demand_{};
  SetPointClock clock_{};
  SetPointLine line_{};
  TimeNs now_{};  // in the running cycle
  bool is_capped_ = false;
  bool is_cut_off_ = false;
};

}  // namespace cia402
