#include "cia402/inputs/digital_inputs.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {
namespace {

/// A pulse is at the place of a switch if their instants differ by no more: rounding of load revolutions.
constexpr double kSameInstant = 1e-9;

/// From one place to another one in the cycle.
struct Way {
  double from;
  double to;

  bool is_upward() const noexcept { return to > from; }
  /// Whether @p place is passed: it belongs to what lies above it.
  bool passes(double place) const noexcept {
    return is_upward() ? from < place && place <= to : to < place && place <= from;
  }
  /// When it is passed, 0..1.
  double instant_of(double place) const noexcept { return std::clamp((place - from) / (to - from), 0.0, 1.0); }
};

Way motor_way(const CycleMotion& motion) noexcept {
  return {.from = motion.begin(), .to = motion.end()};
}

Way load_way(const CycleMotion& motion) noexcept {
  return {.from = motion.load_from, .to = motion.load_to};
}

constexpr Edge opposite(Edge edge) noexcept {
  return edge == Edge::Rising ? Edge::Falling : Edge::Rising;
}

}  // namespace

DigitalInputs::DigitalInputs(const TravelSwitches& switches, std::uint32_t per_revolution) noexcept
    : switches_{switches}, per_revolution_{static_cast<double>(per_revolution)} {
  pass({});
}

void DigitalInputs::pass(const CycleMotion& motion, const std::optional<ZeroPlace>& zero) noexcept {
  motion_ = motion;
  count_ = 0;
  for (const Signal signal : TravelSwitches::kSignals)
    if (const auto& row = switches_.of(signal)) look_at(signal, *row);
  look_for_pulses(Signal::Index, {.period = per_revolution_});
  if (zero) look_for_pulses(Signal::SoftwareZero, *zero);
}

void DigitalInputs::look_at(Signal signal, const TravelSwitch& row) noexcept {
  if (row.from < row.to) {
    const Edge at_begin = row.inverted ? Edge::Falling : Edge::Rising;
    look_at_place(signal, row.from, at_begin);
    look_at_place(signal, row.to, opposite(at_begin));
  }
  levels_.set(signal, row.is_on_at(motion_.load_to));
}

/// A place of the load at which @p signal has the edge @p upward when it is passed upwards.
void DigitalInputs::look_at_place(Signal signal, double place, Edge upward) noexcept {
  const Way load = load_way(motion_);
  if (!load.passes(place)) return;
  const Way motor = motor_way(motion_);
  const double instant = load.instant_of(place);
  add({.signal = signal,
       .edge = load.is_upward() ? upward : opposite(upward),
       .is_upward = load.is_upward(),
       .instant = instant,
       .position = motor.from + instant * (motor.to - motor.from)},
      0.0);
}

void DigitalInputs::look_for_pulses(Signal signal, const ZeroPlace& place) noexcept {
  const Way way = motor_way(motion_);
  const bool repeats = place.period > 0.0;
  const double step = way.is_upward() ? 1.0 : -1.0;
  // From a place that lies behind the begin, whatever rounding has made of the quotient.
  double turn = repeats ? std::floor((way.from - place.position) / place.period) - step : 0.0;
  for (std::size_t looked = 0; looked < (repeats ? kMostPulses : 1); ++looked, turn += step) {
    const double pulse = place.position + turn * place.period;
    if (!way.passes(pulse)) continue;
    add({.signal = signal,
         .edge = Edge::Pulse,
         .is_upward = way.is_upward(),
         .instant = way.instant_of(pulse),
         .position = pulse},
        kSameInstant);
  }
}

/// Behind all that are earlier, and behind those that are not later by more than @p same_instant.
void DigitalInputs::add(const InputEvent& event, double same_instant) noexcept {
  std::size_t at = count_++;
  for (; at > 0 && events_[at - 1].instant > event.instant + same_instant; --at) events_[at] = events_[at - 1];
  events_[at] = event;
  if (at > 0) events_[at].instant = std::max(event.instant, events_[at - 1].instant);
}

}  // namespace cia402
