// What parameters show of the machine, its power unit and the DC link.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "drive/axis/axis.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::axis_value {
namespace {

using std::numbers::sqrt2;
using std::numbers::sqrt3;

constexpr double kPercent = row_of(Unit::Percent).si;
constexpr std::size_t kOfThePowerUnit = 1;
constexpr std::size_t kFirstEncoder = 0;

/// @p amplitude of a phase as a value between lines (rms).
double between_lines(double amplitude) noexcept {
  return amplitude * sqrt3 / sqrt2;
}

}  // namespace

double output_frequency(const Axis& axis, std::size_t) noexcept {
  return axis.signals().frequency / (2.0 * std::numbers::pi);
}
double output_voltage(const Axis& axis, std::size_t) noexcept {
  return between_lines(axis.signals().voltage);
}
double dc_voltage(const Axis& axis, std::size_t) noexcept {
  return axis.block<PowerUnit>().dc_voltage();
}
double current(const Axis& axis, std::size_t) noexcept {
  return axis.signals().current / sqrt2;
}
double modulation_depth(const Axis& axis, std::size_t) noexcept {
  const double highest = axis.block<PowerUnit>().dc_voltage() / sqrt3;
  return highest > 0.0 ? axis.signals().voltage / highest / kPercent : 0.0;
}
double field_current(const Axis& axis, std::size_t) noexcept {
  return axis.signals().d_current / sqrt2;
}
double torque_current(const Axis& axis, std::size_t) noexcept {
  return axis.signals().q_current / sqrt2;
}
double torque_current_setpoint(const Axis& axis, std::size_t) noexcept {
  return axis.signals().q_current_setpoint / sqrt2;
}
double phase_current(const Axis& axis, std::size_t index) noexcept {
  const std::array phases = motor::phase_values(axis.drive_train().plant_state().current);
  return index < phases.size() ? phases[index] : 0.0;
}
double absolute_position(const Axis& axis, std::size_t index) noexcept {
  if (index != kFirstEncoder) return 0.0;
  return axis.block<EncoderInterface>().second_value(axis.has_encoder_fault(),
                                                     axis.drive_train().encoder().absolute_position());
}
double encoder_status(const Axis& axis, std::size_t index) noexcept {
  return index == kFirstEncoder ? axis.block<EncoderInterface>().status(axis.has_encoder_fault()) : 0.0;
}
double maximum_current(const Axis& axis, std::size_t index) noexcept {
  const double of_the_unit = axis.context().axis.inverter.maximum_current;
  return index == kOfThePowerUnit ? of_the_unit
                                  : std::min(axis.drive_train().settings().current_limit, of_the_unit);
}
/// Of the units of the series: 9.7 kW at 18 A, the others in proportion.
double rated_power(const Axis& axis, std::size_t) noexcept {
  constexpr double kOfTheSeries = 9.7 / 18.0;  // kW/A
  return axis.context().axis.inverter.rated_current * kOfTheSeries;
}
double serial_number(const Axis& axis, std::size_t index) noexcept {
  constexpr std::string_view kPrefix = "AXSIM0000000000";
  return index < kPrefix.size() ? kPrefix[index] : '0' + axis.number() % 10;
}
double magnetising_current(const Axis& axis, std::size_t) noexcept {
  return axis.block<MotorModel>().settings.magnetising_current;
}
double motor_utilisation(const Axis& axis, std::size_t) noexcept {
  return axis.signals().motor_utilisation / kPercent;
}
double motor_temperature(const Axis& axis, std::size_t) noexcept {
  return axis.signals().winding_temperature;
}
double overload(const Axis& axis, std::size_t) noexcept {
  return axis.signals().overload / kPercent;
}
double power_unit_temperature(const Axis& axis, std::size_t index) noexcept {
  const std::array bodies{axis.signals().heat_sink_temperature, axis.signals().chip_temperature};
  return index < bodies.size() ? bodies[index] : axis.context().axis.inverter.ambient;
}

}  // namespace drive::axis_value
