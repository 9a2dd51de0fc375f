#include "motor/plant/plant.hpp"

#include <algorithm>
#include <cmath>

#include "motor/data/control_period.hpp"
#include "motor/plant/substeps.hpp"

namespace motor {

Plant::Machine Plant::made_machine(const MachineData& machine) noexcept {
  if (machine.type == MachineType::Induction) return InductionMachine{machine};
  return SynchronousMachine{machine};
}

Plant::Shaft Plant::made_shaft(const MachineData& machine, const Load& load) noexcept {
  if (is_elastic(load)) return ElasticShaft{machine, load};
  const RigidShaft<false> rigid{machine, load};
  if (rigid.is_plain()) return RigidShaft<true>{machine, load};
  return rigid;
}

Plant::Plant(const MachineData& machine, const Load& load, int substeps) noexcept
    : machine_{made_machine(machine)},
      shaft_{made_shaft(machine, load)},
      substeps_{substeps > 0 ? substeps : needed_substeps(machine, load)},
      pole_pairs_{static_cast<double>(machine.pole_pairs)},
      bursting_speed_{bursting_speed(machine)},
      whole_step_speed_{substeps_ == 1 ? followed_speed(1) : -1.0},
      brake_{load.brake} {
  apply_brake();
  state_.flux = std::visit([](const auto& m) { return m.main_flux(); }, machine_);
}

StoredEnergy Plant::stored() const noexcept {
  return {.magnetic = std::visit([](const auto& machine) { return machine.stored(); }, machine_),
          .kinetic = std::visit([](const auto& shaft) { return shaft.kinetic(); }, shaft_),
          .spring = std::visit([this](const auto& shaft) { return shaft.spring(angle()); }, shaft_)};
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
  substeps_ = needed_substeps(machine, load);
  whole_step_speed_ = substeps_ == 1 ? followed_speed(1) : -1.0;
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
  const double speed = std::clamp(wanted, -bursting_speed_, bursting_speed_);
  std::visit([&](auto& shaft) { shaft.set_speed(speed); }, shaft_);
  state_.speed = speed;
  state_.load_speed = speed;
}

void Plant::set_fluxes(const MachineFluxes& fluxes) noexcept {
  auto* const machine = std::get_if<InductionMachine>(&machine_);
  if (machine == nullptr) return;
  machine->set_state({pair(fluxes.stator), pair(fluxes.rotor)});
  state_.current = vector(machine->current(machine->state()));
  state_.flux = machine->main_flux();
}

double Plant::load_torque() const noexcept {
  return std::visit([](const auto& shaft) { return shaft.load_torque(); }, shaft_);
}

bool Plant::rests() const noexcept {
  const bool open = norm(state_.current) == 0.0 && brake_delay_ == 0 && norm(fluxes().rotor) == 0.0;
  return open && std::visit([this](const auto& shaft) { return shaft.rests(angle()); }, shaft_);
}

}  // namespace motor
