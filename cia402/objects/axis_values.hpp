#pragma once

#include <cstddef>
#include <cstdint>

#include "libcanopen/od/dictionary.hpp"

namespace cia402 {

/// The values of the objects of an axis (CiA 402-2), in the units of the bus, for the axis behind them.
class AxisValues {
 public:
  /// Of axis @p axis (1..8) in @p dictionary, which outlives this.
  AxisValues(canopen::Dictionary& dictionary, std::size_t axis)
      : dictionary_{dictionary}, shift_{kStride * (axis - 1)} {}

 private:
  static constexpr std::size_t kStride = 0x800;

  template <class T>
  canopen::Cell<T> at(std::uint16_t index, std::uint8_t sub_index = 0) {
    return dictionary_.cell<T>(static_cast<std::uint16_t>(index + shift_), sub_index);
  }

  canopen::Dictionary& dictionary_;
  std::size_t shift_;

 public:
  // State.
  canopen::Cell<std::int16_t> abort_connection_option{at<std::int16_t>(0x6007)};
  canopen::Cell<std::uint16_t> error_code{at<std::uint16_t>(0x603F)};
  canopen::Cell<std::uint16_t> controlword{at<std::uint16_t>(0x6040)};
  canopen::Cell<std::uint16_t> statusword{at<std::uint16_t>(0x6041)};
  canopen::Cell<std::int16_t> quick_stop_option{at<std::int16_t>(0x605A)};
  canopen::Cell<std::int16_t> shutdown_option{at<std::int16_t>(0x605B)};
  canopen::Cell<std::int16_t> disable_operation_option{at<std::int16_t>(0x605C)};
  canopen::Cell<std::int16_t> halt_option{at<std::int16_t>(0x605D)};
  canopen::Cell<std::int16_t> fault_reaction_option{at<std::int16_t>(0x605E)};
  canopen::Cell<std::int8_t> modes_of_operation{at<std::int8_t>(0x6060)};
  canopen::Cell<std::int8_t> modes_of_operation_display{at<std::int8_t>(0x6061)};

  // Position.
  canopen::Cell<std::int32_t> position_demand{at<std::int32_t>(0x6062)};
  canopen::Cell<std::int32_t> position_actual_internal{at<std::int32_t>(0x6063)};
  canopen::Cell<std::int32_t> position_actual{at<std::int32_t>(0x6064)};
  canopen::Cell<std::uint32_t> following_error_window{at<std::uint32_t>(0x6065)};
  canopen::Cell<std::uint16_t> following_error_time_out{at<std::uint16_t>(0x6066)};
  canopen::Cell<std::uint32_t> position_window{at<std::uint32_t>(0x6067)};
  canopen::Cell<std::uint16_t> position_window_time{at<std::uint16_t>(0x6068)};
  canopen::Cell<std::int32_t> target_position{at<std::int32_t>(0x607A)};
  canopen::Cell<std::int32_t> position_range_minimum{at<std::int32_t>(0x607B, 1)};
  canopen::Cell<std::int32_t> position_range_maximum{at<std::int32_t>(0x607B, 2)};
  canopen::Cell<std::int32_t> home_offset{at<std::int32_t>(0x607C)};
  canopen::Cell<std::int32_t> software_limit_minimum{at<std::int32_t>(0x607D, 1)};
  canopen::Cell<std::int32_t> software_limit_maximum{at<std::int32_t>(0x607D, 2)};
  canopen::Cell<std::int32_t> following_error{at<std::int32_t>(0x60F4)};
  canopen::Cell<std::int32_t> control_effort{at<std::int32_t>(0x60FA)};
  canopen::Cell<std::int32_t> position_demand_internal{at<std::int32_t>(0x60FC)};

  // Velocity.
  canopen::Cell<std::int32_t> velocity_demand{at<std::int32_t>(0x606B)};
  canopen::Cell<std::int32_t> velocity_actual{at<std::int32_t>(0x606C)};
  canopen::Cell<std::uint16_t> velocity_window{at<std::uint16_t>(0x606D)};
  canopen::Cell<std::uint16_t> velocity_window_time{at<std::uint16_t>(0x606E)};
  canopen::Cell<std::uint16_t> velocity_threshold{at<std::uint16_t>(0x606F)};
  canopen::Cell<std::uint16_t> velocity_threshold_time{at<std::uint16_t>(0x6070)};
  canopen::Cell<std::int32_t> target_velocity{at<std::int32_t>(0x60FF)};
  canopen::Cell<std::uint32_t> max_profile_velocity{at<std::uint32_t>(0x607F)};
  canopen::Cell<std::uint32_t> max_motor_speed{at<std::uint32_t>(0x6080)};
  canopen::Cell<std::int16_t> vl_target_velocity{at<std::int16_t>(0x6042)};
  canopen::Cell<std::int16_t> vl_velocity_demand{at<std::int16_t>(0x6043)};
  canopen::Cell<std::int16_t> vl_velocity_actual{at<std::int16_t>(0x6044)};
  canopen::Cell<std::uint32_t> vl_minimum{at<std::uint32_t>(0x6046, 1)};
  canopen::Cell<std::uint32_t> vl_maximum{at<std::uint32_t>(0x6046, 2)};
  canopen::Cell<std::uint32_t> vl_acceleration_speed{at<std::uint32_t>(0x6048, 1)};
  canopen::Cell<std::uint16_t> vl_acceleration_time{at<std::uint16_t>(0x6048, 2)};
  canopen::Cell<std::uint32_t> vl_deceleration_speed{at<std::uint32_t>(0x6049, 1)};
  canopen::Cell<std::uint16_t> vl_deceleration_time{at<std::uint16_t>(0x6049, 2)};

  // Torque.
  canopen::Cell<std::int16_t> target_torque{at<std::int16_t>(0x6071)};
  canopen::Cell<std::uint16_t> max_torque{at<std::uint16_t>(0x6072)};
  canopen::Cell<std::uint16_t> max_current{at<std::uint16_t>(0x6073)};
  canopen::Cell<std::int16_t> torque_demand{at<std::int16_t>(0x6074)};
  canopen::Cell<std::uint32_t> motor_rated_current{at<std::uint32_t>(0x6075)};
  canopen::Cell<std::uint32_t> motor_rated_torque{at<std::uint32_t>(0x6076)};
  canopen::Cell<std::int16_t> torque_actual{at<std::int16_t>(0x6077)};
  canopen::Cell<std::int16_t> current_actual{at<std::int16_t>(0x6078)};
  canopen::Cell<std::uint32_t> dc_link_voltage{at<std::uint32_t>(0x6079)};
  canopen::Cell<std::uint32_t> torque_slope{at<std::uint32_t>(0x6087)};
  canopen::Cell<std::int16_t> torque_profile_type{at<std::int16_t>(0x6088)};
  canopen::Cell<std::uint16_t> positive_torque_limit{at<std::uint16_t>(0x60E0)};
  canopen::Cell<std::uint16_t> negative_torque_limit{at<std::uint16_t>(0x60E1)};

  // Profile.
  canopen::Cell<std::uint32_t> profile_velocity{at<std::uint32_t>(0x6081)};
  canopen::Cell<std::uint32_t> end_velocity{at<std::uint32_t>(0x6082)};
  canopen::Cell<std::uint32_t> profile_acceleration{at<std::uint32_t>(0x6083)};
  canopen::Cell<std::uint32_t> profile_deceleration{at<std::uint32_t>(0x6084)};
  canopen::Cell<std::uint32_t> quick_stop_deceleration{at<std::uint32_t>(0x6085)};
  canopen::Cell<std::int16_t> motion_profile_type{at<std::int16_t>(0x6086)};
  canopen::Cell<std::uint32_t> profile_jerk{at<std::uint32_t>(0x60A4, 1)};
  canopen::Cell<std::uint32_t> max_acceleration{at<std::uint32_t>(0x60C5)};
  canopen::Cell<std::uint32_t> max_deceleration{at<std::uint32_t>(0x60C6)};
  canopen::Cell<std::uint16_t> positioning_option{at<std::uint16_t>(0x60F2)};

  // Quantities.
  canopen::Cell<std::uint8_t> polarity{at<std::uint8_t>(0x607E)};
  canopen::Cell<std::uint32_t> encoder_increments{at<std::uint32_t>(0x608F, 1)};
  canopen::Cell<std::uint32_t> encoder_revolutions{at<std::uint32_t>(0x608F, 2)};
  canopen::Cell<std::uint32_t> gear_motor{at<std::uint32_t>(0x6091, 1)};
  canopen::Cell<std::uint32_t> gear_shaft{at<std::uint32_t>(0x6091, 2)};
  canopen::Cell<std::uint32_t> feed{at<std::uint32_t>(0x6092, 1)};
  canopen::Cell<std::uint32_t> feed_shaft{at<std::uint32_t>(0x6092, 2)};

  // Homing.
  canopen::Cell<std::int8_t> homing_method{at<std::int8_t>(0x6098)};
  canopen::Cell<std::uint32_t> homing_switch_speed{at<std::uint32_t>(0x6099, 1)};
  canopen::Cell<std::uint32_t> homing_zero_speed{at<std::uint32_t>(0x6099, 2)};
  canopen::Cell<std::uint32_t> homing_acceleration{at<std::uint32_t>(0x609A)};

  // Cyclic.
  canopen::Cell<std::int32_t> position_offset{at<std::int32_t>(0x60B0)};
  canopen::Cell<std::int32_t> velocity_offset{at<std::int32_t>(0x60B1)};
  canopen::Cell<std::int16_t> torque_offset{at<std::int16_t>(0x60B2)};
  canopen::Cell<std::int32_t> interpolation_set_point{at<std::int32_t>(0x60C1, 1)};
  canopen::Cell<std::uint8_t> interpolation_time{at<std::uint8_t>(0x60C2, 1)};
  canopen::Cell<std::int8_t> interpolation_time_index{at<std::int8_t>(0x60C2, 2)};

  // Probes.
  canopen::Cell<std::uint16_t> probe_function{at<std::uint16_t>(0x60B8)};
  canopen::Cell<std::uint16_t> probe_status{at<std::uint16_t>(0x60B9)};
  canopen::Cell<std::int32_t> probe_1_positive{at<std::int32_t>(0x60BA)};
  canopen::Cell<std::int32_t> probe_1_negative{at<std::int32_t>(0x60BB)};
  canopen::Cell<std::int32_t> probe_2_positive{at<std::int32_t>(0x60BC)};
  canopen::Cell<std::int32_t> probe_2_negative{at<std::int32_t>(0x60BD)};
  canopen::Cell<std::int16_t> probe_1_source{at<std::int16_t>(0x60D0, 1)};
  canopen::Cell<std::int16_t> probe_2_source{at<std::int16_t>(0x60D0, 2)};
  canopen::Cell<std::uint32_t> stamp_1_positive{at<std::uint32_t>(0x60D1)};
  canopen::Cell<std::uint32_t> stamp_1_negative{at<std::uint32_t>(0x60D2)};
  canopen::Cell<std::uint32_t> stamp_2_positive{at<std::uint32_t>(0x60D3)};
  canopen::Cell<std::uint32_t> stamp_2_negative{at<std::uint32_t>(0x60D4)};
  canopen::Cell<std::uint16_t> counter_1_positive{at<std::uint16_t>(0x60D5)};
  canopen::Cell<std::uint16_t> counter_1_negative{at<std::uint16_t>(0x60D6)};
  canopen::Cell<std::uint16_t> counter_2_positive{at<std::uint16_t>(0x60D7)};
  canopen::Cell<std::uint16_t> counter_2_negative{at<std::uint16_t>(0x60D8)};

  // Terminals.
  canopen::Cell<std::uint32_t> digital_inputs{at<std::uint32_t>(0x60FD)};
  canopen::Cell<std::uint32_t> physical_outputs{at<std::uint32_t>(0x60FE, 1)};
  canopen::Cell<std::uint32_t> output_mask{at<std::uint32_t>(0x60FE, 2)};
};

}  // namespace cia402
