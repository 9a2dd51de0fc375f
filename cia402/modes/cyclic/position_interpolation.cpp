#include "cia402/modes/cyclic/position_interpolation.hpp"

#include <algorithm>
#include <cmath>

#include "cia402/quantities/position_range.hpp"

namespace cia402 {
namespace {

/// What rounding may add to a way or a slope, as a share of it.
constexpr double kRounding = 1e-9;

bool exceeds(double way, double most) noexcept {
  return std::abs(way) > most * (1.0 + kRounding);
}

}  // namespace

void PositionInterpolation::hold(const Motion& present) noexcept {
  *this = PositionInterpolation{};
  demand_ = {.position = present.position, .velocity = present.velocity};
}

void PositionInterpolation::brake() noexcept {
  clock_.forget();
  is_capped_ = is_cut_off_ = false;
}

bool PositionInterpolation::has_arrived() const noexcept {
  const bool stands = !(std::abs(demand_.velocity) > 0.0);
  return stands && !is_limited() && (!clock_.is_led() || demand_.position == line_.to);
}

void PositionInterpolation::set_point(double position, TimeNs instant, const CyclicSettings& settings,
                                      const Limits& limits) noexcept {
  advance(std::clamp(instant, now_, kCycleTime), settings, limits);
  line_ = {.from = demand_.position, .to = place_of(position, limits)};
  clock_.take(settings.period);
  const double slope = wanted_velocity();
  const Span span = bounds(limits);
  is_capped_ = exceeds(slope, limits.velocity);
  is_cut_off_ = slope > 0.0 ? demand_.position >= span.high : slope < 0.0 && demand_.position <= span.low;
  demand_.velocity = is_cut_off_ ? 0.0 : std::clamp(slope, -limits.velocity, limits.velocity);
}

void PositionInterpolation::finish_cycle(const CyclicSettings& settings, const Limits& limits) noexcept {
  advance(kCycleTime, settings, limits);
  now_ = TimeNs{};
}

void PositionInterpolation::advance(TimeNs until, const CyclicSettings& settings, const Limits& limits) noexcept {
  while (now_ < until) {
    const TimeNs time = std::min(until - now_, clock_.until_change());
    const bool is_led = clock_.is_led();
    if (is_led)
      follow(time, limits);
    else if (clock_.phase() == SetPointPhase::Missing)
      slow_down(time, settings.quick_stop_deceleration, limits);
    else
      slow_down(time, std::min(settings.deceleration, limits.deceleration), limits);
    now_ += time;
    clock_.advance(time, settings.is_supervised);
    if (is_led && clock_.phase() == SetPointPhase::Held && !is_limited()) demand_.velocity = 0.0;
  }
}

/// The slope of the line, as long as it goes on.
double PositionInterpolation::wanted_velocity() const noexcept {
  return clock_.phase() == SetPointPhase::Held ? 0.0 : line_.slope(clock_);
}

void PositionInterpolation::follow(TimeNs time, const Limits& limits) noexcept {
  const Span span = bounds(limits);
  const double wanted = clock_.phase() == SetPointPhase::Held ? line_.to : line_.at(clock_, time);
  const double goal = std::clamp(wanted, span.low, span.high);
  const double way = goal - demand_.position;
  const double most = limits.velocity * seconds(time);
  is_cut_off_ = goal != wanted;
  is_capped_ = exceeds(way, most);
  if (is_capped_) {
    demand_.position += std::copysign(most, way);
    demand_.velocity = std::copysign(limits.velocity, way);
    return;
  }
  demand_.position = goal;
  demand_.velocity = is_cut_off_ ? 0.0 : std::clamp(wanted_velocity(), -limits.velocity, limits.velocity);
}

void PositionInterpolation::slow_down(TimeNs time, double deceleration, const Limits& limits) noexcept {
  is_capped_ = is_cut_off_ = false;
  const double speed = std::abs(demand_.velocity);
  if (!(speed > 0.0)) return;
  const double direction = std::copysign(1.0, demand_.velocity);
  const double braking = std::min(seconds(time), speed / deceleration);
  const bool rests = seconds(time) >= speed / deceleration;
  const Span span = bounds(limits);
  const double wanted = demand_.position + direction * braking * (speed - 0.5 * deceleration * braking);
  demand_.position = std::clamp(wanted, span.low, span.high);
  is_cut_off_ = demand_.position != wanted;
  demand_.velocity = rests || is_cut_off_ ? 0.0 : direction * (speed - deceleration * braking);
}

/// Of the equal places of an axis with 607Bh the one next to the last set-point, so that a demand that trails its
/// set-points by more than half a range does not turn back; before the first one next to the demand. Within
/// software limits the axis does not cross the border of its range: the place is in the turn of the demand.
double PositionInterpolation::place_of(double position, const Limits& limits) const noexcept {
  if (!limits.range) return position;
  const Span& range = *limits.range;
  if (!limits.software)
    return nearest(position, clock_.phase() == SetPointPhase::None ? demand_.position : line_.to, range);
  const double turns = turns_of(demand_.position, range) - turns_of(position, range);
  return position + turns * modulus_of(range);
}

/// Where the demand may be: within the software limits, or between them and where it is.
Span PositionInterpolation::bounds(const Limits& limits) const noexcept {
  if (!limits.software) return {-kEndless, kEndless};
  const double turns = limits.range ? turns_of(demand_.position, *limits.range) * modulus_of(*limits.range) : 0.0;
  return {std::min(limits.software->low + turns, demand_.position),
          std::max(limits.software->high + turns, demand_.position)};
}

}  // namespace cia402
