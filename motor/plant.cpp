#include "motor/plant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/control_period.hpp"

namespace motor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Largest product of a step and a rate that it must follow.
constexpr double kLargestStep = 0.6;

int needed_substeps(const MachineData& machine, const Load& load) noexcept {
  const double inductance = std::min(machine.synchronous.d_inductance, machine.synchronous.q_inductance);
  const double fastest =
      std::max({machine.stator_resistance / inductance, machine.pole_pairs * machine.maximum_speed,
                load.end_stops.stiffness > 0.0 ? 0.0 : 0.0});
  return std::max(1, static_cast<int>(std::ceil(kControlPeriod * fastest / kLargestStep)));
}

}  // namespace

Plant::Plant(const MachineData& machine, const Load& load, int substeps) noexcept
    : synchronous_{machine},
      plain_{machine, load},
      rigid_{machine, load},
      kind_{rigid_.is_plain() ? Kind::SynchronousPlain : Kind::SynchronousRigid},
      substeps_{substeps > 0 ? substeps : needed_substeps(machine, load)},
      substep_{kControlPeriod / substeps_} {
  state_.flux = synchronous_.flux(currents_).re;
}

double Plant::angle() const noexcept {
  return static_cast<double>(state_.revolutions) * kTurn + state_.rotor_angle;
}

template <class Shaft>
void Plant::take_over(const Shaft& shaft, const Motion& motion) noexcept {
  state_.speed = motion.speed;
  state_.load_speed = shaft.load_speed();
  state_.twist = shaft.twist();
  state_.rotor_angle += motion.angle;
  if (state_.rotor_angle < 0.0 || state_.rotor_angle >= kTurn) {
    const double turns = std::floor(state_.rotor_angle / kTurn);
    state_.rotor_angle -= turns * kTurn;
    state_.revolutions += static_cast<std::int64_t>(turns);
  }
}

template <class Shaft>
void Plant::step_synchronous(Shaft& shaft, SpaceVector voltage) noexcept {
  energies_ = {};
  double torque = 0.0;
  for (int i = 0; i < substeps_; ++i) {
    HeldSynchronous circuit{synchronous_, currents_, voltage * conjugate(direction_)};
    shaft.begin({(static_cast<double>(steps_) + static_cast<double>(i) / substeps_) * kControlPeriod, angle()},
                synchronous_.torque(currents_));
    const auto mean = runge_kutta(circuit, shaft, substep_);
    currents_ = currents_.moved(mean.circuit, substep_);
    energies_.electrical += 1.5 * substep_ * mean.circuit.power;
    energies_.copper += 1.5 * substep_ * synchronous_.resistance() * mean.circuit.heating;
    torque += mean.circuit.torque;
    take_over(shaft, shaft.finish(mean.shaft, substep_, energies_));
    const double electrical = synchronous_.pole_pairs() * state_.rotor_angle;
    direction_ = {std::cos(electrical), std::sin(electrical)};
  }
  ++steps_;
  state_.torque = torque / substeps_;
  state_.current = SpaceVector{currents_.i_d, currents_.i_q} * direction_;
  state_.flux = synchronous_.flux(currents_).re;
}

void Plant::step(SpaceVector voltage) noexcept {
  switch (kind_) {
    case Kind::SynchronousPlain:
      return step_synchronous(plain_, voltage);
    case Kind::SynchronousRigid:
      return step_synchronous(rigid_, voltage);
  }
}

void Plant::coast(double dc_voltage) noexcept {
  currents_ = {};
  step({});
  static_cast<void>(dc_voltage);
}

StoredEnergy Plant::stored() const noexcept {
  return {.magnetic = synchronous_.stored(currents_),
          .kinetic = kind_ == Kind::SynchronousPlain ? plain_.kinetic() : rigid_.kinetic(),
          .spring = rigid_.spring(angle())};
}

void Plant::set_temperatures(double winding, double rotor) noexcept {
  synchronous_.set_temperatures(winding, rotor);
}

void Plant::set_load_torque(double torque) noexcept {
  plain_.set_load_torque(torque);
  rigid_.set_load_torque(torque);
}

void Plant::set_brake(bool) noexcept {}

void Plant::set_speed(double speed) noexcept {
  plain_.set_speed(speed);
  rigid_.set_speed(speed);
  state_.speed = speed;
  state_.load_speed = speed;
}

bool Plant::rests() const noexcept {
  return currents_.i_d == 0.0 && currents_.i_q == 0.0 &&
         (kind_ == Kind::SynchronousPlain ? plain_.rests(angle()) : rigid_.rests(angle()));
}

}  // namespace motor
