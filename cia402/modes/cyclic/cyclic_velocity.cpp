#include "cia402/modes/cyclic/cyclic_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "cia402/quantities/position_range.hpp"

namespace cia402 {
namespace {

/// The velocity at the end of a cycle from which @p deceleration leads to rest within @p room, which counts from
/// its beginning with @p velocity.
double highest_velocity(double room, double velocity, double deceleration) noexcept {
  const double left = room - 0.5 * kCycle * velocity;
  if (!(left > 0.0)) return 0.0;
  const double step = 0.5 * kCycle * deceleration;
  return std::sqrt(step * step + 2.0 * deceleration * left) - step;
}

Span velocities_within(const Limits& limits, const Actual& actual, double deceleration) noexcept {
  if (!limits.software) return {-kEndless, kEndless};
  const double turns = limits.range ? turns_of(actual.position, *limits.range) * modulus_of(*limits.range) : 0.0;
  const double position = actual.position - turns;
  return {-highest_velocity(position - limits.software->low, -actual.velocity, deceleration),
          highest_velocity(limits.software->high - position, actual.velocity, deceleration)};
}

}  // namespace

void CyclicVelocity::enter(const Motion& present, std::uint16_t word) noexcept {
  resume(present);
  is_active_ = true;
  controlword(word);
}

void CyclicVelocity::resume(const Motion& present) noexcept {
  clock_.forget();
  demand_ = {.position = present.position, .velocity = present.velocity};
  holds_position_ = !(std::abs(present.velocity) > 0.0);
  towards_limits_ = {-kEndless, kEndless};
  offsets_ = {};
  now_ = TimeNs{};
  is_halted_ = is_limited_ = is_lost_ = false;
}

void CyclicVelocity::leave() noexcept {
  *this = CyclicVelocity{};
}

void CyclicVelocity::controlword(std::uint16_t word) noexcept {
  is_halted_ = is_halted_ || (word & kHaltBit) != 0;
}

void CyclicVelocity::set_point(double velocity, const Offsets& offsets, TimeNs instant,
                               const CyclicSettings& settings, const Limits& limits) noexcept {
  if (!is_active_ || is_halted_) return;
  advance(std::clamp(instant, now_, kCycleTime), settings, limits);
  offsets_ = offsets;
  line_ = {.from = demand_.velocity, .to = velocity + offsets.velocity};
  clock_.take(settings.period);
  holds_position_ = is_lost_ = false;
}

Demand CyclicVelocity::cycle(const CyclicSettings& settings, const Limits& limits, const Actual& actual) noexcept {
  towards_limits_ = velocities_within(limits, actual, settings.quick_stop_deceleration);
  advance(kCycleTime, settings, limits);
  now_ = TimeNs{};
  is_lost_ = clock_.is_lost(settings);
  if (!holds_position_) demand_.position = actual.position;
  return demand();
}

void CyclicVelocity::advance(TimeNs until, const CyclicSettings& settings, const Limits& limits) noexcept {
  while (now_ < until) {
    const TimeNs time = std::min(until - now_, clock_.until_change());
    switch (clock_.phase()) {
      case SetPointPhase::None:
        lead_to(demand_.velocity, limits);
        break;
      case SetPointPhase::OnTime:
        lead_to(line_.at(clock_, time), limits);
        break;
      case SetPointPhase::Held:
      case SetPointPhase::Late:
        lead_to(line_.to, limits);
        break;
      case SetPointPhase::Missing: {
        const double slower = settings.quick_stop_deceleration * seconds(time);
        const double speed = std::max(0.0, std::abs(demand_.velocity) - slower);
        lead_to(std::copysign(speed, demand_.velocity), limits);
        break;
      }
    }
    now_ += time;
    clock_.advance(time, settings.is_supervised);
  }
}

void CyclicVelocity::lead_to(double velocity, const Limits& limits) noexcept {
  const double low = std::max(-limits.velocity, towards_limits_.low);
  const double high = std::min(limits.velocity, towards_limits_.high);
  demand_.velocity = std::clamp(velocity, low, high);
  is_limited_ = demand_.velocity != velocity;
}

Demand CyclicVelocity::demand() const noexcept {
  return {.lead = holds_position_ ? Lead::Position : Lead::Velocity,
          .motion = demand_,
          .torque_offset = offsets_.torque,
          .is_limited = is_limited_};
}

ModeBits CyclicVelocity::bits() const noexcept {
  return {.bit_12 = is_active_ && !is_halted_ && clock_.is_led() && !is_limited_};
}

}  // namespace cia402
