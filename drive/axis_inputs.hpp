#pragma once

#include <cstdint>
#include <limits>
#include <optional>

namespace drive {

/// What the master sends in one process-data cycle to an axis that is wired as a new one.
struct Setpoints {
  std::uint16_t controlword = 0;
  double speed = 0.0;   ///< rad/s
  double torque = 0.0;  ///< N·m, leads in torque control

  friend bool operator==(const Setpoints&, const Setpoints&) = default;
};

/// What the BICO inputs of an axis bring in one process-data cycle; quantities in SI units. An input that is wired
/// to nothing has the value it has here.
struct AxisInputs {
  static constexpr double kAsParameter = std::numeric_limits<double>::infinity();

  /// 6040h as the master sent it: bit 8 is the halt, bits 4 to 6 act in velocity mode; everything else goes
  /// through the binectors.
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

  friend bool operator==(const AxisInputs&, const AxisInputs&) = default;

  /// Whether OFF2 is given, by either of its inputs.
  constexpr bool has_off2() const noexcept { return !(no_off2 && no_off2_second); }
  /// Whether OFF3 is given, by either of its inputs.
  constexpr bool has_off3() const noexcept { return !(no_off3 && no_off3_second); }
};

/// What the inputs of an axis that is wired as a new one bring of @p setpoints (p8790 = 1; p1070 and p1503 at
/// 60FFh and 6071h).
constexpr AxisInputs inputs_of(const Setpoints& setpoints) noexcept {
  const auto bit = [&](unsigned number) { return (setpoints.controlword >> number & 1U) != 0; };
  AxisInputs inputs{};
  inputs.controlword = setpoints.controlword;
  inputs.on = bit(0);
  inputs.no_off2 = bit(1);
  inputs.no_off3 = bit(2);
  inputs.enable_operation = bit(3);
  inputs.acknowledge_1 = bit(7);
  inputs.main_setpoint = setpoints.speed;
  inputs.torque_setpoint = setpoints.torque;
  return inputs;
}

/// Whether an acknowledge input has risen from @p before to @p now.
constexpr bool has_acknowledgement(const AxisInputs& before, const AxisInputs& now) noexcept {
  return (now.acknowledge_1 && !before.acknowledge_1) || (now.acknowledge_2 && !before.acknowledge_2) ||
         (now.acknowledge_3 && !before.acknowledge_3);
}

/// What acts on the messages and the statusword of an axis when a cycle is over.
struct AxisFeedback {
  double message_setpoint = AxisInputs::kAsParameter;  ///< p2151 (rad/s), r1119 if it is infinite
  bool status_bit_8 = false;                           ///< p8785
  bool status_bit_14 = false;                          ///< p8786
  bool status_bit_15 = false;                          ///< p8787
};

}  // namespace drive
