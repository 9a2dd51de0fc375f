#include "drive/values/identification_values.hpp"

#include "drive/axis/axis.hpp"
#include "drive/machine/machine_model.hpp"

namespace drive::identification_value {
namespace {

/// A number of the last measurement at standstill, in @p shown.
double found(const Axis& axis, double motor::StandstillResult::*value, Unit shown) noexcept {
  const auto& result = axis.identification().results().standstill;
  return result ? (*result).*value / row_of(shown).si : 0.0;
}

std::int32_t code(double value) noexcept {
  return static_cast<std::int32_t>(value);
}

}  // namespace

double progress(const Axis& axis, std::size_t) noexcept {
  return axis.identification().progress();
}

double both(const Axis& axis, std::size_t) noexcept {
  return axis.identification().selection().both;
}
double standstill(const Axis& axis, std::size_t) noexcept {
  return axis.identification().selection().standstill;
}
double rotating(const Axis& axis, std::size_t) noexcept {
  return axis.identification().selection().rotating;
}
void select_both(Axis& axis, std::size_t, double value) noexcept {
  axis.select_identification(code(value));
}
void select_standstill(Axis& axis, std::size_t, double value) noexcept {
  axis.select_standstill_measurement(code(value));
}
void select_rotating(Axis& axis, std::size_t, double value) noexcept {
  axis.select_rotating_measurement(code(value));
}

double d_inductance(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::d_inductance, Unit::Millihenries);
}
double inertia(const Axis& axis, std::size_t) noexcept {
  const auto& result = axis.identification().results().rotating;
  return result ? result->inertia : 0.0;
}
double leakage(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::leakage, Unit::Millihenries);
}
double magnetising_inductance(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::magnetising_inductance, Unit::Millihenries);
}
double pole_position(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::pole_position, Unit::Degrees);
}
double q_inductance(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::q_inductance, Unit::Millihenries);
}
double rotor_resistance(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::rotor_resistance, Unit::Ohms);
}
double rotor_time_constant(const Axis& axis, std::size_t) noexcept {
  const double resistance = rotor_resistance(axis, 0);
  if (!(resistance > 0.0)) return 0.0;
  const double inductance = found(axis, &motor::StandstillResult::magnetising_inductance, Unit::None);
  return inductance / resistance / row_of(Unit::Milliseconds).si;
}
double stator_resistance(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::stator_resistance, Unit::Ohms);
}
double threshold_voltage(const Axis& axis, std::size_t) noexcept {
  return found(axis, &motor::StandstillResult::threshold_voltage, Unit::Volts);
}
double torque_constant(const Axis& axis, std::size_t) noexcept {
  const auto& result = axis.identification().results().rotating;
  const motor::MachineData& data_sheet = axis.context().axis.machine;
  const bool known = result && data_sheet.type == motor::MachineType::Synchronous;
  return known ? drive::torque_constant(data_sheet, result->magnet_flux) : 0.0;
}

}  // namespace drive::identification_value
