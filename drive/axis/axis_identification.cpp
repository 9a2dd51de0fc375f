// Motor identification: how an axis begins, leads and ends the measurements that p1900, p1910 and p1960 select.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drive/axis/axis.hpp"
#include "drive/machine/machine_model.hpp"
#include "motor/control/field/induction_circuit.hpp"

namespace drive {
namespace {

using Part = IdentificationPart;

constexpr std::uint16_t kRotatingSelected = 7980;
constexpr std::uint16_t kRotatingFailed = 7985;
constexpr std::uint16_t kStandstillFailed = 7990;
constexpr std::uint16_t kStandstillSelected = 7991;

// The shaft turns no further in a measurement at standstill.
constexpr double kServoTravel = 210.0 * std::numbers::pi / 180.0;
constexpr double kVectorTravel = 90.0 * std::numbers::pi / 180.0;

// p1959.
constexpr std::uint16_t kRotatingTime = 1958;
constexpr std::uint16_t kRotatingConfiguration = 1959;
constexpr unsigned kFindsFlux = 1U << 1;
constexpr unsigned kFindsInertia = 1U << 2;
constexpr unsigned kSetsController = 1U << 3;
constexpr unsigned kLocksForward = 1U << 14;
constexpr unsigned kLocksBackward = 1U << 15;

constexpr int kControllers = 4;        // p0340
constexpr double kWholeInertia = 1.0;  // p1496

unsigned configuration_of(const Axis& axis) noexcept {
  return static_cast<unsigned>(axis.read(kRotatingConfiguration).value_or(0.0));
}

/// What rounding through the parameters makes of @p value (in SI units).
double represented(const ParameterRow& row, double value) noexcept {
  const Range limits = limits_of(row);
  return decode(encode(row.type, std::clamp(value / row_of(row.unit).si, limits.minimum, limits.maximum)));
}

}  // namespace

void Axis::select_identification(std::int32_t value) noexcept {
  constexpr std::array kChoices{selection::kMeasure, selection::kMeasureBlind};
  const auto* const rotating = std::ranges::find_if(kChoices, [this](std::int32_t choice) {
    return can_rotate(choice, kind(), block<SpeedControl>().settings.control_mode);
  });
  block<Identification>().select_both(value, rotating != kChoices.end() ? *rotating : selection::kNone);
  show_selection();
}

void Axis::select_standstill_measurement(std::int32_t value) noexcept {
  if (value == selection::kTakeOver) return take_over(Part::Standstill);
  block<Identification>().select_standstill(value);
  show_selection();
}

void Axis::select_rotating_measurement(std::int32_t value) noexcept {
  if (value == selection::kTakeOver) return take_over(Part::Rotating);
  block<Identification>().select_rotating(value);
  show_selection();
}

/// A07991 and A07980 are there as long as their measurement is selected.
void Axis::show_selection() noexcept {
  const IdentificationSelection& chosen = block<Identification>().selection();
  const auto show = [this](std::uint16_t number, bool selected) {
    if (!selected) return withdraw(number);
    static_cast<void>(raise(number, 0, Cause::Present));
  };
  show(kStandstillSelected, chosen.standstill != selection::kNone);
  show(kRotatingSelected, chosen.rotating != selection::kNone);
}

bool Axis::can_begin_measurement() const noexcept {
  const bool released = !has_brake() || !block<HoldingBrake>().is_opening();
  return released && block<SpeedControl>().inputs.enable && (block<Identification>().begins_turning() || stands());
}

/// In a cycle with a measurement. Without the enable of the speed controller it is given up, and begins anew.
void Axis::lead_measurement() noexcept {
  command_.additional_torque = 0.0;
  if (block<Identification>().waits() && can_begin_measurement()) begin_measurement();
  const Part running = block<Identification>().running();
  if (running == Part::None) return;
  if (!block<SpeedControl>().inputs.enable) {
    stop_measurement();
    return block<Identification>().prepare(true);
  }
  if (running == Part::Standstill)
    train_.lead_by(&block<Identification>().excitation());  // which a copy has of its own
  measured_ = true;
}

void Axis::begin_measurement() noexcept {
  const motor::MachineData machine = block<MotorModel>().believed();
  block<SetpointChannel>().start(train_.signals().measured_speed);
  train_.use_sensors(true);
  if (block<Identification>().due() == Part::Standstill) {
    block<Identification>().start(standstill_task(machine));
  } else {
    block<Identification>().start(rotating_task(machine));
  }
}

motor::StandstillTask Axis::standstill_task(const motor::MachineData& machine) const noexcept {
  return {.machine = machine,
          .settings = control_settings(machine),
          .winding_temperature = train_.observation().winding_temperature,
          .largest_travel = kind() == ObjectKind::Vector ? kVectorTravel : kServoTravel,
          .finds_curve = block<Identification>().selection().standstill == selection::kMeasureCurve};
}

motor::RotatingTask Axis::rotating_task(const motor::MachineData& machine) const noexcept {
  const unsigned configuration = configuration_of(*this);
  const bool with_load = block<Identification>().selection().rotating >= selection::kFirstWithLoad;
  const double forwards = block<SetpointChannel>().forward_limit();
  const double backwards = -block<SetpointChannel>().backward_limit();
  const bool forward = (configuration & kLocksForward) == 0 &&
                       !block<SetpointChannel>().effective().inhibit_positive && forwards > 0.0;
  const bool backward = (configuration & kLocksBackward) == 0 &&
                        !block<SetpointChannel>().effective().inhibit_negative && backwards > 0.0;
  return {.machine = machine,
          .settings = control_settings(machine),
          .maximum_speed = forward && backward ? std::min(forwards, backwards)
                           : forward           ? forwards
                                               : backwards,
          .ramp_time = read(kRotatingTime).value_or(-1.0),
          .torque_limits = block<TorqueSetpoint>().limits(),
          .forward = forward,
          .backward = backward,
          .finds_flux = !with_load && (configuration & kFindsFlux) != 0,
          .finds_inertia = (configuration & kFindsInertia) != 0};
}

/// A control period that a measurement leads; when it ends, so do the pulses.
void Axis::step_measurement() noexcept {
  motor::DriveCommand& command = command_;
  if (!command.pulses_enabled) return;
  if (block<Identification>().running() == Part::Rotating) {
    const motor::TorqueLimits limits = command.limits;
    command = block<Identification>().step(train_.observation());
    command.limits = {std::min(limits.upper, command.limits.upper), std::max(limits.lower, command.limits.lower)};
    train_.set_flux_share(block<Identification>().flux_share());
  }
  command.pulses_enabled = block<Identification>().state() == motor::MeasurementState::Running;
}

/// After a cycle with a measurement, which a fault may have ended already.
void Axis::end_measurement() noexcept {
  using enum motor::MeasurementState;
  const Part ended = block<Identification>().running();
  if (ended == Part::None || block<Identification>().state() == Running) return;
  if (block<Identification>().state() == Done) {
    const bool is_taken_over = block<Identification>().is_taken_over(ended);
    block<Identification>().finish();
    give_back_control();
    if (is_taken_over) take_over(ended);
    apply(Event::MeasurementEnded);
    return show_selection();
  }
  const std::uint16_t fault = ended == Part::Standstill ? kStandstillFailed : kRotatingFailed;
  static_cast<void>(raise(fault, block<Identification>().fault_value()));
  if (block<Identification>().leads()) cancel_identification();  // the fault has no reaction
}

/// The control goes on with what it has known before; the measurement stays selected.
void Axis::stop_measurement() noexcept {
  block<Identification>().stop();
  give_back_control();
}

/// Nothing is selected any more, and what led the motor leaves it without pulses.
void Axis::cancel_identification() noexcept {
  const bool led = block<Identification>().leads();
  if (led) stop_measurement();
  block<Identification>().deselect();
  if (led) apply(Event::MeasurementEnded);
  show_selection();
}

void Axis::give_back_control() noexcept {
  train_.lead_by(nullptr);
  train_.use_sensors(false);
  train_.set_flux_share(1.0);
}

void Axis::take_over(Part part) noexcept {
  const Identification::Results& found = block<Identification>().results();
  if (part == Part::Standstill && found.standstill) take_over(*found.standstill);
  if (part == Part::Rotating && found.rotating) take_over(*found.rotating);
}

/// A measurement of the characteristic is taken over as that alone.
void Axis::take_over(const motor::StandstillResult& found) noexcept {
  if (found.curve.is_known()) {
    take_over_saturation(found.curve);
    return apply_parameters();
  }
  const motor::MachineData machine = motor::identified_machine(block<MotorModel>().believed(), found);
  assign_rounded(350, machine.stator_resistance);
  if (machine.type == motor::MachineType::Synchronous) {
    assign_rounded(356, machine.synchronous.q_inductance - block<MotorModel>().settings.series_inductance);
    assign_rounded(357, machine.synchronous.d_inductance - block<MotorModel>().settings.series_inductance);
  } else {
    assign_rotor_circuit(machine);
  }
  compute_parameters(kControllers);
}

void Axis::take_over(const motor::RotatingResult& found) noexcept {
  const motor::MachineData& data_sheet = context().axis.machine;
  if (data_sheet.type == motor::MachineType::Induction) {
    take_over_saturation(found);
  } else if (found.magnet_flux > 0.0) {
    assign_rounded(316, torque_constant(data_sheet, found.magnet_flux));
  }
  if (found.inertia > 0.0) {
    if (found.inertia < block<MotorModel>().settings.motor_inertia) assign_rounded(341, found.inertia);
    assign_rounded(342, found.inertia / block<MotorModel>().settings.motor_inertia);
    assign_rounded(1496, kWholeInertia);
  }
  if ((configuration_of(*this) & kSetsController) != 0) {
    compute_parameters(kControllers);
    set_dynamics(block<Identification>().settings.speed_dynamics);
  }
  apply_parameters();
}

/// Speed controllers that are @p factor times as fast as p0340 = 4 has made them.
void Axis::set_dynamics(double factor) noexcept {
  const SpeedControl::Settings p = block<SpeedControl>().settings;
  assign_rounded(1460, p.speed_gain * factor);
  assign_rounded(1462, p.speed_integral_time / factor);
  assign_rounded(1470, p.encoderless_speed_gain * factor);
  assign_rounded(1472, p.encoderless_speed_integral_time / factor);
}

/// The characteristic was measured in shares of the flux that was believed the rated one, and refers to the one
/// that was found from now on. What was found of leakage and rotor resistance at the terminals stays.
void Axis::take_over_saturation(const motor::SaturationCurve& found) noexcept {
  constexpr std::array<std::uint16_t, 4> kFlux{362, 363, 364, 365}, kCurrent{366, 367, 368, 369};
  if (!found.is_known()) return;
  const motor::MachineData believed = block<MotorModel>().believed();
  const motor::InductionCircuit circuit = motor::induction_circuit(believed);
  motor::InductionCircuit fitted = circuit;
  fitted.magnetising_inductance = found.fitted_magnetising_inductance;
  fitted.saturation_flux = found.fitted_saturation_flux;
  const double current = std::numbers::sqrt2 * block<MotorModel>().settings.magnetising_current;
  const double ratio = found.rated_flux / motor::standing_flux(fitted, current);
  for (std::size_t i = 0; i < kFlux.size(); ++i) {
    assign_rounded(kFlux[i], ratio * found.flux[i]);
    assign_rounded(kCurrent[i], found.magnetising_current[i]);
  }
  assign_rotor_circuit(
      motor::identified_machine(believed, {.stator_resistance = circuit.stator_resistance,
                                           .rotor_resistance = circuit.rotor_resistance,
                                           .leakage = circuit.leakage,
                                           .magnetising_inductance = fitted.magnetising_inductance}));
}

void Axis::assign_rotor_circuit(const motor::MachineData& machine) noexcept {
  assign_rounded(354, machine.induction.rotor_resistance);
  assign_rounded(356, machine.induction.stator_leakage - block<MotorModel>().settings.series_inductance);
  assign_rounded(358, machine.induction.rotor_leakage);
  assign_rounded(360, machine.induction.magnetising_inductance);
}

/// Parameter @p number becomes @p value (SI units) as a master could have written it.
void Axis::assign_rounded(std::uint16_t number, double value) noexcept {
  const ParameterRow& row = *find_parameter(kind(), number)->row;
  set_setting(row, 0, represented(row, value));
}

}  // namespace drive
