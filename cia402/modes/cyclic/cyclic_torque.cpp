#include "cia402/modes/cyclic/cyclic_torque.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

void CyclicTorque::enter(const Motion& present, std::uint16_t word) noexcept {
  begin(present, present.velocity == 0.0 && present.torque == 0.0);
  is_active_ = true;
  controlword(word);
}

void CyclicTorque::resume(const Motion& present) noexcept {
  begin(present, true);
}

void CyclicTorque::begin(const Motion& present, bool holds_position) noexcept {
  clock_.forget();
  demand_ = present;
  wanted_ = present.torque;
  now_ = TimeNs{};
  holds_position_ = holds_position;
  is_halted_ = is_limited_ = is_lost_ = false;
}

void CyclicTorque::leave() noexcept {
  *this = CyclicTorque{};
}

void CyclicTorque::controlword(std::uint16_t word) noexcept {
  is_halted_ = is_halted_ || (word & kHaltBit) != 0;
}

void CyclicTorque::set_point(double torque, const Offsets& offsets, TimeNs instant,
                             const CyclicSettings& settings) noexcept {
  if (!is_active_ || is_halted_) return;
  advance(std::clamp(instant, now_, kCycleTime), settings);
  clock_.take(settings.period);
  lead_to(torque + offsets.torque, settings);
  holds_position_ = is_lost_ = false;
}

Demand CyclicTorque::cycle(const CyclicSettings& settings, const Actual& actual) noexcept {
  advance(kCycleTime, settings);
  now_ = TimeNs{};
  is_lost_ = clock_.is_lost(settings);
  if (!holds_position_) {
    demand_.position = actual.position;
    demand_.velocity = actual.velocity;
  }
  return demand();
}

void CyclicTorque::advance(TimeNs until, const CyclicSettings& settings) noexcept {
  while (now_ < until) {
    const TimeNs time = std::min(until - now_, clock_.until_change());
    if (clock_.phase() == SetPointPhase::Missing) {
      const double less = settings.torque_slope * seconds(time);
      wanted_ = std::copysign(std::max(0.0, std::abs(demand_.torque) - less), wanted_);
    }
    lead_to(wanted_, settings);
    now_ += time;
    clock_.advance(time, settings.is_supervised);
  }
}

void CyclicTorque::lead_to(double torque, const CyclicSettings& settings) noexcept {
  wanted_ = torque;
  demand_.torque = std::clamp(torque, settings.torque.low, settings.torque.high);
  is_limited_ = demand_.torque != torque;
}

Demand CyclicTorque::demand() const noexcept {
  return {.lead = holds_position_ ? Lead::Position : Lead::Torque,
          .motion = demand_,
          .is_limited = !holds_position_ && is_limited_};
}

ModeBits CyclicTorque::bits() const noexcept {
  return {.bit_12 = is_active_ && !is_halted_ && clock_.is_led() && !is_limited_};
}

}  // namespace cia402
