#include "cia402/modes/profile/profile_position.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {
namespace {

/// What rounding may take of a velocity (as a share of it).
constexpr double kRounding = 1e-9;

}  // namespace

void ProfilePosition::enter(const Motion& present) noexcept {
  places_.clear();
  profile_.place(present.position, present.velocity);
  target_ = {.position = present.position};
  is_entering_ = !profile_.stands();
  is_reached_ = !is_entering_;
  is_aimed_ = is_planned_ = true;
  is_capped_ = false;
  window_.satisfy();
}

void ProfilePosition::resume(const Motion& present) noexcept {
  profile_.place(present.position, present.velocity);
  is_planned_ = !places_.running();
  is_entering_ = is_planned_ && !profile_.stands();
  if (is_planned_) target_ = {.position = present.position};
}

void ProfilePosition::controlword(std::uint16_t word, std::uint16_t former,
                                  const ProfilePositionSettings& settings) noexcept {
  const std::optional<SetPoint> running = places_.running();
  const SetPointPlaces::Taken taken = places_.controlword(word, former, settings);
  if (taken == SetPointPlaces::Taken::None) return;
  is_planned_ = false;  // a waiting one may be passed on to
  if (taken == SetPointPlaces::Taken::Waiting) return;
  if (running && !is_aimed_) aim_at(*running);  // it never began, but the next one may count from its target
  is_aimed_ = is_reached_ = false;
  window_.restart();
}

Demand ProfilePosition::cycle(const ProfilePositionSettings& settings, const Limits& limits,
                              const Actual& actual) noexcept {
  limits_ = limits;
  actual_ = actual;
  if (is_entering_ && !places_.running()) brake(std::min(settings.deceleration, limits.deceleration));
  is_entering_ = false;
  if (is_reached_ && places_.waiting())
    plan_next();
  else if (!is_planned_ && places_.running())
    plan();
  move();
  judge(settings);
  return {.lead = Lead::Position,
          .motion = {profile_.position(), profile_.velocity(), actual.torque},
          .is_limited = target_.is_clipped || (places_.running() && is_capped_)};
}

void ProfilePosition::brake(double deceleration) noexcept {
  const double velocity = profile_.velocity();
  target_.position = profile_.position() + 0.5 * velocity * std::abs(velocity) / deceleration;
  profile_.brake(deceleration);
}

void ProfilePosition::aim_at(const SetPoint& set_point) noexcept {
  target_ = target_of(set_point,
                      {.target = target_.position,
                       .demand = profile_.position(),
                       .velocity = profile_.velocity(),
                       .stopping_way = profile_.stopping_way(capped(set_point.limits, limits_)),
                       .actual = actual_.position},
                      limits_);
}

/// The way of the running set-point from here.
void ProfilePosition::plan() noexcept {
  const SetPoint& running = *places_.running();
  if (!is_aimed_) aim_at(running);
  is_aimed_ = is_planned_ = true;
  is_capped_ = running.limits.velocity > limits_.velocity;
  profile_.move_to(target_.position, capped(running.limits, limits_), passing_velocity());
}

/// The waiting set-point becomes the running one.
void ProfilePosition::plan_next() noexcept {
  places_.advance();
  is_reached_ = false;
  window_.restart();
  is_aimed_ = false;
  plan();
}

/// At the target, with its sign: 0 if the waiting set-point does not change there (bit 9). It is at most what that
/// one can brake from.
double ProfilePosition::passing_velocity() const noexcept {
  const SetPoint& running = *places_.running();
  const std::optional<SetPoint>& waiting = places_.waiting();
  if (!waiting || !waiting->changes_on_set_point) return 0.0;
  const double here = target_.position;
  const double way =
      target_of(*waiting, {.target = here, .demand = here, .actual = here}, limits_).position - here;
  const double highest = highest_velocity_before(std::abs(way), capped(waiting->limits, limits_));
  const double own = running.end_velocity > 0.0 ? running.end_velocity : running.limits.velocity;
  return std::copysign(std::min(own, highest * (1.0 - kRounding)), way);
}

void ProfilePosition::move() noexcept {
  for (double left = kCycle; left > 0.0;) {
    const ProfileAdvance advance = profile_.advance(left);
    left = advance.left;
    const bool changes = places_.waiting() && places_.waiting()->changes_on_set_point;
    if (advance.event != ProfileEvent::None && changes) plan_next();
  }
}

void ProfilePosition::judge(const ProfilePositionSettings& settings) noexcept {
  const std::optional<double>& window = settings.position_window;
  const bool inside = !window || std::abs(actual_.position - target_.position) <= *window;
  const bool settled = window_.update(inside, settings.window_time);
  const bool arrived = places_.running() ? profile_.has_arrived() : profile_.stands();
  is_reached_ = settled && arrived;
  if (is_reached_ && places_.running()) places_.reach();
}

}  // namespace cia402
