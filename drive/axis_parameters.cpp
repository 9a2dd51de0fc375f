// The parameters of an axis whose values are its own: members of AxisParameters and what it computes.
#include <algorithm>
#include <array>

#include "drive/axis.hpp"
#include "drive/motor_model/machine_model.hpp"
#include "drive/parameter/rounding.hpp"
#include "motor/rating_plate.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kControlMode = 1300;
constexpr std::uint16_t kFirstFixedSetpoint = 1001;

using Members = std::variant<double AxisParameters::*, std::int32_t AxisParameters::*>;

double get(const AxisParameters& parameters, const Members& member) noexcept {
  return std::visit([&](auto pointer) { return static_cast<double>(parameters.*pointer); }, member);
}

/// @p si in SI units.
void set(AxisParameters& parameters, const Members& member, double si) noexcept {
  if (const auto* number = std::get_if<double AxisParameters::*>(&member)) parameters.*(*number) = si;
  if (const auto* code = std::get_if<std::int32_t AxisParameters::*>(&member))
    parameters.*(*code) = static_cast<std::int32_t>(si);
}

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
    const auto* const home = std::get_if<Member>(&placed.row->home);
    if (home == nullptr) continue;
    set(parameters, home->member, factory_value(*placed.row, context) * row_of(placed.row->unit).si);
  }
  return parameters;
}

double Axis::own_value(const ParameterRow& row, std::size_t index) const noexcept {
  if (const auto* const display = std::get_if<Computed<Axis>>(&row.home)) return display->get(*this, index);
  const auto* const home = std::get_if<Member>(&row.home);
  return home != nullptr ? rounded(get(parameters_, home->member) / row_of(row.unit).si) : 0.0;
}

void Axis::set_own_value(const ParameterRow& row, std::size_t index, double value) noexcept {
  if (const auto* const command = std::get_if<Computed<Axis>>(&row.home)) {
    if (command->set != nullptr) command->set(*this, index, value);
  } else if (const auto* const home = std::get_if<Member>(&row.home)) {
    // Nothing but loading brings a motor or another mode while a measurement leads.
    if (block<Identification>().leads() && row.when != When::Always) cancel_identification();
    set(parameters_, home->member, value * row_of(row.unit).si);
    if (row.number == kControlMode) follow_control_mode();
  }
}

/// Without closed loop nothing rotates, and nothing with an encoder that the mode does not use.
void Axis::follow_control_mode() noexcept {
  block<SpeedControl>().settings.control_mode = parameters_.control_mode;
  block<SpeedControl>().on_control_mode();
  const std::int32_t rotating = block<Identification>().selection().rotating;
  if (rotating != selection::kNone && !can_rotate(rotating, kind(), parameters_.control_mode))
    select_rotating_measurement(selection::kNone);
}

WriteState Axis::write_state() const noexcept {
  return {.pulses_enabled = block<SequenceControl>().pulses_enabled(),
          .measures = block<Identification>().leads(),
          .filter = parameters_.commissioning};
}

void Axis::compute_parameters(int choice) noexcept {
  constexpr int kEverything = 1;
  constexpr int kCircuitOnly = 2;
  constexpr int kControl = 3;
  constexpr int kControllersOnly = 4;
  constexpr int kLimitsOnly = 5;
  const bool from_plate = !is_listed_motor(motor_data());
  if (from_plate && choice == kEverything) compute_inertia();
  if (from_plate && (choice == kEverything || choice == kCircuitOnly)) compute_circuit();
  ObjectContext described = context();
  described.axis.machine = believed_machine(motor_data(), context().axis.machine);
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
    set_own_value(row, 0, std::clamp(factory_value(row, described), limits.minimum, limits.maximum));
  }
}

void Axis::compute_inertia() noexcept {
  ObjectContext described = context();
  described.axis.machine.inertia =
      motor::inertia_from_plate(believed_machine(motor_data(), context().axis.machine));
  compute_as_new(std::array{kInertia}, described);
}

/// The plate of an induction motor gives its circuit, with a straight characteristic through the rating point;
/// that of a synchronous one what is usual, in the ratio of the axes that the data sheet has.
void Axis::compute_circuit() noexcept {
  const motor::MachineData& data_sheet = context().axis.machine;
  ObjectContext described = context();
  motor::MachineData& machine = described.axis.machine;
  machine = believed_machine(motor_data(), data_sheet);
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

motor::TorqueLimits Axis::effective_torque_limits() const noexcept {
  if (block<SequenceControl>().pulses_enabled()) return train_.signals().torque_limits;
  const motor::TorqueLimits& limits = block<TorqueSetpoint>().limits();
  const double highest = context().axis.machine.maximum_torque;
  return {std::min(limits.upper, highest), std::max(limits.lower, -highest)};
}

References Axis::references() const noexcept {
  const motor::EncoderData& encoder = context().axis.machine.encoder;
  return {.speed = parameters_.reference_speed,
          .torque = parameters_.reference_torque,
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

void Axis::apply_parameters() noexcept {
  fill_settings();
  MotorModel& model = block<MotorModel>();
  block<SetpointChannel>().configure(model.settings.motor_maximum_speed, has_setpoint_channel());
  model.configure(block<SequenceControl>().settings.commissioning != 0);
  if (model.is_plausible()) {  // otherwise the last possible model stays
    const motor::MachineData machine = model.believed();
    train_.set_machine(machine);
    train_.tune(control_settings(machine));
  }
  settled_ = false;
}

void Axis::request_mode(std::int8_t code) noexcept {
  const auto wanted = control_mode_of(code, has_encoder());
  const bool possible = wanted && write(kControlMode, *wanted).has_value();
  block<SpeedControl>().request_mode(code, possible);
  refresh_status();
  settled_ = false;
}

void Axis::fill_settings() noexcept {
  const AxisParameters& p = parameters_;
  block<MotorModel>().settings.motor_type = p.motor_type;
  block<MotorModel>().settings.motor_code = p.motor_code;
  block<MotorModel>().settings.rated_voltage = p.rated_voltage;
  block<MotorModel>().settings.rated_current = p.rated_current;
  block<MotorModel>().settings.rated_power = p.rated_power;
  block<MotorModel>().settings.power_factor = p.power_factor;
  block<MotorModel>().settings.rated_frequency = p.rated_frequency;
  block<MotorModel>().settings.rated_speed = p.rated_speed;
  block<MotorModel>().settings.pole_pairs = p.pole_pairs;
  block<MotorModel>().settings.torque_constant = p.torque_constant;
  block<MotorModel>().settings.magnetising_current = p.magnetising_current;
  block<MotorModel>().settings.motor_maximum_speed = p.motor_maximum_speed;
  block<MotorModel>().settings.motor_maximum_current = p.motor_maximum_current;
  block<MotorModel>().settings.rated_torque = p.rated_torque;
  block<MotorModel>().settings.motor_limit_current = p.motor_limit_current;
  block<MotorModel>().settings.motor_inertia = p.motor_inertia;
  block<MotorModel>().settings.inertia_ratio = p.inertia_ratio;
  block<MotorModel>().settings.stator_resistance = p.stator_resistance;
  block<MotorModel>().settings.rotor_resistance = p.rotor_resistance;
  block<MotorModel>().settings.series_inductance = p.series_inductance;
  block<MotorModel>().settings.stator_leakage = p.stator_leakage;
  block<MotorModel>().settings.direct_inductance = p.direct_inductance;
  block<MotorModel>().settings.rotor_leakage = p.rotor_leakage;
  block<MotorModel>().settings.main_inductance = p.main_inductance;
  block<MotorModel>().settings.characteristic_flux_1 = p.characteristic_flux_1;
  block<MotorModel>().settings.characteristic_flux_2 = p.characteristic_flux_2;
  block<MotorModel>().settings.characteristic_flux_3 = p.characteristic_flux_3;
  block<MotorModel>().settings.characteristic_flux_4 = p.characteristic_flux_4;
  block<MotorModel>().settings.characteristic_current_1 = p.characteristic_current_1;
  block<MotorModel>().settings.characteristic_current_2 = p.characteristic_current_2;
  block<MotorModel>().settings.characteristic_current_3 = p.characteristic_current_3;
  block<MotorModel>().settings.characteristic_current_4 = p.characteristic_current_4;
  block<MotorMonitoring>().settings.alarm_temperature = p.temperature_alarm;
  block<MotorMonitoring>().settings.fault_temperature = p.temperature_fault;
  block<SpeedControl>().settings.current_limit = p.current_limit;
  block<SetpointChannel>().settings.jog_speed_1 = p.jog_speed_1;
  block<SetpointChannel>().settings.jog_speed_2 = p.jog_speed_2;
  block<SetpointChannel>().settings.minimum_speed = p.minimum_speed;
  block<SetpointChannel>().settings.maximum_speed = p.maximum_speed;
  block<SetpointChannel>().settings.speed_limit_positive = p.speed_limit_positive;
  block<SetpointChannel>().settings.speed_limit_negative = p.speed_limit_negative;
  block<SetpointChannel>().settings.ramp_selection = p.ramp_selection;
  block<SetpointChannel>().settings.ramp_up_time = p.ramp_up_time;
  block<SetpointChannel>().settings.ramp_down_time = p.ramp_down_time;
  block<SetpointChannel>().settings.initial_rounding = p.initial_rounding;
  block<SetpointChannel>().settings.final_rounding = p.final_rounding;
  block<SetpointChannel>().settings.rounding_type = p.rounding_type;
  block<SetpointChannel>().settings.off3_ramp_down_time = p.off3_ramp_down_time;
  block<SetpointChannel>().settings.off3_initial_rounding = p.off3_initial_rounding;
  block<SetpointChannel>().settings.off3_final_rounding = p.off3_final_rounding;
  block<HoldingBrake>().settings.configuration = p.brake_configuration;
  block<HoldingBrake>().settings.opening_time = p.brake_opening_time;
  block<HoldingBrake>().settings.closing_time = p.brake_closing_time;
  block<SequenceControl>().settings.standstill_threshold = p.standstill_threshold;
  block<SequenceControl>().settings.standstill_monitoring_time = p.standstill_monitoring_time;
  block<SequenceControl>().settings.pulse_suppression_delay = p.pulse_suppression_delay;
  block<SequenceControl>().settings.power_monitoring_time = p.power_monitoring_time;
  block<SpeedControl>().settings.control_mode = p.control_mode;
  block<SpeedControl>().settings.speed_smoothing = p.speed_smoothing;
  block<SpeedControl>().settings.speed_gain = p.speed_gain;
  block<SpeedControl>().settings.speed_integral_time = p.speed_integral_time;
  block<SpeedControl>().settings.encoderless_speed_gain = p.encoderless_speed_gain;
  block<SpeedControl>().settings.encoderless_speed_integral_time = p.encoderless_speed_integral_time;
  block<SpeedControl>().settings.acceleration_precontrol = p.acceleration_precontrol;
  block<Identification>().settings.speed_dynamics = p.speed_dynamics;
  block<TorqueSetpoint>().settings.upper_limit = p.upper_torque_limit;
  block<TorqueSetpoint>().settings.lower_limit = p.lower_torque_limit;
  block<SpeedControl>().settings.motoring_power_limit = p.motoring_power_limit;
  block<SpeedControl>().settings.regenerative_power_limit = p.regenerative_power_limit;
  block<SpeedMessages>().settings.zero_speed_threshold = p.zero_speed_threshold;
  block<SpeedMessages>().settings.overspeed_hysteresis = p.overspeed_hysteresis;
  block<SpeedMessages>().settings.target_window = p.target_window;
  block<SpeedMessages>().settings.target_hysteresis = p.target_hysteresis;
  block<SpeedMessages>().settings.target_off_delay = p.target_off_delay;
  block<SpeedMessages>().settings.blocked_speed_threshold = p.blocked_speed_threshold;
  block<SpeedMessages>().settings.blocked_delay = p.blocked_delay;
  block<SequenceControl>().settings.commissioning = p.commissioning;
  block<SequenceControl>().settings.abort_connection_option = p.abort_connection_option;
  block<SequenceControl>().settings.halt_option = p.halt_option;
  auto& fixed = block<SetpointChannel>().settings.fixed;
  for (std::size_t i = 1; i < fixed.size(); ++i)
    fixed[i] = read(static_cast<std::uint16_t>(kFirstFixedSetpoint + i - 1)).value_or(0.0) * kRpm;
}

void Axis::fill_inputs(const AxisInputs& in) noexcept {
  wired_ = in;
  block<SequenceControl>().inputs.on = in.on;
  block<SequenceControl>().inputs.no_off2 = in.no_off2;
  block<SequenceControl>().inputs.no_off2_second = in.no_off2_second;
  block<SequenceControl>().inputs.no_off3 = in.no_off3;
  block<SequenceControl>().inputs.no_off3_second = in.no_off3_second;
  block<SequenceControl>().inputs.enable_operation = in.enable_operation;
  block<SequenceControl>().inputs.control_by_plc = in.control_by_plc;
  block<SpeedControl>().inputs.enable = in.enable_speed_controller;
  block<SequenceControl>().inputs.infeed_operates = in.infeed_operates;
  block<SetpointChannel>().inputs.jog_1 = in.jog_1;
  block<SetpointChannel>().inputs.jog_2 = in.jog_2;
  block<SetpointChannel>().inputs.fixed_setpoint_bit_0 = in.fixed_setpoint_bit_0;
  block<SetpointChannel>().inputs.fixed_setpoint_bit_1 = in.fixed_setpoint_bit_1;
  block<SetpointChannel>().inputs.fixed_setpoint_bit_2 = in.fixed_setpoint_bit_2;
  block<SetpointChannel>().inputs.fixed_setpoint_bit_3 = in.fixed_setpoint_bit_3;
  block<SetpointChannel>().inputs.inhibit_negative = in.inhibit_negative;
  block<SetpointChannel>().inputs.inhibit_positive = in.inhibit_positive;
  block<SetpointChannel>().inputs.invert_setpoint = in.invert_setpoint;
  block<SetpointChannel>().inputs.bypass_ramp = in.bypass_ramp;
  block<SetpointChannel>().inputs.enable_ramp = in.enable_ramp;
  block<SetpointChannel>().inputs.continue_ramp = in.continue_ramp;
  block<SetpointChannel>().inputs.enable_setpoint = in.enable_setpoint;
  block<SetpointChannel>().inputs.set_ramp = in.set_ramp;
  block<SetpointChannel>().inputs.main_setpoint = in.main_setpoint;
  block<SetpointChannel>().inputs.supplementary_setpoint = in.supplementary_setpoint;
  block<SetpointChannel>().inputs.forward_limit = in.forward_limit;
  block<SetpointChannel>().inputs.backward_limit = in.backward_limit;
  block<SetpointChannel>().inputs.ramp_setting = in.ramp_setting;
  block<SetpointChannel>().inputs.speed_setpoint_1 = in.speed_setpoint_1;
  block<SetpointChannel>().inputs.speed_setpoint_2 = in.speed_setpoint_2;
  block<SpeedControl>().inputs.torque_control = in.torque_control;
  block<TorqueSetpoint>().inputs.setpoint = in.torque_setpoint;
  block<TorqueSetpoint>().inputs.supplementary_1 = in.supplementary_torque_1;
  block<TorqueSetpoint>().inputs.supplementary_2 = in.supplementary_torque_2;
  block<TorqueSetpoint>().inputs.upper_limit = in.upper_torque_limit;
  block<TorqueSetpoint>().inputs.lower_limit = in.lower_torque_limit;
  block<ExternalMessages>().inputs.acknowledge_1 = in.acknowledge_1;
  block<ExternalMessages>().inputs.acknowledge_2 = in.acknowledge_2;
  block<ExternalMessages>().inputs.acknowledge_3 = in.acknowledge_3;
  block<ExternalMessages>().inputs.no_external_fault_1 = in.no_external_fault_1;
  block<ExternalMessages>().inputs.no_external_fault_2 = in.no_external_fault_2;
  block<ExternalMessages>().inputs.no_external_fault_3 = in.no_external_fault_3;
  block<ExternalMessages>().inputs.no_external_alarm_1 = in.no_external_alarm_1;
  const auto bit = [&](unsigned number) { return (in.controlword >> number & 1U) != 0; };
  block<SpeedControl>().inputs.requested_mode = in.requested_mode;
  block<SequenceControl>().inputs.halt = bit(8);
  block<SetpointChannel>().inputs.vl_enable_ramp = bit(4);
  block<SetpointChannel>().inputs.vl_unlock_ramp = bit(5);
  block<SetpointChannel>().inputs.vl_reference_ramp = bit(6);
}

}  // namespace drive
