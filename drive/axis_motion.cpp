// What an axis does within a process-data cycle: control settings, steps of the motor, actual values, monitoring.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drive/axis.hpp"
#include "drive/machine_model.hpp"

namespace drive {
namespace {

using motor::ControlMode;
using motor::kControlPeriod;

/// p1300 from each number on.
struct ControlModeRow {
  std::int32_t from;
  ControlMode mode;
};
constexpr std::array kControlModes{
    ControlModeRow{23, ControlMode::Encoder}, ControlModeRow{22, ControlMode::Sensorless},
    ControlModeRow{21, ControlMode::Encoder}, ControlModeRow{20, ControlMode::Sensorless},
    ControlModeRow{0, ControlMode::VoltageFrequency}};
constexpr std::int32_t kParabolic = 2;
constexpr std::uint16_t kBlocked = 7900;
constexpr double kVdcMargin = 50.0;  // V, of r1242 below the trip (p1254 = 1)

ControlMode control_of(std::int32_t number) noexcept {
  return std::ranges::find_if(kControlModes, [=](const ControlModeRow& row) { return number >= row.from; })->mode;
}

}  // namespace

/// For @p machine as the control knows it.
motor::ControlSettings Axis::control_settings(const motor::MachineData& machine) const noexcept {
  const AxisParameters& p = parameters_;
  const double inertia = p.motor_inertia * p.inertia_ratio;
  motor::ControlSettings settings = motor::computed_settings(machine, context().axis.inverter, inertia);
  settings.mode = control_of(p.control_mode);
  settings.speed = {p.speed_gain, p.speed_integral_time};
  settings.sensorless_speed = {p.encoderless_speed_gain, p.encoderless_speed_integral_time};
  settings.current_limit = std::min(p.current_limit, context().axis.inverter.maximum_current);
  if (p.motor_limit_current > 0.0)
    settings.current_limit = std::min(settings.current_limit, p.motor_limit_current);
  settings.motoring_power_limit = p.motoring_power_limit;
  settings.regenerative_power_limit = p.regenerative_power_limit;
  settings.acceleration_precontrol = p.acceleration_precontrol;
  settings.speed_smoothing = p.speed_smoothing;
  settings.voltage_frequency.parabolic = p.control_mode == kParabolic;
  // p1240 of a new unit: a vector axis keeps the voltage of a link without chopper down, a servo does not.
  const bool without_chopper = !(context().supply.chopper_resistance > 0.0);
  if (kind() == ObjectKind::Vector && without_chopper)
    settings.vdc_max = context().supply.overvoltage - kVdcMargin;
  return settings;
}

void Axis::apply_parameters() noexcept {
  fixed_setpoints_ = fixed_setpoints();
  configure_channel();
  configure_control();
  settled_ = false;
}

void Axis::on_settings_changed(BlockId block) noexcept {
  if (block == nullptr) return apply_parameters();
  if (block == kBlock<SetpointChannel>) fixed_setpoints_ = fixed_setpoints();
  if (block == kBlock<SetpointChannel> || block == kBlock<AxisParameters>) configure_channel();
  if (block == kBlock<AxisParameters>) configure_control();
}

void Axis::configure_channel() noexcept {
  channel_.configure(parameters_, fixed_setpoints_, has_setpoint_channel());
}

void Axis::configure_control() noexcept {
  const AxisParameters& p = parameters_;
  const std::uint16_t implausible = implausible_motor_parameter(p, context().axis.machine);
  implausible_parameter_ = p.commissioning == 0 ? implausible : 0;
  if (implausible == 0) {  // otherwise the last possible model stays
    const motor::MachineData machine = believed_machine(p, context().axis.machine);
    train_.set_machine(machine);
    train_.tune(control_settings(machine));
  }
}

void Axis::cycle(const AxisInputs& inputs, double duration) noexcept {
  begin_cycle(inputs, duration);
  const int steps = std::max(1, static_cast<int>(std::lround(duration / kControlPeriod)));
  for (int i = 0; i < steps; ++i) step(dc_voltage_);
  measure();
  end_cycle();
}

void Axis::begin_cycle(const AxisInputs& inputs, double duration) noexcept {
  wired_ = inputs;
  begin(duration);
}

void Axis::begin_cycle(double duration) noexcept {
  wired_.controlword = process_data().whole_controlword;
  wired_.requested_mode = process_data().requested_mode;
  begin(duration);
}

void Axis::begin(double duration) noexcept {
  before_ = actual_;
  sequence(duration);
  wired_before_ = wired_;
  lead_setpoint();
  cycle_ = {.duration = duration,
            .command = {.pulses_enabled = pulses_enabled_in(state_), .limits = torque_limits_},
            .ramp_before = channel_.output(),
            .lowest_dc_voltage = dc_voltage_};
  lead_torque();
  lead_brake();
  if (identification_.leads()) lead_measurement();
}

/// Whether the sequence control opens and closes a holding brake.
bool Axis::has_brake() const noexcept {
  constexpr std::int32_t kWithOwnFeedback = 3;
  const std::int32_t configuration = parameters_.brake_configuration;
  return context().axis.load.brake.torque > 0.0 && (configuration == 1 || configuration == kWithOwnFeedback);
}

/// Opens the brake with the pulses, and closes it at the end of a braking ramp while the motor still holds.
void Axis::lead_brake() noexcept {
  if (!has_brake()) return train_.set_brake(false);
  const bool open = pulses_enabled_in(state_) && !(is_braking(state_) && stands());
  train_.set_brake(!open);
  brake_opening_ = open ? std::max(0.0, brake_opening_ - cycle_.duration) : parameters_.brake_opening_time;
  if (brake_opening_ > 0.0) channel_.wait();  // the setpoint waits for the brake
}

double Axis::step(double dc_voltage) noexcept {
  if (cycle_.measured) [[unlikely]]
    return measured_step(dc_voltage);
  motor::Command& command = cycle_.command;
  if (command.pulses_enabled) {
    command.speed_setpoint = channel_.step(kControlPeriod);
    command.acceleration_setpoint = channel_.acceleration();
  }
  return move(dc_voltage);
}

/// A step that a measurement leads.
[[gnu::noinline]] double Axis::measured_step(double dc_voltage) noexcept {
  step_measurement();
  return move(dc_voltage);
}

[[gnu::always_inline]] inline double Axis::move(double dc_voltage) noexcept {
  const double drawn = train_.step(dc_voltage, cycle_.command);
  const motor::Signals& seen = train_.signals();
  ++cycle_.steps;
  cycle_.torque_demand += seen.torque_setpoint;
  cycle_.torque += seen.torque;
  cycle_.speed += seen.measured_speed;
  const double energy = seen.power * kControlPeriod;
  (energy > 0.0 ? energy_drawn_ : energy_fed_back_) += std::abs(energy);
  watch(dc_voltage);
  return drawn;
}

/// What the power unit itself switches the pulses off for, without waiting for the end of the cycle.
void Axis::watch(double dc_voltage) noexcept {
  dc_voltage_ = dc_voltage;
  cycle_.highest_dc_voltage = std::max(cycle_.highest_dc_voltage, dc_voltage);
  cycle_.lowest_dc_voltage = std::min(cycle_.lowest_dc_voltage, dc_voltage);
  const double trip = context().axis.inverter.trip_current;
  const double current = train_.signals().current;
  cycle_.peak_current = std::max(cycle_.peak_current, current);
  const bool overvoltage = dc_voltage > context().supply.overvoltage;
  const bool overcurrent = current > trip;
  if (overcurrent) {
    const auto phases = motor::phase_values(train_.plant_state().current);
    for (std::size_t i = 0; i < phases.size(); ++i)
      if (std::abs(phases[i]) > trip) cycle_.tripped_phases |= 1U << i;
  }
  if (overvoltage || overcurrent) cycle_.command.pulses_enabled = false;
}

void Axis::end_cycle() noexcept {
  if (cycle_.measured) channel_.track(cycle_.command.speed_setpoint);
  monitor();
  if (cycle_.measured) end_measurement();
  refresh_status();
  settled_ = actual_ == before_;
}

void Axis::rest(double duration, double dc_voltage) noexcept {
  dc_voltage_ = dc_voltage;
  train_.rest(duration);
}

/// Means over the steps of the cycle.
void Axis::measure() noexcept {
  const double steps = std::max(1, cycle_.steps);
  const double time = steps * kControlPeriod;
  const std::int64_t counts = train_.signals().encoder_counts;
  const auto moved = static_cast<double>(counts - actual_.encoder_counts);
  const bool has_encoder = train_.settings().mode == ControlMode::Encoder;
  actual_.speed = has_encoder ? moved * counts_to_speed_ / time : cycle_.speed / steps;
  actual_.torque_demand = cycle_.torque_demand / steps;
  actual_.torque = cycle_.torque / steps;
  actual_.encoder_counts = counts;
  actual_.encoder_position = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts));
  ramp_acceleration_ = (channel_.output() - cycle_.ramp_before) / time;
}

void Axis::monitor() noexcept {
  const AxisParameters& p = parameters_;
  const double setpoint = std::isinf(feedback_.message_setpoint) ? channel_.input() : feedback_.message_setpoint;
  target_reached_ = target_monitor_.update(cycle_.duration, setpoint - actual_.speed,
                                           {p.target_window, p.target_hysteresis, p.target_off_delay});
  const Observed seen = observed();
  overspeed_ = seen.overspeed > p.overspeed_hysteresis;
  causes_.update(cycle_.duration, seen, cause_limits(), [this](const Verdict& verdict) { follow(verdict); });
}

Observed Axis::observed() const noexcept {
  const AxisParameters& p = parameters_;
  const motor::Signals& seen = train_.signals();
  const bool should_turn = pulses_enabled_in(state_) && std::abs(channel_.total()) > 0.0;
  const bool stuck =
      should_turn && seen.torque_limit_reached && std::abs(actual_.speed) < p.blocked_speed_threshold;
  return {
      .pulses_enabled = pulses_enabled_in(state_),
      .peak_current = cycle_.peak_current,
      .overcurrent_phases = static_cast<double>(cycle_.tripped_phases),
      .dc_voltage = cycle_.highest_dc_voltage,
      .lowest_dc_voltage = cycle_.lowest_dc_voltage,
      .overload = seen.overload,
      .heat_sink = seen.heat_sink_temperature,
      .chip_rise = seen.chip_temperature - seen.heat_sink_temperature,
      .motor_temperature = seen.winding_temperature,
      .motor_utilisation = seen.motor_utilisation,
      .stuck = stuck ? 1.0 : 0.0,
      .overspeed = std::max(actual_.speed - channel_.forward_limit(), channel_.backward_limit() - actual_.speed),
      .zero_mark_deviation = std::abs(static_cast<double>(train_.encoder().status().zero_mark_deviation)),
      .encoder_lost = train_.encoder().status().signal_lost ? 1.0 : 0.0,
      .crossed_torque_limits = torque_limits_.lower - torque_limits_.upper,
      .implausible_parameter = static_cast<double>(implausible_parameter_)};
}

CauseLimits Axis::cause_limits() const noexcept {
  const AxisParameters& p = parameters_;
  return {.trip_current = context().axis.inverter.trip_current,
          .overvoltage = context().supply.overvoltage,
          .undervoltage = context().supply.undervoltage,
          .temperature_alarm = p.temperature_alarm,
          .temperature_fault = p.temperature_fault,
          .overspeed_hysteresis = p.overspeed_hysteresis,
          .blocked_delay = p.blocked_delay};
}

void Axis::follow(const Verdict& verdict) noexcept {
  is_blocked_ = verdict.message == kBlocked ? verdict.present : is_blocked_;
  if (!verdict.present && messages().faults().empty() && messages().alarms().empty()) return;
  const FaultRow* const row = find_fault(verdict.message);
  if (!verdict.present) return static_cast<void>(memory().withdraw(*row));
  memory().enter(*row, verdict.value, Cause::Present);
  if (memory().settings.kind_of(*row) == Kind::Fault) react(*row);
}

}  // namespace drive
