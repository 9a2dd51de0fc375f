#include "cia402/modes/cyclic/cyclic_position.hpp"

namespace cia402 {

void CyclicPosition::enter(const Motion& present, std::uint16_t word) noexcept {
  resume(present);
  is_active_ = true;
  controlword(word);
}

void CyclicPosition::resume(const Motion& present) noexcept {
  position_.hold(present);
  offsets_ = {};
  is_halted_ = is_lost_ = false;
}

void CyclicPosition::leave() noexcept {
  *this = CyclicPosition{};
}

void CyclicPosition::controlword(std::uint16_t word) noexcept {
  is_halted_ = is_halted_ || (word & kHaltBit) != 0;
}

void CyclicPosition::set_point(double position, const Offsets& offsets, TimeNs instant,
                               const CyclicSettings& settings, const Limits& limits) noexcept {
  if (!is_active_ || is_halted_) return;
  offsets_ = offsets;
  position_.set_point(position + offsets.position, instant, settings, limits);
  is_lost_ = false;
}

Demand CyclicPosition::cycle(const CyclicSettings& settings, const Limits& limits) noexcept {
  position_.finish_cycle(settings, limits);
  is_lost_ = position_.clock().is_lost(settings);
  return demand();
}

Demand CyclicPosition::demand() const noexcept {
  return {.lead = Lead::Position,
          .motion = position_.demand(),
          .velocity_offset = position_.clock().is_led() ? offsets_.velocity : 0.0,
          .torque_offset = offsets_.torque,
          .is_limited = position_.is_limited()};
}

ModeBits CyclicPosition::bits(bool has_following_error) const noexcept {
  return {.bit_12 = is_active_ && !is_halted_ && position_.is_following(),
          .bit_13 = is_active_ && has_following_error};
}

}  // namespace cia402
