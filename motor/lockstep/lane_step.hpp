#pragma once

#include "motor/lockstep/lane_train.hpp"

// What happens to the axes of a LaneTrain in a control period.
namespace motor {

/// Setpoints that change from period to period.
template <class Number>
void LaneTrain<Number>::lead(std::size_t period) noexcept {
  LaneArray<Number> speed = array(command_.speed_setpoint);
  LaneArray<Number> acceleration = array(command_.acceleration_setpoint);
  for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
    if (setpoints_[lane].empty()) continue;
    speed[lane] = setpoints_[lane][period].speed;
    acceleration[lane] = setpoints_[lane][period].acceleration;
  }
  command_.speed_setpoint = lanes<Number>(speed);
  command_.acceleration_setpoint = lanes<Number>(acceleration);
}

template <class Number>
SpaceVectorOf<Number> LaneTrain<Number>::control(const Number& dc_voltage) noexcept {
  switch (static_cast<DriveTrain::Lead>(kind_.control)) {
    case DriveTrain::Lead::Synchronous:
      return kind_.with_encoder ? control_by<SynchronousControl, true>(dc_voltage)
                                : control_by<SynchronousControl, false>(dc_voltage);
    case DriveTrain::Lead::Induction:
      return kind_.with_encoder ? control_by<InductionControl, true>(dc_voltage)
                                : control_by<InductionControl, false>(dc_voltage);
    case DriveTrain::Lead::VoltageFrequency:
    case DriveTrain::Lead::Excitation:
      break;
  }
  return control_by<FrequencyControl, false>(dc_voltage);
}

template <class Number>
template <class Control, bool WithEncoder>
MOTOR_IN_ONE [[gnu::noinline]] SpaceVectorOf<Number> LaneTrain<Number>::control_by(
    const Number& dc_voltage) noexcept {
  const MeasurementOf<Number> measured{plant_.state.current, state_.voltage, plant_.direction, encoder_.speed,
                                       dc_voltage};
  Control& control = control_.template as<Control>();
  if constexpr (std::is_same_v<Control, FrequencyControl>)
    return control.step(measured, command_, signals_);
  else if constexpr (WithEncoder)
    return control.with_encoder(measured, command_, signals_);
  else
    return control.without_encoder(measured, command_, signals_);
}

/// The machine with the voltage that was calculated in the period before.
template <class Number>
void LaneTrain<Number>::move(const Number& dc_voltage) noexcept {
  state_.voltage = state_.next;
  shown_ = false;
  if (const Condition<Number> ideal = inverter_.is_ideal(); all(ideal)) [[likely]] {
    turn(state_.next);
  } else {
    const SpaceVectorOf<Number> before = plant_.state.current;
    const SpaceVectorOf<Number> drop =
        select(ideal, SpaceVectorOf<Number>{}, inverter_.distortion(before, dc_voltage));
    turn(state_.next - drop);
    inverter_.set_drop_losses(1.5 * dot(drop, 0.5 * (before + plant_.state.current)));
  }
  state_.book(plant_.state, plant_.energies, Condition<Number>{true}, inverter_, signals_);
  if (any(state_.heat.steps == TrainState<Number>::kWarmSteps)) [[unlikely]]
    warm();
}

template <class Number>
void LaneTrain<Number>::turn(const SpaceVectorOf<Number>& voltage) noexcept {
  using Synchronous = SynchronousEquations<Number>;
  using Induction = InductionEquations<Number>;
  switch (kind_.machine * 3 + kind_.shaft) {
    case 0:
      return turn_shaft<Synchronous, RigidShaft<true, Number>>(voltage);
    case 1:
      return turn_shaft<Synchronous, RigidShaft<false, Number>>(voltage);
    case 2:
      return turn_shaft<Synchronous, ElasticShaftOf<Number>>(voltage);
    case 3:
      return turn_shaft<Induction, RigidShaft<true, Number>>(voltage);
    case 4:
      return turn_shaft<Induction, RigidShaft<false, Number>>(voltage);
    default:
      return turn_shaft<Induction, ElasticShaftOf<Number>>(voltage);
  }
}

template <class Number>
template <class Machine, class Shaft>
MOTOR_IN_ONE [[gnu::noinline]] void LaneTrain<Number>::turn_shaft(const SpaceVectorOf<Number>& voltage) noexcept {
  plant_.drive(machine_.template as<Machine>(), shaft_.template as<Shaft>(), profiles_, voltage);
}

template <class Number>
void LaneTrain<Number>::observe() noexcept {
  const Number moved = encoder_.turn_to(plant_.state.revolutions, plant_.state.rotor_angle);
  encoder_.follow(select<Number>(counting_ > 0.0, moved, 0.0));
  counted_ += moved;
  if (kind_.with_encoder) signals_.measured_speed = encoder_.speed;
  sums_.add(signals_);
  if (any(encoder_.is_past_mark())) [[unlikely]]
    pass_marks();
}

}  // namespace motor
