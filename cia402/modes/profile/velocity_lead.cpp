#include "cia402/modes/profile/velocity_lead.hpp"

#include <algorithm>
#include <cmath>

#include "cia402/motion/position_range.hpp"

namespace cia402 {

void VelocityLead::start(double velocity) noexcept {
  velocity_ = velocity;
  end_ = {};
}

VelocityLead::End VelocityLead::end_of_travel(double target, double position, const Limits& limits) noexcept {
  const auto software = software_limits_at(position, limits);
  if (!software || !(std::abs(target) > 0.0)) return {};
  const bool is_positive = target > 0.0;
  return {.exists = true,
          .direction = is_positive ? 1.0 : -1.0,
          .position = is_positive ? software->high : software->low};
}

Demand VelocityLead::cycle(double target, const VelocitySlopes& slopes, const Limits& limits,
                           const Actual& actual) noexcept {
  const double goal = std::clamp(target, -limits.velocity, limits.velocity);
  const Order order{.velocity = std::abs(goal), .slopes = slopes};
  const double position = end_.exists ? profile_.position() : actual.position;
  const End end = end_of_travel(goal, position, limits);
  if (end_.exists && !(end == end_)) end_ = {};  // it is led away, or the limit has moved
  if (!end_.exists) {
    const double next = ramped(velocity_, goal, slopes, kCycle);
    if (!ends_within(end, next, slopes, position)) {
      velocity_ = next;
      return {.lead = Lead::Velocity,
              .motion = {actual.position, next, actual.torque},
              .is_limited = std::abs(target) > limits.velocity};
    }
    approach(end, order, limits, position);
  }
  follow(order);
  profile_.advance(kCycle);
  velocity_ = profile_.velocity();
  return {.lead = Lead::Position, .motion = {profile_.position(), velocity_, actual.torque}, .is_limited = true};
}

/// Whether the axis would come to rest beyond @p end if it took velocity @p next in this cycle.
bool VelocityLead::ends_within(const End& end, double next, const VelocitySlopes& slopes,
                               double position) const noexcept {
  if (!end.exists || !(next * end.direction > 0.0)) return false;
  const double way = 0.5 * (std::max(0.0, velocity_ * end.direction) + std::abs(next)) * kCycle;
  return way + 0.5 * next * next / slopes.deceleration > (end.position - position) * end.direction;
}

/// Leads to @p end, or to rest if that lies behind.
void VelocityLead::approach(const End& end, const Order& order, const Limits& limits, double position) noexcept {
  const double room = (end.position - position) * end.direction;
  const double slope = order.slopes.deceleration;
  end_ = end;
  order_ = order;
  profile_.place(position, velocity_);
  if (!(room > 0.0)) return profile_.brake(slope);
  const double needed = 0.5 * velocity_ * velocity_ / room;
  profile_.move_to(end.position, {order.velocity, order.slopes.acceleration,
                                  std::clamp(needed, slope, std::max(slope, limits.deceleration))});
}

/// On the way to a limit the velocity may still change.
void VelocityLead::follow(const Order& order) noexcept {
  const bool leads_to_limit = profile_.target() == end_.position;
  if (order == order_ || !leads_to_limit || profile_.stands()) return;
  order_ = order;
  constexpr bool kKeepsLargerDeceleration = true;
  profile_.move_to(end_.position, {order.velocity, order.slopes.acceleration, order.slopes.deceleration},
                   kKeepsLargerDeceleration);
}

}  // namespace cia402
