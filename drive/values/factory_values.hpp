#pragma once

#include <cstddef>
#include <cstdint>

#include "drive/parameter/rounding.hpp"
#include "drive/parameter/row.hpp"

/// Factory values that depend on the drive object, in the unit of the parameter. "Factory" is the state of a new
/// unit: commissioned for the machine of its configuration and with the predefined connection set of CANopen.
namespace drive::factory {

// The machine of the axis.
/// A number of its data sheet, in @p Shown.
template <double motor::MachineData::*Value, Unit Shown>
double machine_value(const ObjectContext& context, std::size_t) noexcept {
  return rounded(context.axis.machine.*Value / row_of(Shown).si);
}
double motor_type(const ObjectContext& context, std::size_t index) noexcept;
double pole_pairs(const ObjectContext& context, std::size_t index) noexcept;
double magnetising_current(const ObjectContext& context, std::size_t index) noexcept;
double rotor_resistance(const ObjectContext& context, std::size_t index) noexcept;
double stator_leakage(const ObjectContext& context, std::size_t index) noexcept;
double rotor_leakage(const ObjectContext& context, std::size_t index) noexcept;
double main_inductance(const ObjectContext& context, std::size_t index) noexcept;
double direct_inductance(const ObjectContext& context, std::size_t index) noexcept;
/// Point @p point (0..3) of the magnetising characteristic.
double characteristic_current_of(unsigned point, const ObjectContext& context) noexcept;
template <unsigned Point>
double characteristic_current(const ObjectContext& context, std::size_t) noexcept {
  return characteristic_current_of(Point, context);
}
double rated_speed(const ObjectContext& context, std::size_t index) noexcept;
double motor_maximum_speed(const ObjectContext& context, std::size_t index) noexcept;
double rated_torque(const ObjectContext& context, std::size_t index) noexcept;
double rated_power(const ObjectContext& context, std::size_t index) noexcept;
double motor_inertia(const ObjectContext& context, std::size_t index) noexcept;
double inertia_ratio(const ObjectContext& context, std::size_t index) noexcept;
double encoder_pulses(const ObjectContext& context, std::size_t index) noexcept;
double encoder_type(const ObjectContext& context, std::size_t index) noexcept;
double encoder_fine_bits(const ObjectContext& context, std::size_t index) noexcept;

// The mechanics behind it.
double gear_motor_revolutions(const ObjectContext& context, std::size_t index) noexcept;  ///< p2504
double gear_load_revolutions(const ObjectContext& context, std::size_t index) noexcept;   ///< p2505
/// p2506: µm where a revolution of the load is a way.
double units_per_load_revolution(const ObjectContext& context, std::size_t index) noexcept;

// What commissioning computes for it.
double overspeed_hysteresis(const ObjectContext& context, std::size_t index) noexcept;
double speed_gain(const ObjectContext& context, std::size_t index) noexcept;
double speed_integral_time(const ObjectContext& context, std::size_t index) noexcept;
double encoderless_speed_gain(const ObjectContext& context, std::size_t index) noexcept;
double encoderless_speed_integral_time(const ObjectContext& context, std::size_t index) noexcept;
double brake_configuration(const ObjectContext& context, std::size_t index) noexcept;
double brake_opening_time(const ObjectContext& context, std::size_t index) noexcept;
double brake_closing_time(const ObjectContext& context, std::size_t index) noexcept;
double current_limit(const ObjectContext& context, std::size_t index) noexcept;
double motoring_power_limit(const ObjectContext& context, std::size_t index) noexcept;
double regenerative_power_limit(const ObjectContext& context, std::size_t index) noexcept;
double upper_torque_limit(const ObjectContext& context, std::size_t index) noexcept;
double lower_torque_limit(const ObjectContext& context, std::size_t index) noexcept;
double tracking_source(const ObjectContext& context, std::size_t index) noexcept;
double reference_coordinate_source(const ObjectContext& context, std::size_t index) noexcept;
double sampling_times(const ObjectContext& context, std::size_t index) noexcept;
double vector_sampling_times(const ObjectContext& context, std::size_t index) noexcept;

// What the speed setpoint is wired to: in front of the extended setpoint channel, or behind it where there is
// none.
double main_setpoint(const ObjectContext& context, std::size_t index) noexcept;
double speed_setpoint(const ObjectContext& context, std::size_t index) noexcept;
double message_setpoint(const ObjectContext& context, std::size_t index) noexcept;

// The drive objects of the unit.
double cyclic_object(const ObjectContext& context, std::size_t index) noexcept;  ///< p0978: axes, then the unit
double object_number(const ObjectContext& context, std::size_t index) noexcept;
double object_type(const ObjectContext& context, std::size_t index) noexcept;
double object_modules(const ObjectContext& context, std::size_t index) noexcept;

// CANopen.
double node_id(const ObjectContext& context, std::size_t index) noexcept;
double identity(const ObjectContext& context, std::size_t index) noexcept;
double emergency_cob_id(const ObjectContext& context, std::size_t index) noexcept;
double server_cob_id(const ObjectContext& context, std::size_t index) noexcept;
double bit_timing(const ObjectContext& context, std::size_t index) noexcept;
double acknowledge_source(const ObjectContext& context, std::size_t index) noexcept;
double send_words(const ObjectContext& context, std::size_t index) noexcept;
double send_double_words(const ObjectContext& context, std::size_t index) noexcept;

/// Parameters of RPDO or TPDO @p pdo (0..7): of the first axis the first four are valid.
double receive_pdo_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept;
double transmit_pdo_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept;
/// Mapping entries of RPDO or TPDO @p pdo (0..3), which name the objects of the axis.
double receive_mapping_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept;
double transmit_mapping_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept;

template <unsigned Pdo>
double receive_pdo(const ObjectContext& context, std::size_t index) noexcept {
  return receive_pdo_of(Pdo, context, index);
}
template <unsigned Pdo>
double transmit_pdo(const ObjectContext& context, std::size_t index) noexcept {
  return transmit_pdo_of(Pdo, context, index);
}
template <unsigned Pdo>
double receive_mapping(const ObjectContext& context, std::size_t index) noexcept {
  return receive_mapping_of(Pdo, context, index);
}
template <unsigned Pdo>
double transmit_mapping(const ObjectContext& context, std::size_t index) noexcept {
  return transmit_mapping_of(Pdo, context, index);
}

}  // namespace drive::factory
