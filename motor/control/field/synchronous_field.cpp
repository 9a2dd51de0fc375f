#include "motor/control/field/synchronous_field.hpp"

#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kTrimPeriod = 1e-3;  // s, at most

}  // namespace

template <>
void SynchronousField<double>::configure(const MachineData& machine, const ControlSettings& settings) noexcept {
  pole_pairs_ = machine.pole_pairs;
  resistance_ = machine.stator_resistance;
  reference_.configure(machine, std::numbers::sqrt2 * settings.current_limit);
  reachable_ = reference_.highest_torque();
  near_limit_ = true;
  speeding_up_ = kTrimPeriod * pole_pairs_ * 2.0 * reachable_ / settings.inertia;
  observer_.configure(machine, kControlPeriod);
  // The rotor on a fed current is a spring with the shaft as its mass: damped to about 0.7.
  const double amplitude = std::numbers::sqrt2 * settings.start_current;
  const double stiffness = 1.5 * pole_pairs_ * pole_pairs_ * reference_.magnet_flux();
  damping_ = 1.4 * std::sqrt(settings.inertia * amplitude / stiffness);
}

template <>
void SynchronousField<double>::start() noexcept {
  reserve_.reset();
  setpoint_ = {};
  near_limit_ = true;
  swing_ = 0.0;
  weakening_ = false;
}

}  // namespace motor
