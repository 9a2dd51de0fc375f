#include "drive/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drive/statusword.hpp"
#include "motor/dc_link.hpp"

namespace drive {

Axis::Axis(const AxisConfiguration& configuration, std::uint8_t module, std::uint8_t node_id,
           const motor::SupplyData& supply, bool has_infeed)
    : DriveObject{{.kind = configuration.kind,
                   .module = module,
                   .node_id = node_id,
                   .axis = configuration,
                   .supply = supply,
                   .has_infeed = has_infeed}},
      parameters_{commissioned_parameters(configuration)},
      modules_{function_module::of_new(configuration)},
      train_{configuration.machine, motor::real_machine(configuration.machine, configuration.deviation),
             configuration.load, configuration.inverter},
      counts_to_speed_{2.0 * std::numbers::pi / motor::increments_per_revolution(configuration.machine)},
      dc_voltage_{motor::DcLink{supply}.voltage()} {
  restore_parameters();
}

void Axis::perform(Action action) noexcept {
  switch (action) {
    case Action::None:
      break;
    case Action::EnablePulses:
      channel_.start(train_.signals().measured_speed);
      if (!jogging_) identification_.prepare(false);
      break;
    case Action::InhibitPulses:
      channel_.start(0.0);
      break;
    case Action::FollowSetpoint:
      if (!jogging_) identification_.prepare(true);
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
  channel_.brake(ramp, train_.signals().measured_speed);
}

void Axis::refresh_status() noexcept {
  const bool pulses = pulses_enabled_in(state_);
  actual_.state = state_;
  actual_.pulses_enabled = pulses;
  actual_.speed_demand = channel_.total();
  actual_.mode = mode_.display(parameters_.control_mode);
  actual_.statusword =
      statusword(state_, {.no_off2 = !inputs_.has_off2(),
                          .no_off3 = !inputs_.has_off3(),
                          .fault = !messages().faults().empty(),
                          .alarm = !messages().alarms().empty(),
                          .target_reached = target_reached_,
                          .torque_limit_reached = pulses && train_.signals().torque_limit_reached,
                          .speed_zero = std::abs(actual_.speed) < parameters_.zero_speed_threshold,
                          .free_bit_8 = feedback_.status_bit_8,
                          .free_bit_14 = feedback_.status_bit_14,
                          .free_bit_15 = feedback_.status_bit_15});
}

bool Axis::is_quiescent() const noexcept {
  return settled_ && !pulses_enabled_in(state_) && train_.rests() && !causes_.any_present() && !waits_for_power();
}

bool Axis::has_new_command() const noexcept {
  return wired_.controlword != process_data().whole_controlword ||
         wired_.requested_mode != process_data().requested_mode;
}

void Axis::power_off() noexcept {
  DriveObject::power_off();
  if (identification_.leads()) stop_measurement();
  identification_.reset();
  state_ = State::SwitchOnDisabled;
  perform(Action::InhibitPulses);
  wired_ = wired_before_ = inputs_ = {};
  on_withheld_ = false;
  refresh_status();
  settled_ = false;
}

void Axis::on_messages_changed() noexcept {
  refresh_status();
  settled_ = false;
}

void Axis::set_load_torque(double torque, motor::LoadTorqueType type) noexcept {
  train_.set_load_torque(torque, type);
  settled_ = false;
}

void Axis::fail_encoder(motor::EncoderDefect defect) noexcept {
  train_.inject(defect);
  settled_ = false;
}

void Axis::set_function_modules(function_module::Set wanted) noexcept {
  modules_ = (wanted & function_module::possible(kind())) | function_module::always(kind());
  apply_parameters();
}

bool Axis::provides(const ParameterRow& row) const noexcept {
  return (modules_ & row.modules) == row.modules;
}

void Axis::inhibit(bool inhibited) noexcept {
  inhibited_ = inhibited;
  settled_ = false;
}

}  // namespace drive
