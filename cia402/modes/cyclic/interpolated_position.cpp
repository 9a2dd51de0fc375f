#include "cia402/modes/cyclic/interpolated_position.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

void InterpolatedPosition::enter(const Motion& present, std::uint16_t word) noexcept {
  resume(present);
  is_active_ = true;
  is_enabled_ = false;
  controlword(word);
}

void InterpolatedPosition::resume(const Motion& present) noexcept {
  position_.hold(present);
  in_window_ = TimeNs{};
  has_reached_ = position_.has_arrived();
  is_halted_ = is_lost_ = false;
}

void InterpolatedPosition::leave() noexcept {
  *this = InterpolatedPosition{};
}

void InterpolatedPosition::controlword(std::uint16_t word) noexcept {
  const bool enables = (word & kInterpolationBit) != 0;
  if (is_enabled_ && !enables) position_.brake();
  is_enabled_ = enables;
  is_halted_ = is_halted_ || (word & kHaltBit) != 0;
}

void InterpolatedPosition::set_point(double position, TimeNs instant, const CyclicSettings& settings,
                                     const Limits& limits) noexcept {
  if (!is_active_ || !is_enabled_ || is_halted_) return;
  position_.set_point(position, instant, settings, limits);
  is_lost_ = false;
  if (position_.has_arrived()) return;
  in_window_ = TimeNs{};
  has_reached_ = false;
}

Demand InterpolatedPosition::cycle(const CyclicSettings& settings, const Limits& limits,
                                   const Actual& actual) noexcept {
  position_.finish_cycle(settings, limits);
  is_lost_ = position_.clock().is_lost(settings);
  watch_window(settings, actual);
  return demand();
}

Demand InterpolatedPosition::demand() const noexcept {
  return {.lead = Lead::Position, .motion = position_.demand(), .is_limited = position_.is_limited()};
}

/// The first cycle in the window is the one at whose end it is seen there.
void InterpolatedPosition::watch_window(const CyclicSettings& settings, const Actual& actual) noexcept {
  const double error = std::abs(actual.position - position_.demand().position);
  const bool is_inside = position_.has_arrived() && error <= settings.position_window;
  has_reached_ = is_inside && (has_reached_ || in_window_ >= settings.position_window_time);
  in_window_ = is_inside ? std::min(in_window_ + kCycleTime, settings.position_window_time) : TimeNs{};
}

ModeBits InterpolatedPosition::bits(bool has_following_error) const noexcept {
  const bool has_stopped = position_.clock().phase() == SetPointPhase::Missing;
  return {.bit_10 = is_active_ && has_reached_,
          .bit_12 = is_active_ && is_enabled_ && !is_halted_ && !has_stopped,
          .bit_13 = is_active_ && has_following_error};
}

}  // namespace cia402
