// The status and control words that parameters show of an axis.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "drive/axis/axis.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::axis_value {
namespace {

constexpr std::uint16_t kBlocked = 7900;

struct Bit {
  unsigned number;
  bool on;
};

double word(std::span<const Bit> bits) noexcept {
  std::uint32_t value = 0;
  for (const Bit& bit : bits) value |= static_cast<std::uint32_t>(bit.on) << bit.number;
  return value;
}

bool is(const Axis& axis, State state) noexcept {
  return axis.actual().state == state;
}

const SequenceControl& sequence_of(const Axis& axis) noexcept {
  return axis.block<SequenceControl>();
}
const SetpointChannel::Inputs& channel_inputs_of(const Axis& axis) noexcept {
  return axis.block<SetpointChannel>().effective();
}
bool enables_speed_controller(const Axis& axis) noexcept {
  return axis.block<SpeedControl>().inputs.enable;
}

bool has_ended(const SetpointChannel& channel) noexcept {
  return !(std::abs(channel.output() - channel.input()) > 0.0);
}
double share_of_torque_limit(const Axis& axis) noexcept {
  return torque_utilisation(axis, 0) * row_of(Unit::Percent).si;
}

/// What r0002 shows in a state while something holds.
struct Display {
  State state;
  bool (*holds)(const Axis& axis);
  double code;
};
bool always(const Axis&) noexcept {
  return true;
}
constexpr std::array kDisplays{
    Display{State::OperationEnabled, always, 0.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return !channel_inputs_of(axis).enable_setpoint; },
            10.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return !enables_speed_controller(axis); }, 11.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return !channel_inputs_of(axis).continue_ramp; },
            12.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return !channel_inputs_of(axis).enable_ramp; }, 13.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return axis.block<Identification>().leads(); }, 14.0},
    Display{State::OperationEnabled, [](const Axis& axis) { return axis.brake_opens(); }, 15.0},
    Display{State::Off1Braking, always, 16.0},
    Display{State::QuickStopActive, always, 17.0},
    Display{State::FaultReactionActive, always, 18.0},
    Display{State::Stop2Active, always, 18.0},
    Display{State::SwitchedOn, always, 21.0},
    Display{State::SwitchedOn, [](const Axis& axis) { return axis.waits_for_power(); }, 23.0},
    Display{State::ReadyToSwitchOn, always, 31.0},
    Display{State::SwitchOnDisabled, always, 41.0},  // ON is still set
    Display{State::SwitchOnDisabled, [](const Axis& axis) { return sequence_of(axis).inputs.has_off2(); }, 42.0},
    Display{State::SwitchOnDisabled, [](const Axis& axis) { return sequence_of(axis).inputs.has_off3(); }, 43.0},
    Display{State::Fault, always, 45.0},
    Display{State::SwitchOnDisabled, [](const Axis& axis) { return sequence_of(axis).is_inhibited(); }, 46.0},
    Display{State::NotReadyToSwitchOn, always, 70.0},
};
static_assert(std::ranges::is_sorted(kDisplays, {}, &Display::code), "of several causes the highest is shown");

/// Whether the axis is in fault because of one with a reaction of @p reactions.
bool stopped_by(const Axis& axis, Reactions reactions) noexcept {
  return (axis.active_reactions() & reactions) != 0;
}

/// OFF2 from within: commissioning, or a fault that is no OFF1 and no OFF3.
bool has_internal_off2(const Axis& axis) noexcept {
  constexpr auto kOthers =
      static_cast<Reactions>(bit_of(Reaction::Off1) | bit_of(Reaction::Off3) | bit_of(Reaction::Stop2));
  constexpr auto kCoasting =
      static_cast<Reactions>(bit_of(Reaction::Off2) | bit_of(Reaction::Encoder) | bit_of(Reaction::ShortCircuit));
  const bool not_listed = is(axis, State::Fault) && !stopped_by(axis, kOthers);
  return sequence_of(axis).is_inhibited() || stopped_by(axis, kCoasting) || not_listed;
}

}  // namespace

double operating_display(const Axis& axis, std::size_t) noexcept {
  double code = 0.0;
  for (const Display& row : kDisplays)
    if (is(axis, row.state) && row.holds(axis)) code = row.code;
  return code;
}

double statusword(const Axis& axis, std::size_t) noexcept {
  return axis.actual().statusword;
}

double controlword(const Axis& axis, std::size_t) noexcept {
  return axis.controlword();
}

double missing_enables(const Axis& axis, std::size_t) noexcept {
  const SequenceControl& sequence = sequence_of(axis);
  const SequenceControl::Inputs& inputs = sequence.effective();
  const SetpointChannel::Inputs& channel = channel_inputs_of(axis);
  const bool pulses = axis.actual().pulses_enabled;
  const auto off3 = static_cast<Reactions>(bit_of(Reaction::Off3) | bit_of(Reaction::Stop2));
  return word(
      std::array{Bit{0, !sequence.is_on() && !axis.jogs()}, Bit{1, inputs.has_off2()}, Bit{2, inputs.has_off3()},
                 Bit{3, !inputs.enable_operation}, Bit{9, !inputs.infeed_operates}, Bit{10, !channel.enable_ramp},
                 Bit{11, !channel.continue_ramp}, Bit{12, !channel.enable_setpoint},
                 Bit{16, stopped_by(axis, bit_of(Reaction::Off1))}, Bit{17, has_internal_off2(axis)},
                 Bit{18, stopped_by(axis, off3)}, Bit{19, !pulses}, Bit{21, !axis.block<PowerUnit>().has_link()},
                 Bit{30, !pulses || !enables_speed_controller(axis)}, Bit{31, axis.jogs()}});
}

double control_status(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{0, !is(axis, State::NotReadyToSwitchOn)}, Bit{2, axis.actual().pulses_enabled},
                         Bit{13, axis.is_at_torque_limit()}});
}

double sequence_control(const Axis& axis, std::size_t) noexcept {
  const SequenceControl::Inputs& inputs = sequence_of(axis).effective();
  const SetpointChannel::Inputs& channel = channel_inputs_of(axis);
  const Jog::Inputs& jog = axis.block<Jog>().inputs;
  return word(std::array{Bit{0, sequence_of(axis).is_on()}, Bit{1, !inputs.has_off2()}, Bit{2, !inputs.has_off3()},
                         Bit{3, inputs.enable_operation}, Bit{4, channel.enable_ramp},
                         Bit{5, channel.continue_ramp}, Bit{6, channel.enable_setpoint}, Bit{8, jog.jog_1},
                         Bit{9, jog.jog_2}, Bit{10, inputs.control_by_plc}});
}

double sequence_status(const Axis& axis, std::size_t) noexcept {
  constexpr unsigned kOfTheStatusword = 0x0277;  // bits 0..2, 4..6 and 9 are the same
  const bool inhibited = is(axis, State::Fault);
  const bool pulses = axis.actual().pulses_enabled;
  const auto own = static_cast<std::uint32_t>(word(std::array{
      Bit{3, axis.jogs()}, Bit{6, inhibited}, Bit{7, !inhibited}, Bit{8, pulses && enables_speed_controller(axis)},
      Bit{11, pulses}, Bit{12, axis.brake_is_open()}}));
  return (axis.actual().statusword & kOfTheStatusword) | own;
}

double speed_controller_control(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{8, axis.block<TorqueSetpoint>().inputs.travels_to_fixed_stop},
                         Bit{12, axis.block<SpeedControl>().inputs.torque_control}});
}

double speed_controller_status(const Axis& axis, std::size_t) noexcept {
  constexpr std::int32_t kFirstVectorMode = 20;
  constexpr std::int32_t kSpeedWithoutEncoder = 20;
  constexpr std::int32_t kTorqueWithoutEncoder = 22;
  const auto& control = axis.block<SpeedControl>();
  const std::int32_t mode = control.settings.control_mode;
  const bool pulses = axis.actual().pulses_enabled;
  return word(std::array{Bit{0, pulses && mode < kFirstVectorMode},
                         Bit{1, pulses && (mode == kSpeedWithoutEncoder || mode == kTorqueWithoutEncoder)},
                         Bit{2, pulses && control.torque_control()}, Bit{3, pulses && !control.torque_control()},
                         Bit{7, axis.is_at_torque_limit()}});
}

double message_control(const Axis& axis, std::size_t) noexcept {
  const ExternalMessages::Inputs& inputs = axis.block<ExternalMessages>().inputs;
  return word(std::array{Bit{7, inputs.acknowledge_1 || inputs.acknowledge_2 || inputs.acknowledge_3},
                         Bit{10, inputs.no_external_alarm_1}, Bit{13, inputs.no_external_fault_1},
                         Bit{14, inputs.no_external_fault_2}, Bit{15, inputs.no_external_fault_3}});
}

double speed_status(const Axis& axis, std::size_t) noexcept {
  const double speed = std::abs(axis.actual().speed);
  const double threshold = axis.block<SpeedMessages>().settings.threshold_2;
  const auto& channel = axis.block<SetpointChannel>();
  const auto& power_unit = axis.block<PowerUnit>();
  const bool link_above = power_unit.dc_voltage() > power_unit.settings.link_threshold;
  return word(std::array{Bit{1, speed > sequence_of(axis).settings.standstill_threshold},
                         Bit{2, speed > channel.settings.minimum_speed},
                         Bit{3, current(axis, 0) >= power_unit.settings.current_threshold},
                         Bit{4, speed > threshold}, Bit{5, speed <= threshold},
                         Bit{6, speed >= std::abs(channel.input())}, Bit{7, !link_above}, Bit{8, link_above},
                         Bit{9, has_ended(channel)}});
}

double monitoring_1(const Axis& axis, std::size_t) noexcept {
  const auto& speed = axis.block<SpeedMessages>();
  const bool standstill = std::abs(axis.actual().speed) < sequence_of(axis).settings.standstill_threshold;
  return word(std::array{Bit{1, std::abs(axis.actual().speed) <= speed.settings.threshold_2},
                         Bit{3, speed.turns_forward()}, Bit{5, standstill}, Bit{6, speed.has_overspeed()},
                         Bit{7, speed.target_reached()}});
}

double monitoring_2(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{6, axis.has_cause(kBlocked)}});
}

double monitoring_3(const Axis& axis, std::size_t) noexcept {
  const auto& speed = axis.block<SpeedMessages>();
  return word(std::array{Bit{0, speed.is_zero(axis.actual().speed)}, Bit{1, speed.reaches_threshold_1()},
                         Bit{4, speed.target_kept()}, Bit{5, has_ended(axis.block<SetpointChannel>())},
                         Bit{11, share_of_torque_limit(axis) < axis.block<TorqueSetpoint>().settings.threshold}});
}

}  // namespace drive::axis_value
