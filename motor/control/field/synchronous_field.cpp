#include "motor/control/field/synchronous_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kTrimPeriod = 1e-3;  // s, at most
constexpr double kSwingTime = 2e-3;   // s, the voltages of changing currents are not the rotor's

}  // namespace

void SynchronousField::configure(const MachineData& machine, const ControlSettings& settings) noexcept {
  pole_pairs_ = machine.pole_pairs;
  resistance_ = machine.stator_resistance;
  current_limit_ = std::numbers::sqrt2 * settings.current_limit;
  reference_.configure(machine, current_limit_);
  reachable_ = reference_.highest_torque();
  near_limit_ = true;
  speeding_up_ = kTrimPeriod * pole_pairs_ * 2.0 * reachable_ / settings.inertia;
  observer_.configure(machine, kControlPeriod);
  // The rotor on a fed current is a spring with the shaft as its mass: damped to about 0.7.
  const double amplitude = std::numbers::sqrt2 * settings.start_current;
  const double stiffness = 1.5 * pole_pairs_ * pole_pairs_ * reference_.magnet_flux();
  damping_ = 1.4 * std::sqrt(settings.inertia * amplitude / stiffness);
}

void SynchronousField::start() noexcept {
  reserve_.reset();
  setpoint_ = {};
  near_limit_ = true;
  swing_ = 0.0;
  weakening_ = false;
}

double SynchronousField::lag(double torque, double amplitude) const noexcept {
  const double most = pull(amplitude);
  return most > 0.0 ? std::clamp(torque / most, -0.9, 0.9) : 0.0;
}

double SynchronousField::damping(const Frame& frame) noexcept {
  const SpaceVector induced = observer_.induced();
  const double turning =
      std::copysign(length(induced), cross(frame.direction, induced)) / observer_.followed_flux();
  swing_ += kControlPeriod / kSwingTime * (frame.frequency - turning - swing_);
  return damping_ * swing_;
}

void SynchronousField::trim(double dt, double demand, double highest, double frequency) noexcept {
  const double drop = resistance_ * std::max(0.0, std::copysign(1.0, frequency) * setpoint_.im);
  reserve_.follow(dt, demand, highest, drop, weakening_);
  near_limit_ = reference_.full_flux() * (std::abs(frequency) + speeding_up_) > reserve_.room();
  weakening_ = weakening_ && near_limit_;
  const double fastest = std::max(std::abs(frequency), 1e-3);
  reachable_ = reference_.highest_torque(reserve_.room() / fastest);
}

}  // namespace motor
