#pragma once

#include <cstddef>

namespace drive {
class Axis;
}

/// What parameters show of an axis, each in the unit of its parameter, and what its commands do.
namespace drive::axis_value {

double active_power(const Axis& axis, std::size_t index) noexcept;
double control_status(const Axis& axis, std::size_t index) noexcept;
double controlword(const Axis& axis, std::size_t index) noexcept;
double directed_setpoint(const Axis& axis, std::size_t index) noexcept;
double encoder_position(const Axis& axis, std::size_t index) noexcept;
/// r0481, a word for each encoder.
double encoder_status(const Axis& axis, std::size_t index) noexcept;
double encoder_speed(const Axis& axis, std::size_t index) noexcept;
double energy(const Axis& axis, std::size_t index) noexcept;
double fixed_setpoint(const Axis& axis, std::size_t index) noexcept;
double function_modules(const Axis& axis, std::size_t index) noexcept;
double lower_torque_limit(const Axis& axis, std::size_t index) noexcept;
double message_control(const Axis& axis, std::size_t index) noexcept;
double missing_enables(const Axis& axis, std::size_t index) noexcept;
double mode(const Axis& axis, std::size_t index) noexcept;
double monitoring_1(const Axis& axis, std::size_t index) noexcept;
double monitoring_2(const Axis& axis, std::size_t index) noexcept;
double monitoring_3(const Axis& axis, std::size_t index) noexcept;
double no_value(const Axis& axis, std::size_t index) noexcept;
double operating_display(const Axis& axis, std::size_t index) noexcept;
double pole_pairs(const Axis& axis, std::size_t index) noexcept;
double process_energy(const Axis& axis, std::size_t index) noexcept;
double rated_power(const Axis& axis, std::size_t index) noexcept;
double ramp_acceleration(const Axis& axis, std::size_t index) noexcept;
double ramp_input(const Axis& axis, std::size_t index) noexcept;
double ramp_output(const Axis& axis, std::size_t index) noexcept;
double reference_power(const Axis& axis, std::size_t index) noexcept;
double sequence_control(const Axis& axis, std::size_t index) noexcept;
double sequence_status(const Axis& axis, std::size_t index) noexcept;
double serial_number(const Axis& axis, std::size_t index) noexcept;
double setpoint_sum(const Axis& axis, std::size_t index) noexcept;
double speed(const Axis& axis, std::size_t index) noexcept;
double speed_controller_control(const Axis& axis, std::size_t index) noexcept;
double speed_controller_status(const Axis& axis, std::size_t index) noexcept;
double speed_status(const Axis& axis, std::size_t index) noexcept;
double speed_demand(const Axis& axis, std::size_t index) noexcept;
double speed_deviation(const Axis& axis, std::size_t index) noexcept;
double starting_time(const Axis& axis, std::size_t index) noexcept;
double statusword(const Axis& axis, std::size_t index) noexcept;
double torque(const Axis& axis, std::size_t index) noexcept;
double torque_demand(const Axis& axis, std::size_t index) noexcept;
double torque_utilisation(const Axis& axis, std::size_t index) noexcept;
double upper_torque_limit(const Axis& axis, std::size_t index) noexcept;

// Machine and power unit (axis_electrical_values.cpp).
double output_frequency(const Axis& axis, std::size_t index) noexcept;
double output_voltage(const Axis& axis, std::size_t index) noexcept;
double dc_voltage(const Axis& axis, std::size_t index) noexcept;
double current(const Axis& axis, std::size_t index) noexcept;
double modulation_depth(const Axis& axis, std::size_t index) noexcept;
double field_current(const Axis& axis, std::size_t index) noexcept;
double torque_current(const Axis& axis, std::size_t index) noexcept;
double torque_current_setpoint(const Axis& axis, std::size_t index) noexcept;
double absolute_position(const Axis& axis, std::size_t index) noexcept;
double phase_current(const Axis& axis, std::size_t index) noexcept;
double maximum_current(const Axis& axis, std::size_t index) noexcept;
double magnetising_current(const Axis& axis, std::size_t index) noexcept;
double motor_utilisation(const Axis& axis, std::size_t index) noexcept;
double motor_temperature(const Axis& axis, std::size_t index) noexcept;
double overload(const Axis& axis, std::size_t index) noexcept;
double power_unit_temperature(const Axis& axis, std::size_t index) noexcept;

// Positioning (axis_position_values.cpp).
double position_status(const Axis& axis, std::size_t index) noexcept;
double encoder_position_status_of(const Axis& axis, std::size_t encoder) noexcept;
template <std::size_t Encoder>
double encoder_position_status(const Axis& axis, std::size_t) noexcept {
  return encoder_position_status_of(axis, Encoder);
}
double positioner_status_1(const Axis& axis, std::size_t index) noexcept;
double positioner_status_2(const Axis& axis, std::size_t index) noexcept;
double fixed_stop_limit(const Axis& axis, std::size_t index) noexcept;
double fixed_stop_torque(const Axis& axis, std::size_t index) noexcept;
/// p2624: 1 sorts the traversing blocks.
void sort_blocks(Axis& axis, std::size_t index, double value) noexcept;

/// p0340: computes control parameters anew.
void compute_parameters(Axis& axis, std::size_t index, double value) noexcept;
/// p0970: 1 returns to the state of a new drive object and ends commissioning.
void reset_parameters(Axis& axis, std::size_t index, double value) noexcept;

}  // namespace drive::axis_value
