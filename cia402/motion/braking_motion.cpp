#include "cia402/motion/braking_motion.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {
namespace {

/// What is left of a velocity (as a share of it) counts as standstill: it does not cross zero with every control.
constexpr double kStandstill = 0.01;

}  // namespace

void BrakingMotion::ramp(const Motion& present, double deceleration) noexcept {
  motion_ = present;
  lead_ = Lead::Position;
  slope_ = deceleration;
  state_ = std::abs(present.velocity) > 0.0 ? State::Ramping : State::Standing;
}

void BrakingMotion::stop_hard(const Motion& present) noexcept {
  const bool moves = std::abs(present.velocity) > 0.0;
  motion_ = present;
  motion_.velocity = 0.0;
  lead_ = moves ? Lead::Velocity : Lead::Position;
  fastest_ = present.velocity;
  state_ = moves ? State::StoppingHard : State::Standing;
}

void BrakingMotion::release_torque(const Motion& present, double slope) noexcept {
  motion_ = present;
  lead_ = Lead::Torque;
  slope_ = slope;
  state_ = std::abs(present.torque) > 0.0 ? State::Releasing : State::Standing;
}

Demand BrakingMotion::cycle(const Actual& actual) noexcept {
  if (lead_ != Lead::Position) motion_.position = actual.position;
  if (lead_ == Lead::Torque)
    motion_.velocity = actual.velocity;
  else
    motion_.torque = actual.torque;
  switch (state_) {
    case State::Ramping:
      ramp_on();
      break;
    case State::StoppingHard:
      stop_on(actual);
      break;
    case State::Releasing:
      release_on();
      break;
    case State::Standing:
      break;
  }
  return {.lead = lead_, .motion = motion_};
}

void BrakingMotion::ramp_on() noexcept {
  const double speed = std::abs(motion_.velocity);
  const double time = std::min(kCycle, speed / slope_);
  const double next = time < kCycle ? 0.0 : motion_.velocity - std::copysign(slope_ * kCycle, motion_.velocity);
  motion_.position += 0.5 * (motion_.velocity + next) * time;
  motion_.velocity = next;
  if (!(std::abs(next) > 0.0)) state_ = State::Standing;
}

void BrakingMotion::stop_on(const Actual& actual) noexcept {
  const double along = std::copysign(1.0, fastest_) * actual.velocity;
  if (along > std::abs(fastest_)) fastest_ = actual.velocity;
  if (along > kStandstill * std::abs(fastest_)) return;
  lead_ = Lead::Position;
  state_ = State::Standing;
}

void BrakingMotion::release_on() noexcept {
  const double step = slope_ * kCycle;
  motion_.torque = std::abs(motion_.torque) > step ? motion_.torque - std::copysign(step, motion_.torque) : 0.0;
  if (!(std::abs(motion_.torque) > 0.0)) state_ = State::Standing;
}

}  // namespace cia402
