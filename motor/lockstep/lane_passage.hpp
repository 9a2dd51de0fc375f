#pragma once

#include "motor/lockstep/lane_train.hpp"

// How axes come into the lanes of a LaneTrain, what they do there by themselves, and how they leave.
namespace motor {

/// Whether an object of one axis holds @p count numbers one after the other, as the same in lanes does.
template <class Axis>
constexpr bool holds(std::size_t count) noexcept {
  return sizeof(Axis) == count * sizeof(double) || sizeof(Axis) == (count + 1) * sizeof(double);
}

/// Where the numbers of @p object begin.
template <class Axis>
double* numbers_of(Axis& object) noexcept {
  return reinterpret_cast<double*>(&object);
}

/// Calls @p visit with room for a machine in lanes and with what finds the same of a drive train.
template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_machine(Visitor visit) noexcept {
  if (kind_.machine == 0)
    visit(machine_.template as<SynchronousEquations<Number>>(), [](DriveTrain& train) {
      return numbers_of<SynchronousEquations<double>>(*std::get_if<SynchronousMachine>(&train.plant_.machine_));
    });
  else
    visit(machine_.template as<InductionEquations<Number>>(), [](DriveTrain& train) {
      return numbers_of<InductionEquations<double>>(*std::get_if<InductionMachine>(&train.plant_.machine_));
    });
}
template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_shaft(Visitor visit) noexcept {
  if (kind_.shaft == 0)
    visit(shaft_.template as<RigidShaft<true, Number>>(),
          [](DriveTrain& train) { return numbers_of(*std::get_if<RigidShaft<true>>(&train.plant_.shaft_)); });
  else if (kind_.shaft == 1)
    visit(shaft_.template as<RigidShaft<false, Number>>(),
          [](DriveTrain& train) { return numbers_of(*std::get_if<RigidShaft<false>>(&train.plant_.shaft_)); });
  else
    visit(shaft_.template as<ElasticShaftOf<Number>>(),
          [](DriveTrain& train) { return numbers_of(*std::get_if<ElasticShaft>(&train.plant_.shaft_)); });
}
/// The same with the control, and with how many of its numbers a step changes and how many there are before its
/// curves.
template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_control(Visitor visit) noexcept {
  constexpr std::size_t kCurrents = kNumbers<Number, SynchronousCurrents<Number>>;
  constexpr std::size_t kCurves = 3 * kNumbers<Number, LaneCurves<Number>>;
  constexpr std::size_t kSynchronous = kNumbers<Number, SynchronousControl>;
  switch (static_cast<DriveTrain::Lead>(kind_.control)) {
    case DriveTrain::Lead::Synchronous:
      return visit(
          control_.template as<SynchronousControl>(),
          [](DriveTrain& train) { return numbers_of(train.synchronous_); }, kSynchronous - kCurrents,
          kSynchronous - kCurves);
    case DriveTrain::Lead::Induction:
      return visit(
          control_.template as<InductionControl>(), [](DriveTrain& train) { return numbers_of(train.induction_); },
          kNumbers<Number, InductionControl>, kNumbers<Number, InductionControl>);
    case DriveTrain::Lead::VoltageFrequency:
    case DriveTrain::Lead::Excitation:
      return visit(
          control_.template as<FrequencyControl>(),
          [](DriveTrain& train) { return numbers_of(train.voltage_frequency_); },
          kNumbers<Number, FrequencyControl>, kNumbers<Number, FrequencyControl>);
  }
}

/// What @p find finds of each drive train.
template <class Number>
template <class Find>
LaneObjects<Number> LaneTrain<Number>::of_each(Find find) noexcept {
  LaneObjects<Number> result;
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) result[lane] = find(*trains_[lane]);
  return result;
}

/// Calls @p visit with each part that all kinds have alike, and with what finds the same of a drive train.
template <class Number>
template <class Visitor>
void LaneTrain<Number>::visit_common(Visitor visit) noexcept {
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
                sizeof(double) *
                    (kNumbers<Number, SynchronousControl> - kNumbers<Number, SynchronousCurrents<Number>>));
  static_assert(kNumbers<Number, SynchronousCurrents<Number>> - 3 * kNumbers<Number, LaneCurves<Number>> ==
                (sizeof(SynchronousCurrents<double>) - 3 * sizeof(Curve)) / sizeof(double));
  visit(state_, [](DriveTrain& train) { return numbers_of(train.state_); });
  visit(sums_, [](DriveTrain& train) { return numbers_of(train.sums_); });
  visit(inverter_, [](DriveTrain& train) { return numbers_of(train.power_unit_.inverter()); });
  visit(encoder_, [](DriveTrain& train) { return numbers_of(train.encoder_.track_); });
  visit(plant_, [](DriveTrain& train) { return numbers_of(train.plant_.motion_); });
}

template <class Number>
void LaneTrain<Number>::enter_trains() noexcept {
  visit_common([this](auto& part, auto find) { enter_all<Number>(part, of_each(find)); });
  visit_machine([this](auto& machine, auto find) { enter_all<Number>(machine, of_each(find)); });
  visit_shaft([this](auto& shaft, auto find) { enter_all<Number>(shaft, of_each(find)); });
  visit_control([this](auto& control, auto find, std::size_t, std::size_t count) {
    enter_all<Number>(control, of_each(find), count);
  });
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    DriveTrain& train = *trains_[lane];
    profiles_.set(lane, train.plant_.profile_);
    if (static_cast<DriveTrain::Lead>(kind_.control) == DriveTrain::Lead::Synchronous)
      control_.template as<SynchronousControl>().field().set_curves(lane, train.synchronous_.field());
  }
  counting_ = Number{[this](auto lane) { return trains_[lane]->encoder_.counts_all() ? 1.0 : 0.0; }};
  signals_.measured_speed = Number{[this](auto lane) { return trains_[lane]->signals_.measured_speed; }};
  signals_.flux = Number{[this](auto lane) { return trains_[lane]->signals_.flux; }};
  signals_.magnetised = Number{[this](auto lane) { return trains_[lane]->signals_.magnetised ? 1.0 : 0.0; }} > 0.0;
}

/// What of the plants only others want to know, at the end of a step and before anything warms.
template <class Number>
void LaneTrain<Number>::show() noexcept {
  visit_machine([this](auto& machine, auto) {
    visit_shaft([this, &machine](auto& shaft, auto) { plant_.show(machine, shaft); });
  });
  shown_ = true;
}

template <class Number>
void LaneTrain<Number>::leave() noexcept {
  signals_.voltage = length(state_.voltage);
  if (!shown_) show();
  // The lanes beyond the last axis do what the first does: to be left like it is no harm.
  visit_common([this](auto& part, auto find) { leave_all<Number>(part, of_each(find)); });
  visit_machine([this](auto& machine, auto find) {
    leave_all<Number>(machine, of_each(find), std::remove_reference_t<decltype(machine)>::kChanging);
  });
  visit_shaft([this](auto& shaft, auto find) {
    leave_all<Number>(shaft, of_each(find), std::remove_reference_t<decltype(shaft)>::kChanging);
  });
  visit_control([this](auto& control, auto find, std::size_t changing, std::size_t) {
    leave_all<Number>(control, of_each(find), changing);
  });
  for (std::size_t lane = 0; lane < count_; ++lane) {
    trains_[lane]->encoder_.count(counted_[lane]);
    give_signals(lane);
  }
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
void LaneTrain<Number>::take_commands() noexcept {
  const auto command = [&](auto lane) -> const DriveCommand& { return axes_[lane]->command; };
  trip_current_ = Number{[&](auto lane) { return axes_[lane]->trip_current; }};
  command_.speed_setpoint = Number{[&](auto lane) { return command(lane).speed_setpoint; }};
  command_.acceleration_setpoint = Number{[&](auto lane) { return command(lane).acceleration_setpoint; }};
  command_.torque_control = Number{[&](auto lane) { return command(lane).torque_control ? 1.0 : 0.0; }} > 0.0;
  command_.torque_setpoint = Number{[&](auto lane) { return command(lane).torque_setpoint; }};
  command_.additional_torque = Number{[&](auto lane) { return command(lane).additional_torque; }};
  command_.limits.upper = Number{[&](auto lane) { return command(lane).limits.upper; }};
  command_.limits.lower = Number{[&](auto lane) { return command(lane).limits.lower; }};
}

/// Temperatures of the axes whose turn it is, and what depends on them.
template <class Number>
void LaneTrain<Number>::warm() noexcept {
  show();
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    if (state_.heat.steps[lane] < TrainState<Number>::kWarmSteps) continue;
    DriveTrain& train = *trains_[lane];
    visit_machine([&](auto& machine, auto find) {
      if (lane < count_) {
        leave_one<Number>(state_.heat, lane, numbers_of(train.state_.heat));
        leave_one<Number>(machine, lane, find(train));
        train.warm();
      }
      enter_one<Number>(state_.heat, lane, numbers_of(train.state_.heat));
      enter_one<Number>(machine, lane, find(train));
    });
  }
}

/// The encoders that have come past a zero mark compare what they have counted.
template <class Number>
void LaneTrain<Number>::pass_marks() noexcept {
  const Condition<Number> past = encoder_.is_past_mark();
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    if (!past[lane]) continue;
    DriveTrain& train = *trains_[lane];
    if (lane < count_) {
      leave_one<Number>(encoder_, lane, numbers_of(train.encoder_.track_));
      train.encoder_.count(counted_[lane]);
    }
    enter_one<Number>(encoder_, lane, numbers_of(train.encoder_.track_));
  }
  counted_ = select<Number>(past, 0.0, counted_);
}

}  // namespace motor
