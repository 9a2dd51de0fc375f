#include "drive/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drive/statusword.hpp"
#include "motor/dc_link.hpp"

namespace drive {

Axis::Axis(const AxisConfiguration& configuration, std::uint8_t module, std::uint8_t node_id,
           const motor::SupplyData& supply)
    : DriveObject{{.kind = configuration.kind,
                   .module = module,
                   .node_id = node_id,
                   .axis = configuration,
                   .supply = supply}},
      parameters_{commissioned_parameters(configuration)},
      train_{configuration.machine, configuration.load, configuration.inverter},
      counts_to_speed_{2.0 * std::numbers::pi / motor::increments_per_revolution(configuration.machine)},
      dc_voltage_{motor::DcLink{supply}.voltage()} {
  restore_parameters();
}

void Axis::perform(Action action) noexcept {
  switch (action) {
    case Action::None:
      break;
    case Action::EnablePulses:
      ramp_generator_.start(train_.signals().measured_speed);
      ramp_ = Ramp::Setpoint;
      break;
    case Action::InhibitPulses:
      ramp_generator_.start(0.0);
      ramp_ = Ramp::Setpoint;
      break;
    case Action::FollowSetpoint:
      ramp_ = Ramp::Setpoint;
      break;
    case Action::BrakeOnOff1:
      brake_on(Ramp::Off1);
      break;
    case Action::BrakeOnOff3:
      brake_on(Ramp::Off3);
      break;
  }
}

void Axis::brake_on(Ramp ramp) noexcept {
  if (ramp_ == ramp) return;
  ramp_ = ramp;
  // A motor that has not yet reached its setpoint brakes from where it is instead of speeding up first.
  const double speed = train_.signals().measured_speed;
  const double setpoint = ramp_generator_.output();
  const bool ahead = setpoint * speed < 0.0 || std::abs(setpoint) > std::abs(speed);
  if (ahead) ramp_generator_.start(speed);
}

void Axis::select_ramp() noexcept {
  static constexpr std::array kHaltRamps{Ramp::Setpoint, Ramp::Off1, Ramp::Off3, Ramp::TorqueLimit};
  target_ = 0.0;
  if (state_ != State::OperationEnabled) return;
  if (halt_requested()) {
    brake_on(kHaltRamps[static_cast<std::size_t>(parameters_.halt_option)]);
    return;
  }
  ramp_ = Ramp::Setpoint;
  target_ = std::clamp(inputs_.main_setpoint, backward_limit_, forward_limit_);
}

void Axis::refresh_status() noexcept {
  const bool pulses = pulses_enabled_in(state_);
  actual_.state = state_;
  actual_.pulses_enabled = pulses;
  actual_.speed_demand = ramp_generator_.output();
  actual_.statusword =
      statusword(state_, {.no_off2 = inputs_.no_off2 && inputs_.no_off2_second,
                          .no_off3 = inputs_.no_off3 && inputs_.no_off3_second,
                          .fault = !messages().faults().empty(),
                          .alarm = !messages().alarms().empty(),
                          .target_reached = target_reached_,
                          .torque_limit_reached = pulses && train_.signals().torque_limit_reached,
                          .speed_zero = std::abs(actual_.speed) < parameters_.zero_speed_threshold});
}

bool Axis::is_quiescent() const noexcept {
  return settled_ && !pulses_enabled_in(state_) && train_.rests() && !causes_.any_present() && !waits_for_power();
}

void Axis::power_off() noexcept {
  DriveObject::power_off();
  state_ = State::SwitchOnDisabled;
  perform(Action::InhibitPulses);
  inputs_ = {};
  refresh_status();
  settled_ = false;
}

void Axis::on_messages_changed() noexcept {
  refresh_status();
  settled_ = false;
}

void Axis::set_load_torque(double torque) noexcept {
  train_.set_load_torque(torque);
  settled_ = false;
}

void Axis::fail_encoder(motor::EncoderDefect defect) noexcept {
  train_.inject(defect);
  settled_ = false;
}

void Axis::inhibit(bool inhibited) noexcept {
  inhibited_ = inhibited;
  settled_ = false;
}

}  // namespace drive
