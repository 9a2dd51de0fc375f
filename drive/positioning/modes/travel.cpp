#include "drive/positioning/modes/travel.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

constexpr double kHair = 1e-6;  // LU, below what any position shows

double braking_way(double velocity, double deceleration) noexcept {
  return velocity * velocity / (2.0 * deceleration);
}

}  // namespace

void Travel::bound(const TravelConditions& conditions) noexcept {
  conditions_ = conditions;
  const bool ended = has_arrived() && has_target();
  if (state_ == State::Going && !ended) apply();
  if (state_ == State::Interrupted) motion_.brake(goal_deceleration());
}

void Travel::place(double position) noexcept {
  motion_.place(position);
  state_ = State::Free;
}

void Travel::shift(double by) noexcept {
  motion_.shift(by);
  goal_.target += by;
  applied_.target += by;
}

void Travel::shift_target(double by) noexcept {
  goal_.target += by;
  if (state_ == State::Going) apply();
}

bool Travel::has_target() const noexcept {
  return std::isfinite(goal_.target);
}

double Travel::highest_velocity(Direction direction) const noexcept {
  return std::min(conditions_.velocity, conditions_.directed_velocity[place_of(direction)]);
}

double Travel::hardest_deceleration() const noexcept {
  return std::max(conditions_.deceleration, state_ != State::Free ? applied_.limits.deceleration : 0.0);
}

/// @p wanted, or as much more as it takes to stand at the limit ahead, p2573 or what brakes already at the most.
double Travel::deceleration_to_limits(double wanted) const noexcept {
  const double velocity = planned_velocity();
  const double limit = velocity < 0.0 ? conditions_.lower : conditions_.upper;
  const double way = velocity < 0.0 ? planned_position() - limit : limit - planned_position();
  if (!(std::abs(velocity) > 0.0) || braking_way(velocity, wanted) <= way + kHair) return wanted;
  const double hardest = std::max(wanted, hardest_deceleration());
  return way > 0.0 ? std::min(hardest, braking_way(velocity, 1.0) / way) : hardest;
}

/// The place that can be reached of what lies beyond a limit; where that has come too close, the place where the
/// motion can stand.
double Travel::bounded(double target, double deceleration) const noexcept {
  const double position = planned_position();
  const double velocity = planned_velocity();
  const double way = braking_way(velocity, deceleration);
  const double rest = position + (velocity < 0.0 ? -way : way);
  const double upper = conditions_.barred[place_of(Direction::Positive)] ? std::min(conditions_.upper, position)
                                                                         : conditions_.upper;
  const double lower = conditions_.barred[place_of(Direction::Negative)] ? std::max(conditions_.lower, position)
                                                                         : conditions_.lower;
  if (target > upper) return velocity > 0.0 && rest > upper + kHair ? std::min(target, rest) : upper;
  if (target < lower) return velocity < 0.0 && rest < lower - kHair ? std::max(target, rest) : lower;
  return target;
}

/// What the goal asks for, within the limits.
double Travel::goal_deceleration() const noexcept {
  return deceleration_to_limits(goal_.deceleration * conditions_.deceleration);
}

Travel::Applied Travel::plan() const noexcept {
  const double deceleration = goal_deceleration();
  const double target = bounded(goal_.target, deceleration);
  const double way = target - planned_position();
  const double heading = std::abs(way) > 0.0 ? way : planned_velocity();
  const double highest = highest_velocity(direction_of(heading));
  const double wanted = goal_.velocity * (goal_.follows_override ? conditions_.velocity_override : 1.0);
  return {.target = target,
          .limits = {.velocity = std::min(wanted, highest),
                     .acceleration = goal_.acceleration * conditions_.acceleration,
                     .deceleration = deceleration},
          .capped = wanted > highest,
          .cut_off = std::abs(target - goal_.target) > kHair};
}

void Travel::apply() noexcept {
  const Applied wanted = plan();
  if (state_ == State::Going && wanted == applied_) return;
  state_ = State::Going;
  applied_ = wanted;
  constexpr bool kKeepsLargerDeceleration = true;
  motion_.move_to(wanted.target, wanted.limits, kKeepsLargerDeceleration);
}

bool Travel::start(const Goal& goal) noexcept {
  const double way = goal.target - planned_position();
  const bool moves = std::abs(planned_velocity()) > 0.0;
  if (!moves && std::abs(way) > 0.0 && is_barred(direction_of(way))) return false;
  goal_ = goal;
  state_ = State::Free;
  apply();
  return true;
}

void Travel::change(const Goal& goal) noexcept {
  if (goal == goal_ && state_ != State::Free) return;
  goal_ = goal;
  if (state_ != State::Interrupted) apply();
}

void Travel::interrupt() noexcept {
  if (state_ != State::Going || has_arrived()) return;
  state_ = State::Interrupted;
  motion_.brake(goal_deceleration());
}

void Travel::resume() noexcept {
  if (state_ != State::Interrupted) return;
  state_ = State::Free;
  apply();
}

void Travel::reject() noexcept {
  const double deceleration = deceleration_to_limits(conditions_.deceleration);
  state_ = State::Free;
  motion_.brake(deceleration);
}

Travel::Advance Travel::advance(double dt, bool stops_at_braking_point) noexcept {
  return motion_.advance(dt, stops_at_braking_point, false);
}

bool Travel::is_past_braking_point() const noexcept {
  return state_ == State::Going && motion_.unlimited().has_passed_braking_point();
}

double Travel::effective_override() const noexcept {
  const double override_share =
      goal_.follows_override || state_ == State::Free ? conditions_.velocity_override : 1.0;
  if (state_ != State::Going || !(goal_.velocity > 0.0)) return override_share;
  return applied_.limits.velocity / goal_.velocity;
}

bool Travel::is_at_limit(Direction direction) const noexcept {
  return direction == Direction::Positive ? planned_position() > conditions_.upper - kHair
                                          : planned_position() < conditions_.lower + kHair;
}

double Travel::braking_distance(double share) const noexcept {
  return braking_way(planned_velocity(), share * conditions_.deceleration);
}

}  // namespace drive
