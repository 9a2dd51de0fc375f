#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "drive/axis/axis.hpp"

namespace drive {

/// What the BICO inputs of the blocks of an axis bring in one process-data cycle, by what they are for; quantities
/// in SI units. An input that is wired to nothing has the value it has here.
struct AxisInputs {
  static constexpr double kAsParameter = std::numeric_limits<double>::infinity();

  /// 6040h as the master sent it: bit 8 is the halt, bits 4 to 6 act in velocity mode.
  std::uint16_t controlword = 0;
  /// 6060h while it is mapped in an RPDO.
  std::optional<std::int8_t> requested_mode{};

  // Sequence control.
  bool on = false;                      ///< p0840, 0 = OFF1
  bool no_off2 = true;                  ///< p0844 and
  bool no_off2_second = true;           ///< p0845, 0 = OFF2
  bool no_off3 = true;                  ///< p0848 and
  bool no_off3_second = true;           ///< p0849, 0 = OFF3
  bool enable_operation = true;         ///< p0852
  bool control_by_plc = true;           ///< p0854
  bool enable_speed_controller = true;  ///< p0856
  bool infeed_operates = true;          ///< p0864
  bool jog_1 = false;                   ///< p1055
  bool jog_2 = false;                   ///< p1056

  // Setpoint channel.
  bool fixed_setpoint_bit_0 = false;     ///< p1020
  bool fixed_setpoint_bit_1 = false;     ///< p1021
  bool fixed_setpoint_bit_2 = false;     ///< p1022
  bool fixed_setpoint_bit_3 = false;     ///< p1023
  bool inhibit_negative = false;         ///< p1110
  bool inhibit_positive = false;         ///< p1111
  bool invert_setpoint = false;          ///< p1113
  bool bypass_ramp = false;              ///< p1122
  bool enable_ramp = true;               ///< p1140
  bool continue_ramp = true;             ///< p1141
  bool enable_setpoint = true;           ///< p1142
  bool set_ramp = false;                 ///< p1143
  double main_setpoint = 0.0;            ///< p1070 (rad/s)
  double supplementary_setpoint = 0.0;   ///< p1075 (rad/s)
  double forward_limit = kAsParameter;   ///< p1085 (rad/s), p1083 if it is infinite
  double backward_limit = kAsParameter;  ///< p1088 (rad/s), p1086 if it is infinite
  double ramp_setting = 0.0;             ///< p1144 (rad/s)
  double speed_setpoint_1 = 0.0;         ///< p1155, behind the ramp (rad/s)
  double speed_setpoint_2 = 0.0;         ///< p1160, behind the ramp (rad/s)

  // Torque.
  bool torque_control = false;               ///< p1501
  double torque_setpoint = 0.0;              ///< p1503 (N·m)
  double supplementary_torque_1 = 0.0;       ///< p1511 (N·m)
  double supplementary_torque_2 = 0.0;       ///< p1513 (N·m)
  double upper_torque_limit = kAsParameter;  ///< p1522 (N·m), p1520 if it is infinite
  double lower_torque_limit = kAsParameter;  ///< p1523 (N·m), p1521 if it is infinite

  // Messages.
  bool acknowledge_1 = false;       ///< p2103, edge
  bool acknowledge_2 = false;       ///< p2104, edge
  bool acknowledge_3 = false;       ///< p2105, edge
  bool no_external_fault_1 = true;  ///< p2106
  bool no_external_fault_2 = true;  ///< p2107
  bool no_external_fault_3 = true;  ///< p2108
  bool no_external_alarm_1 = true;  ///< p2112
};

namespace axis_inputs {

template <class Block>
auto& block(auto& axis) {
  return axis.template block<Block>();
}

/// Calls @p visit with every member of AxisInputs and the input of a block of @p axis that it stands for.
void for_each(auto& axis, const auto& visit) {
  visit(&AxisInputs::on, block<SequenceControl>(axis).inputs.on);
  visit(&AxisInputs::no_off2, block<SequenceControl>(axis).inputs.no_off2);
  visit(&AxisInputs::no_off2_second, block<SequenceControl>(axis).inputs.no_off2_second);
  visit(&AxisInputs::no_off3, block<SequenceControl>(axis).inputs.no_off3);
  visit(&AxisInputs::no_off3_second, block<SequenceControl>(axis).inputs.no_off3_second);
  visit(&AxisInputs::enable_operation, block<SequenceControl>(axis).inputs.enable_operation);
  visit(&AxisInputs::control_by_plc, block<SequenceControl>(axis).inputs.control_by_plc);
  visit(&AxisInputs::enable_speed_controller, block<SpeedControl>(axis).inputs.enable);
  visit(&AxisInputs::infeed_operates, block<SequenceControl>(axis).inputs.infeed_operates);
  visit(&AxisInputs::jog_1, block<Jog>(axis).inputs.jog_1);
  visit(&AxisInputs::jog_2, block<Jog>(axis).inputs.jog_2);
  visit(&AxisInputs::fixed_setpoint_bit_0, block<SetpointChannel>(axis).inputs.fixed_setpoint_bit_0);
  visit(&AxisInputs::fixed_setpoint_bit_1, block<SetpointChannel>(axis).inputs.fixed_setpoint_bit_1);
  visit(&AxisInputs::fixed_setpoint_bit_2, block<SetpointChannel>(axis).inputs.fixed_setpoint_bit_2);
  visit(&AxisInputs::fixed_setpoint_bit_3, block<SetpointChannel>(axis).inputs.fixed_setpoint_bit_3);
  visit(&AxisInputs::inhibit_negative, block<SetpointChannel>(axis).inputs.inhibit_negative);
  visit(&AxisInputs::inhibit_positive, block<SetpointChannel>(axis).inputs.inhibit_positive);
  visit(&AxisInputs::invert_setpoint, block<SetpointChannel>(axis).inputs.invert_setpoint);
  visit(&AxisInputs::bypass_ramp, block<SetpointChannel>(axis).inputs.bypass_ramp);
  visit(&AxisInputs::enable_ramp, block<SetpointChannel>(axis).inputs.enable_ramp);
  visit(&AxisInputs::continue_ramp, block<SetpointChannel>(axis).inputs.continue_ramp);
  visit(&AxisInputs::enable_setpoint, block<SetpointChannel>(axis).inputs.enable_setpoint);
  visit(&AxisInputs::set_ramp, block<SetpointChannel>(axis).inputs.set_ramp);
  visit(&AxisInputs::main_setpoint, block<SetpointChannel>(axis).inputs.main_setpoint);
  visit(&AxisInputs::supplementary_setpoint, block<SetpointChannel>(axis).inputs.supplementary_setpoint);
  visit(&AxisInputs::forward_limit, block<SetpointChannel>(axis).inputs.forward_limit);
  visit(&AxisInputs::backward_limit, block<SetpointChannel>(axis).inputs.backward_limit);
  visit(&AxisInputs::ramp_setting, block<SetpointChannel>(axis).inputs.ramp_setting);
  visit(&AxisInputs::speed_setpoint_1, block<SetpointChannel>(axis).inputs.speed_setpoint_1);
  visit(&AxisInputs::speed_setpoint_2, block<SetpointChannel>(axis).inputs.speed_setpoint_2);
  visit(&AxisInputs::torque_control, block<SpeedControl>(axis).inputs.torque_control);
  visit(&AxisInputs::torque_setpoint, block<TorqueSetpoint>(axis).inputs.setpoint);
  visit(&AxisInputs::supplementary_torque_1, block<TorqueSetpoint>(axis).inputs.supplementary_1);
  visit(&AxisInputs::supplementary_torque_2, block<TorqueSetpoint>(axis).inputs.supplementary_2);
  visit(&AxisInputs::upper_torque_limit, block<TorqueSetpoint>(axis).inputs.upper_limit);
  visit(&AxisInputs::lower_torque_limit, block<TorqueSetpoint>(axis).inputs.lower_limit);
  visit(&AxisInputs::acknowledge_1, block<ExternalMessages>(axis).inputs.acknowledge_1);
  visit(&AxisInputs::acknowledge_2, block<ExternalMessages>(axis).inputs.acknowledge_2);
  visit(&AxisInputs::acknowledge_3, block<ExternalMessages>(axis).inputs.acknowledge_3);
  visit(&AxisInputs::no_external_fault_1, block<ExternalMessages>(axis).inputs.no_external_fault_1);
  visit(&AxisInputs::no_external_fault_2, block<ExternalMessages>(axis).inputs.no_external_fault_2);
  visit(&AxisInputs::no_external_fault_3, block<ExternalMessages>(axis).inputs.no_external_fault_3);
  visit(&AxisInputs::no_external_alarm_1, block<ExternalMessages>(axis).inputs.no_external_alarm_1);
}

}  // namespace axis_inputs

/// Puts @p inputs into the blocks of @p axis, as the interconnections would.
inline void bring(const AxisInputs& inputs, Axis& axis) {
  axis.command({.controlword = inputs.controlword});
  axis_inputs::for_each(axis, [&](auto member, auto& input) { input = inputs.*member; });
  axis.block<SpeedControl>().inputs.requested_mode = inputs.requested_mode;
}
/// A cycle of @p axis with @p inputs.
inline void cycle(Axis& axis, const AxisInputs& inputs, double duration) {
  bring(inputs, axis);
  axis.cycle(duration);
}
/// What the inputs of the blocks of @p axis hold.
inline AxisInputs inputs_of(const Axis& axis) {
  AxisInputs inputs{};
  axis_inputs::for_each(axis, [&](auto member, const auto& input) { inputs.*member = input; });
  return inputs;
}

}  // namespace drive
