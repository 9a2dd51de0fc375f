#include "motor/drive_train.hpp"

#include <cmath>
#include <numbers>

#include "motor/math/processor_variants.hpp"

namespace motor {
namespace {

/// The I²t model that a drive computes from the data sheet: one body with the motor's time constant.
OverloadData model_of(const MachineData& machine) noexcept {
  const ThermalData& bodies = machine.thermal;
  const double current = machine.type == MachineType::Synchronous ? machine.stall_current : machine.rated_current;
  const double capacity = bodies.winding_capacity + bodies.frame_capacity;
  return {.reference_current = current,
          .time_constant = capacity / bodies.frame_to_ambient,
          .ambient = bodies.ambient};
}

}  // namespace

DriveTrain::DriveTrain(const MachineData& data_sheet, const MachineData& machine, const Load& load,
                       const InverterData& inverter) noexcept
    : believed_{data_sheet},
      settings_{computed_settings(data_sheet, inverter, data_sheet.inertia + load.inertia)},
      plant_{machine, load},
      encoder_{machine},
      power_unit_{inverter},
      thermal_{machine.thermal},
      motor_model_{model_of(data_sheet)},
      current_sensor_{inverter.trip_current},
      ideal_inverter_{power_unit_.inverter().is_ideal()} {
  encoder_.configure(kControlPeriod);
  configure();
  warm_for(kControlPeriod, {.steps = 1.0});
}

void DriveTrain::tune(const ControlSettings& settings) noexcept {
  if (settings == settings_) return;
  const bool other_mode = settings.mode != settings_.mode;
  settings_ = settings;
  configure();
  if (other_mode) stop();
}

void DriveTrain::set_machine(const MachineData& machine) noexcept {
  believed_ = machine;
  configure();
}

void DriveTrain::configure() noexcept {
  const bool synchronous = believed_.type == MachineType::Synchronous;
  const double delay = speed_loop_delay(believed_);
  with_encoder_ = settings_.mode == ControlMode::Encoder;
  lead_ = excitation_ != nullptr                            ? Lead::Excitation
          : settings_.mode == ControlMode::VoltageFrequency ? Lead::VoltageFrequency
          : synchronous                                     ? Lead::Synchronous
                                                            : Lead::Induction;
  switch (lead_) {
    case Lead::Synchronous:
      return synchronous_.configure(believed_, settings_, delay);
    case Lead::Induction:
      return induction_.configure(believed_, settings_, delay);
    case Lead::VoltageFrequency:
      return voltage_frequency_.configure(believed_, settings_);
    case Lead::Excitation:
      break;
  }
}

void DriveTrain::lead_by(Excitation* excitation) noexcept {
  const bool other_lead = (excitation != nullptr) != (excitation_ != nullptr);
  excitation_ = excitation;
  configure();
  if (other_lead) stop();
}

void DriveTrain::use_sensors(bool used) noexcept {
  sensors_used_ = used;
  follow_sensors();
}

void DriveTrain::follow_sensors() noexcept {
  sees_truth_ = encoder_true_ && !sensors_used_;
}

void DriveTrain::start() noexcept {
  pulses_ = true;
  synchronous_.start(encoder_.speed());
  induction_.start(encoder_.speed());
  voltage_frequency_.start();
}

void DriveTrain::stop() noexcept {
  pulses_ = false;
  driven_ = false;
  state_.voltage = {};
  signals_.torque_setpoint = 0.0;
  signals_.torque = 0.0;
  signals_.torque_limit_reached = false;
  signals_.d_current = 0.0;
  signals_.q_current = 0.0;
  signals_.d_current_setpoint = 0.0;
  signals_.q_current_setpoint = 0.0;
  signals_.frequency = 0.0;
  signals_.voltage_limited = false;
  signals_.magnetised = false;
  signals_.flux = 0.0;
}

/// Electrical angle of the rotor as the encoder has it, where it cannot be taken for the truth.
SpaceVector DriveTrain::rotor_direction() const noexcept {
  const double revolutions = static_cast<double>(encoder_.counts()) / increments_per_revolution(believed_);
  const double angle = believed_.pole_pairs * 2.0 * std::numbers::pi * (revolutions - std::floor(revolutions));
  return {std::cos(angle), std::sin(angle)};
}

[[gnu::always_inline]] inline SpaceVector DriveTrain::control(const Measurement& measured,
                                                              const DriveCommand& command) noexcept {
  switch (lead_) {
    case Lead::Synchronous:
      return synchronous_.step(measured, command, signals_);
    case Lead::Induction:
      return induction_.step(measured, command, signals_);
    case Lead::VoltageFrequency:
      return voltage_frequency_.step(measured, command, signals_);
    case Lead::Excitation:
      break;
  }
  return excitation_->step(measured, signals_);
}

[[gnu::always_inline]] inline Measurement DriveTrain::measure(double dc_voltage) noexcept {
  if (!sees_truth_) [[unlikely]]
    return sense(dc_voltage);
  return {plant_.state().current, state_.voltage, plant_.direction(), encoder_.speed(), dc_voltage};
}

[[gnu::noinline]] Measurement DriveTrain::sense(double dc_voltage) noexcept {
  dc_voltage_ = dc_voltage;
  seen_current_ = sensors_used_ ? current_sensor_.read(plant_.state().current) : plant_.state().current;
  return {seen_current_, state_.voltage, rotor_direction(), encoder_.speed(), dc_voltage};
}

Observation DriveTrain::observation() const noexcept {
  return {.current = sensors_used_ ? seen_current_ : plant_.state().current,
          .voltage = state_.voltage,
          .dc_voltage = dc_voltage_,
          .encoder_counts = signals_.encoder_counts,
          .speed = signals_.measured_speed,
          .frequency = signals_.frequency,
          .d_current = signals_.d_current,
          .q_current = signals_.q_current,
          .torque_setpoint = signals_.torque_setpoint,
          .torque = signals_.torque,
          .torque_limits = signals_.torque_limits,
          .torque_limit_reached = signals_.torque_limit_reached,
          .voltage_limited = signals_.voltage_limited,
          .magnetised = signals_.magnetised,
          .winding_temperature = signals_.winding_temperature};
}

/// The inverter does not give all that it is asked for, and the control does not know.
void DriveTrain::drive_with_drops(double dc_voltage) noexcept {
  const SpaceVector before = plant_.state().current;
  const SpaceVector drop = power_unit_.inverter().distortion(before, dc_voltage);
  plant_.step(state_.next - drop);
  power_unit_.inverter().set_drop_losses(1.5 * dot(drop, 0.5 * (before + plant_.state().current)));
}

/// One period of the machine with the voltage calculated in the period before, or with the pulses inhibited.
[[gnu::always_inline]] inline void DriveTrain::move(double dc_voltage, bool pulses) noexcept {
  if (pulses) [[likely]] {
    state_.voltage = state_.next;
    if (ideal_inverter_) [[likely]]
      plant_.step(state_.next);
    else
      drive_with_drops(dc_voltage);
  } else {
    state_.voltage = {};
    plant_.coast(dc_voltage);
  }
  state_.book(plant_.state(), plant_.energies(), pulses, power_unit_.inverter(), signals_);
  signals_.voltage = length(state_.voltage);
  if (state_.heat.steps == TrainState<double>::kWarmSteps) warm();
}

[[gnu::always_inline]] inline void DriveTrain::observe() noexcept {
  const PlantState& state = plant_.state();
  encoder_.move_to(state.revolutions, state.rotor_angle);
  if (with_encoder_ || !pulses_) signals_.measured_speed = encoder_.speed();
  signals_.encoder_counts = encoder_.counts();
  sums_.add(signals_);
}

MOTOR_PROCESSOR_VARIANTS double DriveTrain::step(double dc_voltage, const DriveCommand& command) noexcept {
  if (!command.pulses_enabled) {
    if (pulses_) stop();
    if (lead_ == Lead::Induction) induction_.coast(encoder_.speed());
    move(dc_voltage, false);
  } else {
    if (!pulses_) start();
    const SpaceVector wanted = control(measure(dc_voltage), command);
    move(dc_voltage, driven_);
    state_.next = wanted;
    driven_ = true;
  }
  observe();
  return plant_.energies().electrical + state_.inverter_losses;
}

void DriveTrain::warm() noexcept {
  warm_for(state_.heat.steps * kControlPeriod, state_.heat);
  state_.heat = {};
}

void DriveTrain::warm_for(double duration, const Heat& heat) noexcept {
  thermal_.step(duration, heat.copper / duration, heat.iron / duration);
  power_unit_.step(duration, 0.5 * heat.square_current / heat.steps);
  plant_.set_temperatures(thermal_.winding(), thermal_.frame());
  signals_.winding_temperature = thermal_.winding();
  signals_.frame_temperature = thermal_.frame();
  motor_model_.step(duration, 0.5 * heat.square_current / heat.steps);
  signals_.motor_utilisation = motor_model_.utilisation();
  signals_.overload = power_unit_.overload();
  signals_.heat_sink_temperature = power_unit_.heat_sink_temperature();
  signals_.chip_temperature = power_unit_.chip_temperature();
}

void DriveTrain::rest(double duration) noexcept {
  if (duration <= 0.0) return;
  warm_for(duration, {.steps = 1.0});
}

void DriveTrain::inject(EncoderDefect defect) noexcept {
  encoder_.inject(defect);
  encoder_true_ = false;  // even a cured encoder has lost its place
  follow_sensors();
}

std::optional<LaneKind> DriveTrain::lane_kind(const DriveCommand& command) const noexcept {
  const bool usual = command.pulses_enabled && pulses_ && driven_ && sees_truth_ && excitation_ == nullptr &&
                     !encoder_.has_defect() && !plant_.awaits_brake();
  if (!usual) return std::nullopt;
  return LaneKind{.control = static_cast<std::uint8_t>(lead_),
                  .machine = plant_.machine_kind(),
                  .shaft = plant_.shaft_kind(),
                  .with_encoder = with_encoder_};
}

bool DriveTrain::rests() const noexcept {
  return !pulses_ && plant_.rests() && std::abs(encoder_.speed()) <= 0.0;
}

}  // namespace motor
