#include "drive/axis/axis.hpp"

#include <numbers>

#include "motor/plant/dc_link.hpp"

namespace drive {
namespace {

/// A block of a new axis of @p context.
template <class Block>
Block made(const ObjectContext& context) noexcept {
  const AxisConfiguration& axis = context.axis;
  if constexpr (std::is_same_v<Block, MotorModel>)
    return MotorModel{axis.machine};
  else if constexpr (std::is_same_v<Block, PowerUnit>)
    return PowerUnit{axis.inverter, context.supply, motor::DcLink{context.supply}.voltage()};
  else if constexpr (std::is_same_v<Block, Measurement>)
    return Measurement{2.0 * std::numbers::pi / motor::increments_per_revolution(axis.machine)};
  else if constexpr (std::is_same_v<Block, ActualPosition>)
    return ActualPosition{axis.machine.encoder};
  else if constexpr (std::is_same_v<Block, Positioner>)
    return Positioner{axis.positioner};
  else
    return Block{};
}

template <class... Block>
std::tuple<Block...> blocks_of(const ObjectContext& context, const std::tuple<Block...>*) noexcept {
  return {made<Block>(context)...};
}

}  // namespace

Axis::Axis(const AxisConfiguration& configuration, std::uint8_t module, std::uint8_t node_id,
           const motor::SupplyData& supply, bool has_infeed)
    : DriveObject{{.kind = configuration.kind,
                   .module = module,
                   .node_id = node_id,
                   .axis = configuration,
                   .supply = supply,
                   .has_infeed = has_infeed}},
      modules_{function_module::of_new(configuration)},
      blocks_{blocks_of(context(), static_cast<const AxisBlocks*>(nullptr))},
      plant_{.load_inertia = configuration.load.inertia,
             .coulomb_friction = configuration.load.coulomb_friction,
             .viscous_friction = configuration.load.viscous_friction,
             .ambient = configuration.machine.thermal.ambient},
      train_{configuration.machine, motor::real_machine(configuration.machine, configuration.deviation),
             configuration.load, configuration.inverter} {
  commission();
  restore_parameters();
}

double Axis::load_place() const noexcept {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const motor::PlantState& plant = train_.plant_state();
  const double motor = plant.revolutions + (plant.rotor_angle - plant.twist) / kTurn;
  return motor / context().axis.mechanics.ratio();
}

bool Axis::is_quiescent() const noexcept {
  return settled_ && !block<SequenceControl>().pulses_enabled() && train_.rests() && !causes_.any_present() &&
         !waits_for_power() && !block<SpeedMessages>().awaits_target() && !block<OperatorPanel>().is_active() &&
         (!positions() || block<Positioner>().is_settled());
}

void Axis::set_load_torque(double torque, motor::LoadTorqueType type) noexcept {
  train_.set_load_torque(torque, type);
  settled_ = false;
}

void Axis::set_plant(const motor::PlantSettings& settings) noexcept {
  const AxisConfiguration& configuration = context().axis;
  motor::Load load = configuration.load;
  load.inertia = settings.load_inertia;
  load.coulomb_friction = settings.coulomb_friction;
  load.viscous_friction = settings.viscous_friction;
  train_.set_body(motor::real_machine(configuration.machine, configuration.deviation), load);
  train_.set_ambient(settings.ambient);
  plant_ = settings;
  settled_ = false;
}

void Axis::fail_encoder(motor::EncoderDefect defect) noexcept {
  train_.inject(defect);
  settled_ = false;
}

void Axis::set_function_modules(function_module::Set wanted) noexcept {
  modules_ = (wanted & function_module::possible(kind())) | function_module::always(kind()) |
             function_module::configured(context().axis);
  if (!has_setpoint_channel()) block<Jog>().power_off();
  on_parameters_changed();
  apply_parameters();
}

bool Axis::provides(const ParameterRow& row) const noexcept {
  return (modules_ & row.modules) == row.modules;
}

void Axis::inhibit(bool inhibited) noexcept {
  block<SequenceControl>().inhibit(inhibited);
  settled_ = false;
}

}  // namespace drive
