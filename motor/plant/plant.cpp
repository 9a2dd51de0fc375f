#include "motor/plant/plant.hpp"

#include <algorithm>
#include <cmath>

#include "motor/data/control_period.hpp"
#include "motor/plant/substeps.hpp"

namespace motor {

namespace {

/// Whether nothing but a constant torque hangs on it, and no wall is near.
bool is_plain(const Load& load) noexcept {
  const bool walls = std::isfinite(load.end_stops.lower) || std::isfinite(load.end_stops.upper);
  return !(load.fan_coefficient > 0.0 || load.pendulum_torque != 0.0 || load.profile.count > 0 || walls);
}

}  // namespace

Plant::Machine Plant::made_machine(const MachineData& machine) noexcept {
  if (machine.type == MachineType::Induction) return InductionMachine{machine};
  return SynchronousMachine{machine};
}

Plant::Shaft Plant::made_shaft(const MachineData& machine, const Load& load) noexcept {
  if (is_elastic(load)) return ElasticShaft{machine, load};
  if (is_plain(load)) return RigidShaft<true>{machine, load};
  return RigidShaft<false>{machine, load};
}

Plant::Plant(const MachineData& machine, const Load& load, int substeps) noexcept
    : machine_{made_machine(machine)},
      shaft_{made_shaft(machine, load)},
      profile_{load.profile},
      brake_{load.brake} {
  motion_.pole_pairs = machine.pole_pairs;
  motion_.bursting_speed = bursting_speed(machine);
  set_substeps(substeps > 0 ? substeps : needed_substeps(machine, load));
  apply_brake();
  motion_.state.flux = std::visit([](const auto& m) { return m.main_flux(); }, machine_);
}

StoredEnergy Plant::stored() const noexcept {
  return {.magnetic = std::visit([](const auto& machine) { return machine.stored(); }, machine_),
          .kinetic = std::visit([](const auto& shaft) { return shaft.kinetic(); }, shaft_),
          .spring = std::visit([this](const auto& shaft) { return shaft.spring(motion_.angle()); }, shaft_)};
}

MachineFluxes Plant::fluxes() const noexcept {
  const auto* const machine = std::get_if<InductionMachine>(&machine_);
  if (machine == nullptr) return {};
  return {vector(machine->state().stator), vector(machine->state().rotor)};
}

void Plant::set_temperatures(double winding, double rotor) noexcept {
  std::visit([&](auto& machine) { machine.set_temperatures(winding, rotor); }, machine_);
}

void Plant::set_load_torque(double torque, LoadTorqueType type) noexcept {
  const bool friction = type == LoadTorqueType::Friction;
  std::visit([&](auto& shaft) { shaft.set_load(friction ? 0.0 : torque, friction ? torque : 0.0); }, shaft_);
}

void Plant::set_body(const MachineData& machine, const Load& load) noexcept {
  std::visit([&](auto& shaft) { shaft.set_body(machine, load); }, shaft_);
  set_substeps(needed_substeps(machine, load));
}

void Plant::set_substeps(int substeps) noexcept {
  motion_.substeps = substeps;
  motion_.whole_step_speed = substeps == 1 ? kElectricalStep / (motion_.pole_pairs * kControlPeriod) : -1.0;
}

void Plant::set_brake(bool closed) noexcept {
  const bool exists = brake_.torque > 0.0;
  if (!exists || closed == brake_closed_) return;
  brake_closed_ = closed;
  brake_delay_ =
      static_cast<int>(std::lround((closed ? brake_.closing_time : brake_.opening_time) / kControlPeriod));
  if (brake_delay_ == 0) apply_brake();
}

void Plant::apply_brake() noexcept {
  const double torque = brake_closed_ ? brake_.torque : 0.0;
  std::visit([&](auto& shaft) { shaft.set_brake(torque); }, shaft_);
}

void Plant::set_speed(double wanted) noexcept {
  const double speed = std::clamp(wanted, -motion_.bursting_speed, motion_.bursting_speed);
  std::visit([&](auto& shaft) { shaft.set_speed(speed); }, shaft_);
  motion_.state.speed = speed;
  motion_.state.load_speed = speed;
}

void Plant::set_fluxes(const MachineFluxes& fluxes) noexcept {
  auto* const machine = std::get_if<InductionMachine>(&machine_);
  if (machine == nullptr) return;
  machine->set_state({pair(fluxes.stator), pair(fluxes.rotor)});
  motion_.state.current = vector(machine->current(machine->state()));
  motion_.state.flux = machine->main_flux();
}

double Plant::load_torque() const noexcept {
  return std::visit([](const auto& shaft) { return shaft.load_torque(); }, shaft_);
}

bool Plant::rests() const noexcept {
  const bool open = norm(motion_.state.current) == 0.0 && brake_delay_ == 0 && norm(fluxes().rotor) == 0.0;
  return open && profile_.over() &&
         std::visit([this](const auto& shaft) { return shaft.rests(motion_.angle()); }, shaft_);
}

}  // namespace motor
