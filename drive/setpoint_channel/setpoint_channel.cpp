#include "drive/setpoint_channel/setpoint_channel.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

/// What a halt by p8791 does; 0 takes the pulses off instead.
struct HaltRow {
  Ramp ramp;
  double SetpointChannel::Settings::*time;
};
constexpr std::array kHalts{
    HaltRow{Ramp::Setpoint, nullptr}, HaltRow{Ramp::Off1, &SetpointChannel::Settings::ramp_down_time},
    HaltRow{Ramp::Off3, &SetpointChannel::Settings::off3_ramp_down_time}, HaltRow{Ramp::TorqueLimit, nullptr}};

}  // namespace

void SetpointChannel::configure(double motor_maximum_speed, bool extended) noexcept {
  const Settings& p = settings;
  const double off1 = ramp_slope(p.maximum_speed, p.ramp_down_time);
  const double off3 = ramp_slope(p.maximum_speed, p.off3_ramp_down_time);
  const bool rounded = extended && p.ramp_selection != 0;
  const auto ramp = [&](double up, double down, double initial, double final_time) {
    const auto type = static_cast<RoundingType>(p.rounding_type);
    return RampSlopes{up, down, rounded ? initial : 0.0, rounded ? final_time : 0.0, type};
  };
  slopes_ = {ramp(ramp_slope(p.maximum_speed, p.ramp_up_time), off1, p.initial_rounding, p.final_rounding),
             ramp(off1, off1, p.initial_rounding, p.final_rounding),
             ramp(off3, off3, p.off3_initial_rounding, p.off3_final_rounding), RampSlopes{}};
  maximum_ = std::min(p.maximum_speed, motor_maximum_speed);
  extended_ = extended;
  limit();
}

void SetpointChannel::limit() noexcept {
  const double forward = std::isinf(in_.forward_limit) ? settings.speed_limit_positive : in_.forward_limit;
  const double backward = std::isinf(in_.backward_limit) ? settings.speed_limit_negative : in_.backward_limit;
  forward_ = std::clamp(forward, 0.0, maximum_);
  backward_ = std::clamp(backward, -maximum_, 0.0);
}

void SetpointChannel::begin_cycle(bool velocity_mode, std::optional<double> panel) noexcept {
  in_ = inputs;
  panel_ = panel;
  if (velocity_mode) {
    in_.enable_ramp &= inputs.vl_enable_ramp;
    in_.continue_ramp &= inputs.vl_unlock_ramp;
    in_.enable_setpoint &= inputs.vl_reference_ramp;
  }
  if (!extended_) leave_module_out();
  if (panel_) follow_panel(*panel_);
}

/// Limits, inversion, inhibited directions and the times of the ramp stay.
void SetpointChannel::follow_panel(double speed) noexcept {
  in_.enable_ramp = in_.continue_ramp = in_.enable_setpoint = true;
  in_.set_ramp = false;
  in_.supplementary_setpoint = in_.speed_setpoint_2 = 0.0;
  in_.main_setpoint = extended_ ? speed : 0.0;
  in_.speed_setpoint_1 = extended_ ? 0.0 : speed;
}

/// Without extended setpoint channel there is no ramp-function generator, but limits and the
/// setpoints behind the ramp.
void SetpointChannel::leave_module_out() noexcept {
  in_ = {.bypass_ramp = true,
         .forward_limit = inputs.forward_limit,
         .backward_limit = inputs.backward_limit,
         .speed_setpoint_1 = inputs.speed_setpoint_1,
         .speed_setpoint_2 = inputs.speed_setpoint_2};
}

void SetpointChannel::start(double speed) noexcept {
  ramp_generator_.start(speed);
  ramp_ = Ramp::Setpoint;
  behind_ = 0.0;
  moves_ = true;
}

void SetpointChannel::brake(Ramp ramp, double speed) noexcept {
  moves_ = true;
  if (ramp_ == ramp && !(std::abs(behind_) > 0.0)) return;
  ramp_ = ramp;
  // A motor that has not yet reached its setpoint brakes from where it is instead of speeding up first.
  const double setpoint = total();
  const bool ahead = setpoint * speed < 0.0 || std::abs(setpoint) > std::abs(speed);
  if (ahead || std::abs(behind_) > 0.0) ramp_generator_.start(ahead ? speed : setpoint);
  behind_ = 0.0;
}

void SetpointChannel::halt(std::int32_t option, double speed) noexcept {
  follow_zero();
  brake(kHalts[static_cast<std::size_t>(option)].ramp, speed);
}

double SetpointChannel::halt_time(std::int32_t option) const noexcept {
  const auto time = kHalts[static_cast<std::size_t>(option)].time;
  return time != nullptr ? settings.*time : 0.0;
}

void SetpointChannel::follow_zero() noexcept {
  target_ = 0.0;
  moves_ = true;
}

void SetpointChannel::choose(std::optional<double> jog) noexcept {
  limit();
  const std::array selection{in_.fixed_setpoint_bit_0, in_.fixed_setpoint_bit_1, in_.fixed_setpoint_bit_2,
                             in_.fixed_setpoint_bit_3};
  std::size_t number = 0;
  for (std::size_t bit = 0; bit < selection.size(); ++bit) number |= std::size_t{selection[bit]} << bit;
  fixed_setpoint_ = settings.fixed[number];
  sum_ = jog ? *jog : in_.main_setpoint + in_.supplementary_setpoint;
  directed_ = in_.invert_setpoint ? -sum_ : sum_;
  if (in_.inhibit_negative) directed_ = std::max(directed_, 0.0);
  if (in_.inhibit_positive) directed_ = std::min(directed_, 0.0);
}

void SetpointChannel::follow() noexcept {
  target_ = in_.enable_setpoint ? limited(directed_) : 0.0;
  behind_ = in_.speed_setpoint_1 + in_.speed_setpoint_2;
  lead_ramp();
}

/// p1140 = 0 holds the output at zero, p1143 = 1 at p1144, p1141 = 0 where it is; p1122 = 1 leaves no ramp.
void SetpointChannel::lead_ramp() noexcept {
  ramp_ = in_.bypass_ramp ? Ramp::TorqueLimit : Ramp::Setpoint;
  const bool held = !in_.enable_ramp || in_.set_ramp;
  moves_ = in_.continue_ramp && !held;
  if (held) ramp_generator_.start(in_.enable_ramp ? limited(in_.ramp_setting) : 0.0);
}

double SetpointChannel::limited(double setpoint) const noexcept {
  const double minimum = extended_ ? settings.minimum_speed : 0.0;
  const bool slow = std::abs(setpoint) < minimum;
  return std::clamp(slow ? std::copysign(minimum, setpoint) : setpoint, backward_, forward_);
}

}  // namespace drive
