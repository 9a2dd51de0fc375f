#include "cia402/modes/homing/homing.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {
namespace {

constexpr std::uint16_t kStart = 1U << 4U;
constexpr std::uint16_t kHalt = 1U << 8U;

}  // namespace

void Homing::enter(const Motion& present) noexcept {
  ramp_.place(present.position, present.velocity);
  is_led_outside_ = has_started_ = false;
}

void Homing::resume(const Motion& present) noexcept {
  ramp_.place(present.position, present.velocity);
  is_led_outside_ = false;
  if (state_ == State::Searching) interrupt();
}

void Homing::leave(HomingExit exit) noexcept {
  if (is_running()) {
    if (exit == HomingExit::Fault)
      fail(HomingError::Fault);
    else
      interrupt();
  }
  if (exit == HomingExit::OtherMode) state_ = State::Ready;
  is_led_outside_ = true;
}

void Homing::controlword(std::uint16_t word, std::uint16_t former, const HomingSettings& settings) noexcept {
  const bool stops = (word & kHalt) != 0 || (word & kStart) == 0;
  const bool stopped = (former & kHalt) != 0 || (former & kStart) == 0;
  if ((word & kHalt) != 0) is_led_outside_ = true;
  if (stops && is_running()) interrupt();
  if (!stops && stopped) start(settings);
}

void Homing::start(const HomingSettings& settings) noexcept {
  settings_ = settings;
  state_ = State::Starting;
  error_ = HomingError::None;
  has_started_ = true;
}

void Homing::interrupt() noexcept {
  state_ = State::Interrupted;
}

void Homing::fail(HomingError error) noexcept {
  state_ = State::Failed;
  error_ = error;
}

void Homing::attain(double position) noexcept {
  state_ = State::Attained;
  is_homed_ = true;
  home_ = Home{.position = position, .offset = settings_.offset};
}

Demand Homing::cycle(const HomingSettings& settings, const Limits& limits, const DigitalInputs& inputs) noexcept {
  if (state_ == State::Starting)
    begin(inputs);
  else if (state_ == State::Searching)
    follow(inputs);
  const double wanted = wanted_velocity();
  const double velocity = std::clamp(wanted, -limits.velocity, limits.velocity);
  const double braking = has_started_ ? settings_.acceleration : settings.deceleration;
  ramp_.advance(velocity, {.acceleration = std::min(settings_.acceleration, limits.acceleration),
                           .deceleration = std::min(braking, limits.deceleration)});
  return {.lead = Lead::Position,
          .motion = {.position = ramp_.position(), .velocity = ramp_.velocity()},
          .is_limited = std::abs(wanted) > limits.velocity};
}

/// The first cycle after the start: what has happened before it is over.
void Homing::begin(const DigitalInputs& inputs) noexcept {
  method_ = find_homing_method(settings_.method);
  if (method_ == nullptr) return fail(HomingError::Method);
  state_ = State::Searching;
  last_event_ = inputs.motion().load_to;
  if (method_->way == HomingMethod::Way::Rest) return follow(inputs);
  search_.begin(*method_, inputs.levels(), inputs.motion().end());
  look_at_search();
}

void Homing::follow(const DigitalInputs& inputs) noexcept {
  if (method_->way == HomingMethod::Way::Rest) {
    if (ramp_.stands()) attain(inputs.motion().end());
    return;
  }
  const double place = inputs.motion().load_to;
  for (const InputEvent& event : inputs.events())
    if (search_.follow(event)) last_event_ = place;
  look_at_search();
  if (is_running() && std::abs(place - last_event_) > settings_.longest_search) fail(HomingError::NoEvent);
}

void Homing::look_at_search() noexcept {
  if (search_.has_found()) attain(search_.home());
  if (search_.has_failed()) fail(HomingError::LimitSwitch);
}

/// Signed (position units/s); 0 stays where it comes to rest.
double Homing::wanted_velocity() const noexcept {
  if (state_ != State::Searching || method_->way == HomingMethod::Way::Rest) return 0.0;
  return sign_of(search_.direction()) * (search_.is_slow() ? settings_.zero_speed : settings_.switch_speed);
}

ModeBits Homing::bits(bool is_stopping) const noexcept {
  const bool stands = is_led_outside_ ? !is_stopping : ramp_.stands();
  switch (state_) {
    case State::Starting:
    case State::Searching:
      return {};
    case State::Ready:
      return {.bit_10 = !is_stopping, .bit_12 = is_homed_};
    case State::Interrupted:
      return {.bit_10 = stands};
    case State::Attained:
      return {.bit_10 = stands, .bit_12 = true};
    case State::Failed:
      return {.bit_10 = stands, .bit_13 = true};
  }
  return {};
}

}  // namespace cia402
