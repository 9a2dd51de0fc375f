// What leads an axis in a cycle: its inputs, the mode of operation, the setpoint channel and the torque setpoint.
#include <algorithm>
#include <array>
#include <cmath>

#include "drive/axis.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kTorqueControlImpossible = 7430;
constexpr std::uint16_t kControlMode = 1300;
constexpr std::uint16_t kFirstFixedSetpoint = 1001;

// Bits of the controlword in velocity mode (CiA 402, "vl").
constexpr std::uint16_t kEnableRamp = 0x0010;
constexpr std::uint16_t kUnlockRamp = 0x0020;
constexpr std::uint16_t kReferenceRamp = 0x0040;

/// The ramp of a halt by p8791; 0 takes the pulses off instead.
constexpr std::array kHaltRamps{Ramp::Setpoint, Ramp::Off1, Ramp::Off3, Ramp::TorqueLimit};

/// A servo without extended setpoint channel has none of its inputs, jog and ramp-function generator included.
void leave_channel_out(AxisInputs& inputs) noexcept {
  constexpr AxisInputs kUnwired{};
  for (const auto bit :
       {&AxisInputs::jog_1, &AxisInputs::jog_2, &AxisInputs::fixed_setpoint_bit_0,
        &AxisInputs::fixed_setpoint_bit_1, &AxisInputs::fixed_setpoint_bit_2, &AxisInputs::fixed_setpoint_bit_3,
        &AxisInputs::inhibit_negative, &AxisInputs::inhibit_positive, &AxisInputs::invert_setpoint,
        &AxisInputs::enable_ramp, &AxisInputs::continue_ramp, &AxisInputs::enable_setpoint, &AxisInputs::set_ramp})
    inputs.*bit = kUnwired.*bit;
  for (const auto value :
       {&AxisInputs::main_setpoint, &AxisInputs::supplementary_setpoint, &AxisInputs::ramp_setting})
    inputs.*value = kUnwired.*value;
  inputs.bypass_ramp = true;
}

}  // namespace

void Axis::take_inputs() noexcept {
  inputs_ = wired_;
  on_withheld_ = on_withheld_ && wired_.on && !wired_.has_off2() && !wired_.has_off3();
  inputs_.on &= !on_withheld_;
  const bool requested = mode_.on_process_data(wired_.requested_mode, parameters_.control_mode);
  const bool changed_over = mode_.on_changeover(wired_.torque_control, parameters_.control_mode);
  if (!(requested && changed_over) && pulses_enabled_in(state_))
    static_cast<void>(raise(kTorqueControlImpossible));
  if (mode_.velocity_mode(parameters_.control_mode)) {
    inputs_.enable_ramp &= (wired_.controlword & kEnableRamp) != 0;
    inputs_.continue_ramp &= (wired_.controlword & kUnlockRamp) != 0;
    inputs_.enable_setpoint &= (wired_.controlword & kReferenceRamp) != 0;
  }
  if (!has_setpoint_channel()) leave_channel_out(inputs_);
}

void Axis::request_mode(std::int8_t code) noexcept {
  const auto wanted = control_mode_of(code, has_encoder());
  const bool possible = wanted && write(kControlMode, *wanted).has_value();
  mode_.on_request(code, parameters_.control_mode, possible);
  refresh_status();
  settled_ = false;
}

FixedSetpoints Axis::fixed_setpoints() const noexcept {
  FixedSetpoints setpoints{};
  for (std::size_t i = 1; i < setpoints.size(); ++i)
    setpoints[i] = read(static_cast<std::uint16_t>(kFirstFixedSetpoint + i - 1)).value_or(0.0) * kRpm;
  return setpoints;
}

void Axis::lead_setpoint() noexcept {
  channel_.limit(inputs_);
  channel_.choose(inputs_, jogging_);
  if (state_ != State::OperationEnabled || identification_.leads()) return channel_.follow_zero();
  if (halt_requested()) {
    channel_.follow_zero();
    return brake_on(kHaltRamps[static_cast<std::size_t>(parameters_.halt_option)]);
  }
  channel_.follow(inputs_);
}

/// Torque limits, and in torque control the setpoint. A disabled speed controller (p0856 = 0) gives no torque. Any
/// braking is done by the speed controller, which goes on with the torque that there was.
void Axis::lead_torque() noexcept {
  const AxisParameters& p = parameters_;
  const auto limit = [](double wired, double parameter) { return std::isinf(wired) ? parameter : wired; };
  torque_limits_ = {limit(inputs_.upper_torque_limit, p.upper_torque_limit),
                    limit(inputs_.lower_torque_limit, p.lower_torque_limit)};
  motor::DriveCommand& command = cycle_.command;
  command.limits = torque_limits_;
  const double additional = inputs_.supplementary_torque_1 + inputs_.supplementary_torque_2;
  command.additional_torque = inputs_.enable_speed_controller ? additional : 0.0;
  const bool leads =
      mode_.torque_control(p.control_mode) && state_ == State::OperationEnabled && !identification_.leads();
  command.torque_control = leads || !inputs_.enable_speed_controller;
  const bool stopping = halt_requested();
  torque_setpoint_ = !leads ? 0.0 : stopping ? halted_torque() : inputs_.torque_setpoint;
  if (leads || torque_led_) channel_.track(train_.signals().measured_speed);
  torque_led_ = leads;
  if (leads && stopping) command.additional_torque = 0.0;
  command.torque_setpoint = inputs_.enable_speed_controller ? torque_setpoint_ : 0.0;
}

/// A halt in torque control takes the setpoint to zero, the rated torque in the time of the ramp or at once.
double Axis::halted_torque() noexcept {
  constexpr std::int32_t kOff1 = 1, kOff3 = 2;
  const AxisParameters& p = parameters_;
  const double time = p.halt_option == kOff1   ? p.ramp_down_time
                      : p.halt_option == kOff3 ? p.off3_ramp_down_time
                                               : 0.0;
  const double step = time > 0.0 ? p.rated_torque / time * cycle_.duration : std::abs(torque_setpoint_);
  return torque_setpoint_ - std::clamp(torque_setpoint_, -step, step);
}

}  // namespace drive
