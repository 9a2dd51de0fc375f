#pragma once

#include "motor/lockstep/lane_train.hpp"

// How axes come into the lanes of a LaneTrain, what they do there by themselves, and how they leave.
namespace motor {

template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_machine(DriveTrain& train, Visitor visit) noexcept {
  if (auto* const machine = std::get_if<SynchronousMachine>(&train.plant_.machine_))
    return visit(machine_.template as<SynchronousEquations<Number>>(), *machine);
  if (auto* const machine = std::get_if<InductionMachine>(&train.plant_.machine_))
    visit(machine_.template as<InductionEquations<Number>>(), *machine);
}

template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_shaft(DriveTrain& train, Visitor visit) noexcept {
  if (auto* const shaft = std::get_if<RigidShaft<true>>(&train.plant_.shaft_))
    return visit(shaft_.template as<RigidShaft<true, Number>>(), *shaft);
  if (auto* const shaft = std::get_if<RigidShaft<false>>(&train.plant_.shaft_))
    return visit(shaft_.template as<RigidShaft<false, Number>>(), *shaft);
  if (auto* const shaft = std::get_if<ElasticShaft>(&train.plant_.shaft_))
    visit(shaft_.template as<ElasticShaftOf<Number>>(), *shaft);
}

/// Whether an object of one axis holds @p count numbers one after the other, as the same in lanes does.
template <class Axis>
constexpr bool holds(std::size_t count) noexcept {
  return sizeof(Axis) == count * sizeof(double) || sizeof(Axis) == (count + 1) * sizeof(double);
}

/// Numbers of @p Control before its curves.
template <class Number, class Control>
constexpr std::size_t control_numbers() noexcept {
  constexpr std::size_t kAll = kNumbers<Number, Control>;
  constexpr bool kHasCurves = std::is_same_v<Control, FieldControl<SynchronousField<Number>>>;
  return kHasCurves ? kAll - 3 * kNumbers<Number, LaneCurves<Number>> : kAll;
}

template <class Number>
void LaneTrain<Number>::enter_control(std::size_t lane) noexcept {
  DriveTrain& train = *trains_[lane];
  if (static_cast<DriveTrain::Lead>(kind_.control) == DriveTrain::Lead::Synchronous) {
    auto& control = control_.template as<SynchronousControl>();
    enter<Number>(control, lane, train.synchronous_, control_numbers<Number, SynchronousControl>());
    control.field().set_curves(lane, train.synchronous_.field());
  } else if (static_cast<DriveTrain::Lead>(kind_.control) == DriveTrain::Lead::Induction) {
    enter<Number>(control_.template as<InductionControl>(), lane, train.induction_);
  } else {
    enter<Number>(control_.template as<FrequencyControl>(), lane, train.voltage_frequency_);
  }
}

template <class Number>
void LaneTrain<Number>::leave_control(std::size_t lane) noexcept {
  DriveTrain& train = *trains_[lane];
  if (static_cast<DriveTrain::Lead>(kind_.control) == DriveTrain::Lead::Synchronous)
    motor::leave<Number>(control_.template as<SynchronousControl>(), lane, train.synchronous_,
                         control_numbers<Number, SynchronousControl>());
  else if (static_cast<DriveTrain::Lead>(kind_.control) == DriveTrain::Lead::Induction)
    motor::leave<Number>(control_.template as<InductionControl>(), lane, train.induction_);
  else
    motor::leave<Number>(control_.template as<FrequencyControl>(), lane, train.voltage_frequency_);
}

template <class Number>
void LaneTrain<Number>::enter_lane(std::size_t lane) noexcept {
  DriveTrain& train = *trains_[lane];
  enter<Number>(state_, lane, train.state_);
  enter<Number>(sums_, lane, train.sums_);
  enter<Number>(inverter_, lane, train.power_unit_.inverter());
  enter<Number>(encoder_, lane, train.encoder_.track_);
  counting_[lane] = train.encoder_.counts_all() ? 1.0 : 0.0;
  enter<Number>(plant_, lane, train.plant_.motion_);
  profiles_.set(lane, train.plant_.profile_);
  enter_control(lane);
  static_assert(holds<TrainState<double>>(kNumbers<Number, TrainState<Number>>));
  static_assert(holds<StepSums<double>>(kNumbers<Number, StepSums<Number>>));
  static_assert(holds<InverterLosses<double>>(kNumbers<Number, InverterLosses<Number>>));
  static_assert(holds<EncoderTrack<double>>(kNumbers<Number, EncoderTrack<Number>>));
  static_assert(holds<PlantMotion<double>>(kNumbers<Number, PlantMotion<Number>>));
  static_assert(holds<SynchronousEquations<double>>(kNumbers<Number, SynchronousEquations<Number>>));
  static_assert(holds<InductionEquations<double>>(kNumbers<Number, InductionEquations<Number>>));
  static_assert(holds<RigidShaft<true>>(kNumbers<Number, RigidShaft<true, Number>>));
  static_assert(holds<ElasticShaft>(kNumbers<Number, ElasticShaftOf<Number>>));
  static_assert(holds<FieldControl<InductionField<double>>>(kNumbers<Number, InductionControl>));
  static_assert(holds<VoltageFrequencyControl<double>>(kNumbers<Number, FrequencyControl>));
  static_assert(sizeof(FieldControl<SynchronousField<double>>) - sizeof(SynchronousReference) ==
                sizeof(double) * (kNumbers<Number, SynchronousControl> - kNumbers<Number, SynchronousCurrents<Number>>));
  static_assert(kNumbers<Number, SynchronousCurrents<Number>> - 3 * kNumbers<Number, LaneCurves<Number>> ==
                (sizeof(SynchronousCurrents<double>) - 3 * sizeof(Curve)) / sizeof(double));
  const auto enter_it = [lane](auto& in_lanes, const auto& axis) { enter<Number>(in_lanes, lane, axis); };
  visit_machine(train, enter_it);
  visit_shaft(train, enter_it);
  signals_.measured_speed[lane] = train.signals_.measured_speed;
  signals_.flux[lane] = train.signals_.flux;
  signals_.magnetised[lane] = train.signals_.magnetised;
}

template <class Number>
void LaneTrain<Number>::leave_lane(std::size_t lane) noexcept {
  DriveTrain& train = *trains_[lane];
  motor::leave<Number>(state_, lane, train.state_);
  motor::leave<Number>(sums_, lane, train.sums_);
  motor::leave<Number>(inverter_, lane, train.power_unit_.inverter());
  motor::leave<Number>(encoder_, lane, train.encoder_.track_);
  train.encoder_.count(counted_[lane]);
  motor::leave<Number>(plant_, lane, train.plant_.motion_);
  leave_control(lane);
  const auto leave_it = [lane](const auto& in_lanes, auto& axis) { motor::leave<Number>(in_lanes, lane, axis); };
  visit_machine(train, leave_it);
  visit_shaft(train, leave_it);
  give_signals(lane);
}

template <class Number>
void LaneTrain<Number>::give_signals(std::size_t lane) noexcept {
  Signals& signals = trains_[lane]->signals_;
  signals.measured_speed = signals_.measured_speed[lane];
  signals.true_speed = signals_.true_speed[lane];
  signals.torque_setpoint = signals_.torque_setpoint[lane];
  signals.torque = signals_.torque[lane];
  signals.true_torque = signals_.true_torque[lane];
  signals.encoder_counts = trains_[lane]->encoder_.counts();
  signals.torque_limit_reached = signals_.torque_limit_reached[lane];
  signals.torque_limits = {signals_.torque_limits.upper[lane], signals_.torque_limits.lower[lane]};
  signals.d_current = signals_.d_current[lane];
  signals.q_current = signals_.q_current[lane];
  signals.d_current_setpoint = signals_.d_current_setpoint[lane];
  signals.q_current_setpoint = signals_.q_current_setpoint[lane];
  signals.current = signals_.current[lane];
  signals.voltage = signals_.voltage[lane];
  signals.frequency = signals_.frequency[lane];
  signals.power = signals_.power[lane];
  signals.voltage_limited = signals_.voltage_limited[lane];
  signals.magnetised = signals_.magnetised[lane];
  signals.flux = signals_.flux[lane];
}

template <class Number>
void LaneTrain<Number>::take_commands(std::span<const AxisRun> axes) noexcept {
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    const AxisRun& axis = axes[places_[lane]];
    trip_current_[lane] = axis.trip_current;
    command_.speed_setpoint[lane] = axis.command.speed_setpoint;
    command_.acceleration_setpoint[lane] = axis.command.acceleration_setpoint;
    command_.torque_control[lane] = axis.command.torque_control;
    command_.torque_setpoint[lane] = axis.command.torque_setpoint;
    command_.additional_torque[lane] = axis.command.additional_torque;
    command_.limits.upper[lane] = axis.command.limits.upper;
    command_.limits.lower[lane] = axis.command.limits.lower;
  }
}

/// Temperatures of the axes whose turn it is, and what depends on them.
template <class Number>
void LaneTrain<Number>::warm() noexcept {
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    if (state_.heat.steps[lane] < TrainState<Number>::kWarmSteps) continue;
    DriveTrain& train = *trains_[lane];
    if (lane < count_) {
      motor::leave<Number>(state_.heat, lane, train.state_.heat);
      visit_machine(train, [lane](const auto& in_lanes, auto& axis) { motor::leave<Number>(in_lanes, lane, axis); });
      train.warm();
    }
    enter<Number>(state_.heat, lane, train.state_.heat);
    visit_machine(train, [lane](auto& in_lanes, const auto& axis) { enter<Number>(in_lanes, lane, axis); });
  }
}

/// The encoders that have come past a zero mark compare what they have counted.
template <class Number>
void LaneTrain<Number>::pass_marks() noexcept {
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    if (!encoder_.is_past_mark()[lane]) continue;
    DriveTrain& train = *trains_[lane];
    if (lane < count_) {
      motor::leave<Number>(encoder_, lane, train.encoder_.track_);
      train.encoder_.count(counted_[lane]);
    }
    enter<Number>(encoder_, lane, train.encoder_.track_);
    counted_[lane] = 0.0;
  }
}

}  // namespace motor
