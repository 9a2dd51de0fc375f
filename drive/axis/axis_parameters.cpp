// The parameters of an axis whose values are its own: members of AxisParameters and what it computes.
#include <algorithm>
#include <array>

#include "drive/axis/axis.hpp"
#include "drive/machine/machine_model.hpp"
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

/// Everything that is no command is as in a new unit, what a factory reset leaves as it is included.
void Axis::commission() noexcept {
  for (const PlacedRow& placed : parameters_of(kind())) {
    const ParameterRow& row = *placed.row;
    if (!std::holds_alternative<Setting>(row.home)) continue;
    for (std::size_t i = 0; i < row.count; ++i) set_setting(row, i, factory_value(row, context(), i));
  }
}

void* Axis::own_block(BlockId id) noexcept {
  return std::apply([this, id](auto&... blocks) { return find_block(id, *this, blocks...); }, blocks_);
}

const void* Axis::own_block(BlockId id) const noexcept {
  return std::apply([this, id](const auto&... blocks) { return find_block(id, *this, blocks...); }, blocks_);
}

/// Nothing but loading brings a motor or another mode while a measurement leads.
void Axis::before_setting(const ParameterRow& row) noexcept {
  if (block<Identification>().leads() && row.when != When::Always) cancel_identification();
}

void Axis::after_setting(const ParameterRow& row) noexcept {
  if (row.number == kControlMode) follow_control_mode();
}

/// Without closed loop nothing rotates, and nothing with an encoder that the mode does not use.
void Axis::follow_control_mode() noexcept {
  auto& control = block<SpeedControl>();
  control.on_control_mode();
  const std::int32_t rotating = block<Identification>().selection().rotating;
  if (rotating != selection::kNone && !can_rotate(rotating, kind(), control.settings.control_mode))
    select_rotating_measurement(selection::kNone);
}

WriteState Axis::write_state() const noexcept {
  return {.pulses_enabled = block<SequenceControl>().pulses_enabled(),
          .measures = block<Identification>().leads(),
          .filter = block<SequenceControl>().settings.commissioning};
}

void Axis::compute_parameters(int choice) noexcept {
  constexpr int kEverything = 1;
  constexpr int kCircuitOnly = 2;
  constexpr int kControl = 3;
  constexpr int kControllersOnly = 4;
  constexpr int kLimitsOnly = 5;
  const bool from_plate = !is_listed_motor(block<MotorModel>().settings);
  if (from_plate && choice == kEverything) compute_inertia();
  if (from_plate && (choice == kEverything || choice == kCircuitOnly)) compute_circuit();
  const MotorData& motor = block<MotorModel>().settings;
  ObjectContext described = context();
  described.axis.machine = block<MotorModel>().believed();
  described.axis.load.inertia = motor.motor_inertia * (motor.inertia_ratio - 1.0);
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
  described.axis.machine.inertia = motor::inertia_from_plate(block<MotorModel>().believed());
  compute_as_new(std::array{kInertia}, described);
}

/// The plate of an induction motor gives its circuit, with a straight characteristic through the rating point;
/// that of a synchronous one what is usual, in the ratio of the axes that the data sheet has.
void Axis::compute_circuit() noexcept {
  const motor::MachineData& data_sheet = context().axis.machine;
  ObjectContext described = context();
  motor::MachineData& machine = described.axis.machine;
  machine = block<MotorModel>().believed();
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
  block<SequenceControl>().settings.commissioning = 0;
  on_settings_changed(kBlock<SequenceControl>);
  settled_ = false;
}

motor::TorqueLimits Axis::effective_torque_limits() const noexcept {
  if (block<SequenceControl>().pulses_enabled()) return train_.signals().torque_limits;
  const motor::TorqueLimits& limits = block<TorqueSetpoint>().limits();
  const double highest = context().axis.machine.maximum_torque;
  return {std::min(limits.upper, highest), std::max(limits.lower, -highest)};
}

References Axis::references() const noexcept {
  const motor::EncoderData& encoder = context().axis.machine.encoder;
  return {.speed = block<ReferenceValues>().speed,
          .torque = block<ReferenceValues>().torque,
          .rated_torque = block<MotorModel>().settings.rated_torque,
          .maximum_speed = block<SetpointChannel>().settings.maximum_speed,
          .encoder_pulses = encoder.pulses,
          .encoder_fine_bits = encoder.fine_bits};
}

/// For @p machine as the control knows it. p1240 of a new unit: a vector axis keeps the voltage of a link without
/// chopper down, a servo does not.
motor::ControlSettings Axis::control_settings(const motor::MachineData& machine) const noexcept {
  constexpr double kVdcMargin = 50.0;  // V, of r1242 below the trip (p1254 = 1)
  const bool keeps_down = kind() == ObjectKind::Vector && !(context().supply.chopper_resistance > 0.0);
  const auto highest = keeps_down ? std::optional{context().supply.overvoltage - kVdcMargin} : std::nullopt;
  return block<SpeedControl>().control_settings(machine, block<MotorModel>(), context().axis.inverter, highest);
}

/// What is made of the settings, in the order in which one thing needs the other: each is made anew when one of
/// the blocks whose settings it is made of has changed.
void Axis::on_settings_changed(BlockId changed) noexcept {
  struct Made {
    void (Axis::*make)() noexcept;
    std::array<BlockId, 2> of;
  };
  static constexpr std::array kMade{
      Made{&Axis::configure_channel, {kBlock<SetpointChannel>, kBlock<MotorModel>}},
      Made{&Axis::configure_model, {kBlock<MotorModel>, kBlock<SequenceControl>}},
      Made{&Axis::check_blocks, {kBlock<Positioner>, kBlock<ActualPosition>}},
      Made{&Axis::configure_control, {kBlock<SpeedControl>, kBlock<MotorModel>}},
  };
  for (const Made& row : kMade)
    if (changed == nullptr || std::ranges::find(row.of, changed) != row.of.end()) (this->*row.make)();
}

void Axis::apply_parameters() noexcept {
  on_settings_changed(nullptr);
  settled_ = false;
}

void Axis::configure_channel() noexcept {
  block<SetpointChannel>().configure(block<MotorModel>().settings.motor_maximum_speed, has_setpoint_channel());
}

void Axis::check_blocks() noexcept {
  block<Positioner>().on_settings_changed();
}

void Axis::configure_model() noexcept {
  block<MotorModel>().configure(block<SequenceControl>().settings.commissioning != 0);
}

/// Of a machine that cannot be, the last possible one stays.
void Axis::configure_control() noexcept {
  const auto& model = block<MotorModel>();
  if (!model.is_plausible()) return;
  const motor::MachineData machine = model.believed();
  train_.set_machine(machine);
  train_.tune(control_settings(machine));
}

void Axis::request_mode(std::int8_t code) noexcept {
  const auto wanted = control_mode_of(code, has_encoder());
  const bool possible = wanted && write(kControlMode, *wanted).has_value();
  block<SpeedControl>().request_mode(code, possible);
  refresh_status();
  settled_ = false;
}

}  // namespace drive
