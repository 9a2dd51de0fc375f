#include "motor/identification/rotating/inertia_test.hpp"

#include <cmath>

#include "motor/identification/rotating/test_speeds.hpp"

namespace motor {
namespace {

constexpr double kHold = 0.1;          // s
constexpr double kLeastOfRotor = 0.3;  // of the rotor's believed inertia: less cannot be
constexpr int kLeastBlocks = 50;

}  // namespace

SpeedPlan InertiaTest::start(const RotatingTask& task, const RotatingFindings& found) noexcept {
  *this = {};
  // Without encoder what happens about standstill would disturb the flux of the ramps.
  both_directions_ = task.forward && task.backward && task.settings.mode == ControlMode::Encoder;
  rotor_inertia_ = task.machine.inertia;
  // One direction alone does not tell the threshold voltage from a load well.
  threshold_known_ = !both_directions_ && found.result.threshold_voltage > 0.0;
  threshold_voltage_ = found.result.threshold_voltage;
  const TestSpeeds speeds = test_speeds(task, found.dc_voltage);
  if (!speeds.useful()) return {};
  least_speed_ = speeds.least;
  const double direction = first_direction(task);
  const double other = both_directions_ ? -direction * speeds.high : direction * speeds.least;
  SpeedPlan plan;
  for (int ramps = 0; ramps < 3; ++ramps) {
    plan.add({.speed = direction * speeds.high, .hold = kHold});
    plan.add({.speed = other, .hold = kHold});
  }
  return plan;
}

void InertiaTest::begin_pass() noexcept {
  shaft_.end_group();
  angle_ = time_ = impulse_ = lost_impulse_ = 0.0;
}

void InertiaTest::take(const FieldBlock& block, const SpeedPlace& /*place*/) noexcept {
  const double speed = block.speed();
  if (std::abs(speed) < least_speed_) return begin_pass();
  const double time = time_ + 0.5 * block.duration;
  const double impulse = impulse_ + block.impulse.mean;
  const double lost = lost_impulse_ + block.lost_impulse.mean;
  const double known = threshold_known_ ? threshold_voltage_ * lost : 0.0;
  shaft_.add({speed, angle_ + block.angle.mean, time, std::copysign(time, speed), lost}, impulse - known);
  angle_ += block.angle.total;
  time_ += block.duration;
  impulse_ += block.impulse.total;
  lost_impulse_ += block.lost_impulse.total;
}

bool InertiaTest::finish(RotatingFindings& found) noexcept {
  begin_pass();
  const auto shaft = shaft_.solve({true, true, true, both_directions_, !threshold_known_});
  if (!shaft || shaft_.count() < kLeastBlocks) return false;
  const auto [inertia, viscous, constant, dry, threshold] = *shaft;
  if (!(inertia > kLeastOfRotor * rotor_inertia_)) return false;
  found.result.inertia = inertia;
  found.result.viscous_friction = viscous;
  found.result.load_torque = constant;
  found.result.coulomb_friction = dry;
  return true;
}

}  // namespace motor
