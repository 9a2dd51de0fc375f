#pragma once

#include <cmath>
#include <cstdint>

#include "drive/positioning/modes/positioner_settings.hpp"
#include "drive/positioning/modes/refusals.hpp"
#include "drive/positioning/modes/travel.hpp"
#include "drive/positioning/positioning_messages.hpp"

namespace drive {

/// Highest and lowest setpoint that there is (LU).
inline constexpr double kHighestPosition = 2147482647.0;
inline constexpr double kLowestPosition = -2147482648.0;

/// The reference of the coordinates.
struct ReferencePoint {
  bool is_set = false;    ///< r2684.11
  double moved_by = 0.0;  ///< what the actual value is to be moved by, with the setpoint (LU)
};

/// What a mode sees in a slice, and what it acts on.
struct ModeContext {
  const PositionerSettings& settings;
  const PositionerInputs& inputs;
  const PositionerInputs& before;  ///< inputs of the slice before
  Travel& travel;
  PositioningMessages& messages;
  Refusals& refusals;
  ReferencePoint& reference;
  double modulo_range = 0.0;   ///< in force (LU), 0 = none
  bool can_reach_stop = true;  ///< closed loop with encoder

  bool rises(bool PositionerInputs::*input) const noexcept { return inputs.*input && !(before.*input); }
  bool has_modulo() const noexcept { return modulo_range > 0.0; }
  /// p2640 and p2641 as they hold for blocks and MDI.
  bool may_go() const noexcept { return inputs.no_intermediate_stop && inputs.no_reject; }
};

/// The way from @p position to the absolute @p target of a modulo axis: 0 shortest with a tie positive, +1 only
/// positive, -1 only negative.
inline double modulo_way(double position, double target, double range, int direction) noexcept {
  const double way = target - position;
  const double positive = way - range * std::floor(way / range);  // 0..range
  if (direction > 0) return positive;
  if (direction < 0) return positive > 0.0 ? positive - range : 0.0;
  return positive > range / 2.0 ? positive - range : positive;
}

/// The way of a motion that is not to turn back: where the target has come nearer than @p braking_way of the
/// velocity in its direction, a whole turn more.
inline double whole_turn_way(double way, double range, double velocity, double braking_way,
                             int direction) noexcept {
  if (direction > 0 && velocity > 0.0)
    while (way < braking_way) way += range;
  if (direction < 0 && velocity < 0.0)
    while (-way < braking_way) way -= range;
  return way;
}

}  // namespace drive
