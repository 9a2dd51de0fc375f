#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/math/processor_variants.hpp"
#include "motor/plant/plant.hpp"

namespace motor {
namespace {

/// Steps in a control period without pulses: what the diodes do changes faster than a held voltage.
constexpr int kCoastingParts = 8;

}  // namespace

template <class M, class S>
MOTOR_PROCESSOR_VARIANTS void Plant::drive(M& machine, S& shaft, SpaceVector voltage) noexcept {
  motion_.drive(machine, shaft, profile_, voltage);
  motion_.show(machine, shaft);
}

template <class M, class S>
void Plant::coast_down(M& machine, S& shaft, double limit) noexcept {
  const double parts = motion_.needed(kCoastingParts * motion_.substeps);
  const double h = kControlPeriod / parts;
  PlantMotion<double>::Spent spent;
  for (double part = 0.0; part < parts; part += 1.0) {
    DiodeVoltage<M> diodes{machine, limit, h};
    const double current = length(vector(machine.current(machine.state())));
    const bool blocks = machine.induced(motion_.state.speed) <= limit && current <= diodes.least_current();
    if (blocks) spent.energies.electrical -= machine.cut();
    motion_.begin(shaft, profile_, part * h, shaft.stands() ? machine.torque() : 0.0);
    OpenTerminals<M> open{machine};
    const auto sum = blocks ? runge_kutta(open, shaft, h) : runge_kutta(diodes, shaft, h);
    spent += motion_.advance(sum, machine, shaft, h);
  }
  motion_.finish(spent, machine);
  motion_.show(machine, shaft);
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
  motion_.pass();
  motion_.energies = {};
  motion_.state.torque = 0.0;
}

void Plant::coast(double dc_voltage) noexcept {
  start_period();
  if (rests()) return stand();
  const double limit = dc_voltage > 0.0 ? dc_voltage / std::numbers::sqrt3 : 0.0;
  std::visit([&](auto& machine, auto& shaft) { coast_down(machine, shaft, limit); }, machine_, shaft_);
}

}  // namespace motor
