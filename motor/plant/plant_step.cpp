#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/data/control_period.hpp"
#include "motor/math/processor_variants.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/machine/circuit.hpp"
#include "motor/plant/plant.hpp"
#include "motor/plant/substeps.hpp"

namespace motor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Steps in a control period without pulses: what the diodes do changes faster than a held voltage.
constexpr int kCoastingParts = 8;
/// Control periods until the direction of the rotor is calculated from its angle again.
constexpr std::int64_t kTurnsFromDirection = 16;

/// Rates of a step in which saturation counts.
template <class S>
[[gnu::noinline]] auto saturated_rates(const SynchronousMachine& machine, const S& shaft, SpaceVector voltage,
                                       SpaceVector direction, double h) noexcept {
  HeldVoltage<SynchronousMachine, true> circuit{machine, voltage, direction};
  return runge_kutta(circuit, shaft, h);
}

/// Rates under a held voltage: without saturation, unless the step begins or ends in it.
template <class S>
[[gnu::always_inline]] inline auto held_rates(const SynchronousMachine& machine, const S& shaft,
                                              SpaceVector voltage, SpaceVector direction, double h) noexcept {
  if (!machine.is_saturated(machine.state())) [[likely]] {
    HeldVoltage<SynchronousMachine, false> circuit{machine, voltage, direction};
    const auto sum = runge_kutta(circuit, shaft, h);
    if (!machine.is_saturated(machine.state().moved(sum.circuit, stage_weight(h)))) [[likely]]
      return sum;
  }
  return saturated_rates(machine, shaft, voltage, direction, h);
}
template <class S>
[[gnu::always_inline]] inline auto held_rates(const InductionMachine& machine, const S& shaft, SpaceVector voltage,
                                              SpaceVector direction, double h) noexcept {
  HeldVoltage<InductionMachine> circuit{machine, voltage, direction};
  return runge_kutta(circuit, shaft, h);
}

}  // namespace

/// As many parts as asked for, or more where the shaft turns faster than the machine was made for: the bursting
/// speed bounds them.
int Plant::needed(int parts) const noexcept {
  const double turning = std::abs(state_.speed) * pole_pairs_ * kControlPeriod;
  return turning <= kElectricalStep * parts ? parts : static_cast<int>(turning * (1.0 / kElectricalStep)) + 1;
}

/// Speed of the rotor that @p parts in a control period can follow (rad/s).
double Plant::followed_speed(int parts) const noexcept {
  return kElectricalStep * parts / (pole_pairs_ * kControlPeriod);
}

double Plant::angle() const noexcept {
  return static_cast<double>(state_.revolutions) * kTurn + state_.rotor_angle;
}

[[gnu::always_inline]] inline void Plant::turn(const Motion& motion) noexcept {
  state_.speed = motion.speed;
  state_.rotor_angle += motion.angle;
  if (state_.rotor_angle >= 0.0 && state_.rotor_angle < kTurn) return;
  const double turns = std::floor(state_.rotor_angle / kTurn);
  state_.rotor_angle -= turns * kTurn;
  state_.revolutions += static_cast<std::int64_t>(turns);
}

template <class S>
[[gnu::always_inline]] inline void Plant::begin(S& shaft, int part, double h, double torque) noexcept {
  StepStart start{};
  if constexpr (!S::kPlain) start = {static_cast<double>(steps_) * kControlPeriod + part * h, angle()};
  shaft.begin(start, torque);
}

/// By small turns, and now and then from the angle itself, before their errors count (5e-7 at maximum speed).
[[gnu::always_inline]] inline void Plant::turn_direction(double angle) noexcept {
  if (steps_ % kTurnsFromDirection == 0) [[unlikely]]
    direction_ = unit_vector(pole_pairs_ * state_.rotor_angle);
  else
    direction_ = turned_a_little(direction_, pole_pairs_ * angle);
}

/// No shaft turns faster than its rotor holds: the energy of what goes beyond is lost as friction.
template <class Rates, class M, class S>
[[gnu::always_inline]] inline Plant::Spent Plant::advance(const Rates& sum, M& machine, S& shaft,
                                                          double h) noexcept {
  const double weight = stage_weight(h);
  Spent spent;
  machine.set_state(machine.state().moved(sum.circuit, weight));
  spent.energies.electrical = 1.5 * weight * motor::sum(sum.circuit.power);
  spent.energies.copper = machine.losses(sum.circuit, weight);
  spent.torque = weight * (1.0 / kControlPeriod) * sum.circuit.torque;
  Motion motion = shaft.finish(sum.shaft, h, spent.energies);
  if (shaft.is_beyond(motion, bursting_speed_)) [[unlikely]] {
    spent.energies.friction += shaft.slow_down(bursting_speed_);
    motion.speed = shaft.speed();
    motion.angle = std::clamp(motion.angle, -bursting_speed_ * h, bursting_speed_ * h);
  }
  turn(motion);
  if constexpr (M::kTurnsWithRotor) turn_direction(motion.angle);
  return spent;
}

template <class M, class S>
[[gnu::always_inline]] inline void Plant::finish(const Spent& spent, const M& machine, const S& shaft) noexcept {
  ++steps_;
  energies_ = spent.energies;
  state_.torque = spent.torque;
  state_.load_speed = shaft.load_speed();
  state_.twist = shaft.twist();
  const SpaceVector current = vector(machine.current(machine.state()));
  state_.current = M::kTurnsWithRotor ? current * direction_ : current;
  state_.flux = machine.main_flux();
}

template <class M, class S>
[[gnu::always_inline]] inline Plant::Spent Plant::drive_part(M& machine, S& shaft, SpaceVector voltage, int part,
                                                             double h) noexcept {
  begin(shaft, part, h, shaft.stands() ? machine.torque() : 0.0);
  return advance(held_rates(machine, shaft, voltage, direction_, h), machine, shaft, h);
}

/// A control period in @p parts.
template <class M, class S>
[[gnu::noinline]] Plant::Spent Plant::drive_parts(M& machine, S& shaft, SpaceVector voltage, int parts) noexcept {
  Spent spent;
  for (int part = 0; part < parts; ++part)
    spent += drive_part(machine, shaft, voltage, part, kControlPeriod / parts);
  return spent;
}

template <class M, class S>
MOTOR_PROCESSOR_VARIANTS void Plant::drive(M& machine, S& shaft, SpaceVector voltage) noexcept {
  const bool whole = std::abs(state_.speed) <= whole_step_speed_;
  const Spent spent = whole ? drive_part(machine, shaft, voltage, 0, kControlPeriod)
                            : drive_parts(machine, shaft, voltage, needed(substeps_));
  finish(spent, machine, shaft);
}

template <class M, class S>
void Plant::coast_down(M& machine, S& shaft, double limit) noexcept {
  const int parts = needed(kCoastingParts * substeps_);
  const double h = kControlPeriod / parts;
  Spent spent;
  for (int part = 0; part < parts; ++part) {
    DiodeVoltage<M> diodes{machine, limit, h};
    const double current = length(vector(machine.current(machine.state())));
    const bool blocks = machine.induced(state_.speed) <= limit && current <= diodes.least_current();
    if (blocks) spent.energies.electrical -= machine.cut();
    begin(shaft, part, h, shaft.stands() ? machine.torque() : 0.0);
    OpenTerminals<M> open{machine};
    spent += advance(blocks ? runge_kutta(open, shaft, h) : runge_kutta(diodes, shaft, h), machine, shaft, h);
  }
  finish(spent, machine, shaft);
}

[[gnu::always_inline]] inline void Plant::start_period() noexcept {
  if (brake_delay_ > 0 && --brake_delay_ == 0) [[unlikely]]
    apply_brake();
}

MOTOR_PROCESSOR_VARIANTS void Plant::step(SpaceVector voltage) noexcept {
  start_period();
  // The usual one first, past the table that std::visit looks up.
  auto* const machine = std::get_if<SynchronousMachine>(&machine_);
  auto* const shaft = std::get_if<RigidShaft<true>>(&shaft_);
  if (machine != nullptr && shaft != nullptr) return drive(*machine, *shaft, voltage);
  std::visit([&](auto& any_machine, auto& any_shaft) { drive(any_machine, any_shaft, voltage); }, machine_,
             shaft_);
}

/// A period in which nothing happens.
void Plant::stand() noexcept {
  ++steps_;
  energies_ = {};
  state_.torque = 0.0;
}

void Plant::coast(double dc_voltage) noexcept {
  start_period();
  if (rests()) return stand();
  const double limit = dc_voltage > 0.0 ? dc_voltage / std::numbers::sqrt3 : 0.0;
  std::visit([&](auto& machine, auto& shaft) { coast_down(machine, shaft, limit); }, machine_, shaft_);
}

}  // namespace motor
