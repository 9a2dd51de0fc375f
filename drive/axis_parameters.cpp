// The parameters of an axis whose values are its own: members of AxisParameters and what it computes.
#include <algorithm>
#include <array>

#include "drive/axis.hpp"
#include "drive/machine_model.hpp"
#include "motor/data/rating_plate.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kControlMode = 1300;

/// What p0340 computes for its values 4, 2 (by the kind of machine) and 5.
constexpr std::uint16_t kInertia = 341;  // with 1 only
constexpr std::array<std::uint16_t, 4> kControllers{1460, 1462, 1470, 1472};
constexpr std::array<std::uint16_t, 14> kInductionCircuit{320, 350, 354, 356, 358, 360, 362,
                                                          363, 364, 365, 366, 367, 368, 369};
constexpr std::array<std::uint16_t, 3> kSynchronousCircuit{350, 356, 357};
constexpr std::array<std::uint16_t, 7> kLimits{640, 1082, 1520, 1521, 1530, 1531, 2162};

}  // namespace

AxisParameters commissioned_parameters(const AxisConfiguration& configuration) noexcept {
  ObjectContext context{};
  context.kind = configuration.kind;
  context.axis = configuration;
  AxisParameters parameters{};
  for (const PlacedRow& placed : parameters_of(configuration.kind)) {
    const auto* const home = std::get_if<Setting>(&placed.row->home);
    if (home == nullptr || home->block != kBlock<AxisParameters>) continue;
    home->set(&parameters, 0, factory_value(*placed.row, context) * row_of(placed.row->unit).si);
  }
  parameters.encoder_pulses = static_cast<std::int32_t>(configuration.machine.encoder.pulses);
  parameters.encoder_fine_bits = configuration.machine.encoder.fine_bits;
  return parameters;
}

void* Axis::own_block(BlockId id) noexcept {
  return find_block(id, *this, parameters_, wired_, feedback_);
}

const void* Axis::own_block(BlockId id) const noexcept {
  return find_block(id, *this, parameters_, wired_, feedback_);
}

/// Nothing but loading brings a motor or another mode while a measurement leads.
void Axis::before_setting(const ParameterRow& row) noexcept {
  if (identification_.leads() && row.when != When::Always) cancel_identification();
}

void Axis::after_setting(const ParameterRow& row) noexcept {
  if (row.number == kControlMode) follow_control_mode();
}

/// Without closed loop nothing rotates, and nothing with an encoder that the mode does not use.
void Axis::follow_control_mode() noexcept {
  mode_.on_parameter(parameters_.control_mode);
  const std::int32_t rotating = identification_.selection().rotating;
  if (rotating != selection::kNone && !can_rotate(rotating, kind(), parameters_.control_mode))
    select_rotating_measurement(selection::kNone);
}

WriteState Axis::write_state() const noexcept {
  return {.pulses_enabled = pulses_enabled_in(state_),
          .measures = identification_.leads(),
          .filter = parameters_.commissioning};
}

void Axis::compute_parameters(int choice) noexcept {
  constexpr int kEverything = 1;
  constexpr int kCircuitOnly = 2;
  constexpr int kControl = 3;
  constexpr int kControllersOnly = 4;
  constexpr int kLimitsOnly = 5;
  const bool from_plate = !is_listed_motor(parameters_);
  if (from_plate && choice == kEverything) compute_inertia();
  if (from_plate && (choice == kEverything || choice == kCircuitOnly)) compute_circuit();
  ObjectContext described = context();
  described.axis.machine = believed_machine(parameters_, context().axis.machine);
  described.axis.load.inertia = parameters_.motor_inertia * (parameters_.inertia_ratio - 1.0);
  const bool everything = choice == kEverything || choice == kControl;
  if (everything || choice == kControllersOnly) compute_as_new(kControllers, described);
  if (everything || choice == kLimitsOnly) compute_as_new(kLimits, described);
  apply_parameters();
}

/// The parameters @p numbers become what they would be on a new unit of @p described.
void Axis::compute_as_new(std::span<const std::uint16_t> numbers, const ObjectContext& described) noexcept {
  for (const std::uint16_t number : numbers) {
    const ParameterRow& row = *find_parameter(kind(), number)->row;
    const Range limits = limits_of(row);
    set_setting(row, 0, std::clamp(factory_value(row, described), limits.minimum, limits.maximum));
  }
}

void Axis::compute_inertia() noexcept {
  ObjectContext described = context();
  described.axis.machine.inertia =
      motor::inertia_from_plate(believed_machine(parameters_, context().axis.machine));
  compute_as_new(std::array{kInertia}, described);
}

/// The plate of an induction motor gives its circuit, with a straight characteristic through the rating point;
/// that of a synchronous one what is usual, in the ratio of the axes that the data sheet has.
void Axis::compute_circuit() noexcept {
  const motor::MachineData& data_sheet = context().axis.machine;
  ObjectContext described = context();
  motor::MachineData& machine = described.axis.machine;
  machine = believed_machine(parameters_, data_sheet);
  if (machine.type == motor::MachineType::Induction) {
    machine = motor::circuit_from_plate(machine);
    machine.induction.saturation_flux = 0.0;
    return compute_as_new(kInductionCircuit, described);
  }
  machine.synchronous.d_inductance = data_sheet.synchronous.d_inductance;
  machine.synchronous.q_inductance = data_sheet.synchronous.q_inductance;
  machine = motor::magnetic_data_from_plate(machine);
  compute_as_new(kSynchronousCircuit, described);
}

void Axis::leave_commissioning() noexcept {
  cancel_identification();
  parameters_.commissioning = 0;
  settled_ = false;
}

/// With the pulses off, what the parameters and the motor allow.
motor::TorqueLimits Axis::effective_torque_limits() const noexcept {
  if (pulses_enabled_in(state_)) return train_.signals().torque_limits;
  const double highest = context().axis.machine.maximum_torque;
  return {std::min(torque_limits_.upper, highest), std::max(torque_limits_.lower, -highest)};
}

AxisInsight Axis::insight() const noexcept {
  return {.inputs = inputs_,
          .switching_on_inhibited = inhibited_ || parameters_.commissioning != 0,
          .torque_control = mode_.torque_control(parameters_.control_mode),
          .fixed_setpoint = channel_.fixed_setpoint(),
          .setpoint_sum = channel_.sum(),
          .directed_setpoint = channel_.directed(),
          .ramp_input = channel_.input(),
          .ramp_output = channel_.output(),
          .ramp_acceleration = ramp_acceleration_,
          .torque_limits = effective_torque_limits(),
          .dc_voltage = dc_voltage_,
          .torque_limit_reached = pulses_enabled_in(state_) && train_.signals().torque_limit_reached,
          .target_reached = target_reached_,
          .overspeed = overspeed_,
          .blocked = is_blocked_,
          .energy_drawn = energy_drawn_,
          .energy_fed_back = energy_fed_back_};
}

}  // namespace drive
