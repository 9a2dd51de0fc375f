#include <cmath>
#include <numbers>

#include "motor/circuit.hpp"
#include "motor/control_period.hpp"
#include "motor/plant.hpp"
#include "motor/runge_kutta.hpp"
#include "motor/substeps.hpp"

namespace motor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Steps in a control period without pulses: what the diodes do changes faster than a held voltage.
constexpr int kCoastingParts = 8;
/// Most steps in a control period; a shaft that would need more does not get any faster.
constexpr int kMostParts = 256;

}  // namespace

/// As many parts as asked for, or more where the shaft turns faster than the machine was made for.
int Plant::needed(int parts) const noexcept {
  const double turning = std::abs(state_.speed) * pole_pairs_ * kControlPeriod;
  if (turning <= 1.2 * kElectricalStep * parts) return parts;
  return turning < kElectricalStep * kMostParts ? static_cast<int>(turning / kElectricalStep) + 1 : kMostParts;
}

double Plant::angle() const noexcept {
  return static_cast<double>(state_.revolutions) * kTurn + state_.rotor_angle;
}

void Plant::turn(const Motion& motion) noexcept {
  state_.speed = motion.speed;
  state_.rotor_angle += motion.angle;
  if (state_.rotor_angle >= 0.0 && state_.rotor_angle < kTurn) return;
  const double turns = std::floor(state_.rotor_angle / kTurn);
  state_.rotor_angle -= turns * kTurn;
  state_.revolutions += static_cast<std::int64_t>(turns);
}

template <class M, class S>
void Plant::begin(M& machine, S& shaft, int part, double h) noexcept {
  shaft.begin({static_cast<double>(steps_) * kControlPeriod + part * h, angle()}, machine.torque());
}

template <class Circuit, class M, class S>
void Plant::advance(Circuit& circuit, M& machine, S& shaft, double h) noexcept {
  const auto mean = runge_kutta(circuit, shaft, h);
  machine.set_state(machine.state().moved(mean.circuit, h));
  energies_.electrical += 1.5 * h * mean.circuit.power;
  energies_.copper += h * machine.losses(mean.circuit);
  state_.torque += mean.circuit.torque * h;
  turn(shaft.finish(mean.shaft, h, energies_));
  if constexpr (M::kTurnsWithRotor) {
    const double electrical = pole_pairs_ * state_.rotor_angle;
    direction_ = {std::cos(electrical), std::sin(electrical)};
  }
}

template <class M, class S>
void Plant::finish(const M& machine, S& shaft) noexcept {
  ++steps_;
  const double most = kElectricalStep * kMostParts / (pole_pairs_ * kControlPeriod);
  if (std::abs(state_.speed) > most) [[unlikely]] {
    shaft.set_speed(std::copysign(most, state_.speed));
    state_.speed = shaft.speed();
  }
  state_.torque *= 1.0 / kControlPeriod;
  state_.load_speed = shaft.load_speed();
  state_.twist = shaft.twist();
  const SpaceVector current = machine.current(machine.state());
  state_.current = M::kTurnsWithRotor ? current * direction_ : current;
  state_.flux = machine.main_flux();
}

template <class M, class S>
void Plant::drive(M& machine, S& shaft, SpaceVector voltage) noexcept {
  const int parts = needed(substeps_);
  const double h = parts == 1 ? kControlPeriod : kControlPeriod / parts;
  for (int part = 0; part < parts; ++part) {
    HeldVoltage<M> circuit{machine, voltage, direction_};
    begin(machine, shaft, part, h);
    advance(circuit, machine, shaft, h);
  }
  finish(machine, shaft);
}

template <class M, class S>
void Plant::coast_down(M& machine, S& shaft, double limit) noexcept {
  const int parts = needed(kCoastingParts * substeps_);
  const double h = kControlPeriod / parts;
  for (int part = 0; part < parts; ++part) {
    DiodeVoltage<M> diodes{machine, limit, h};
    const double current = length(machine.current(machine.state()));
    const bool blocks = machine.induced(state_.speed) <= limit && current <= diodes.least_current();
    if (blocks) energies_.electrical -= machine.cut();
    begin(machine, shaft, part, h);
    if (blocks) {
      OpenTerminals<M> open{machine};
      advance(open, machine, shaft, h);
    } else {
      advance(diodes, machine, shaft, h);
    }
  }
  finish(machine, shaft);
}

void Plant::step(SpaceVector voltage) noexcept {
  if (brake_delay_ > 0 && --brake_delay_ == 0) apply_brake();
  energies_ = {};
  state_.torque = 0.0;
  std::visit([&](auto& machine, auto& shaft) { drive(machine, shaft, voltage); }, machine_, shaft_);
}

void Plant::coast(double dc_voltage) noexcept {
  if (brake_delay_ > 0 && --brake_delay_ == 0) apply_brake();
  energies_ = {};
  state_.torque = 0.0;
  const double limit = dc_voltage > 0.0 ? dc_voltage / std::numbers::sqrt3 : 0.0;
  std::visit([&](auto& machine, auto& shaft) { coast_down(machine, shaft, limit); }, machine_, shaft_);
}

}  // namespace motor
