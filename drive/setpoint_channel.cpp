#include "drive/setpoint_channel.hpp"

#include <algorithm>
#include <cmath>

namespace drive {

void SetpointChannel::configure(const AxisParameters& p, const FixedSetpoints& fixed, bool extended) noexcept {
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
  fixed_ = fixed;
  maximum_ = std::min(p.maximum_speed, p.motor_maximum_speed);
  minimum_ = extended ? p.minimum_speed : 0.0;
  positive_ = p.speed_limit_positive;
  negative_ = p.speed_limit_negative;
  jog_ = {p.jog_speed_1, p.jog_speed_2};
  limit({});
}

void SetpointChannel::limit(const AxisInputs& inputs) noexcept {
  const double forward = std::isinf(inputs.forward_limit) ? positive_ : inputs.forward_limit;
  const double backward = std::isinf(inputs.backward_limit) ? negative_ : inputs.backward_limit;
  forward_ = std::clamp(forward, 0.0, maximum_);
  backward_ = std::clamp(backward, -maximum_, 0.0);
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

void SetpointChannel::follow_zero() noexcept {
  target_ = 0.0;
  moves_ = true;
}

void SetpointChannel::choose(const AxisInputs& inputs, bool jogs) noexcept {
  const std::array selection{inputs.fixed_setpoint_bit_0, inputs.fixed_setpoint_bit_1, inputs.fixed_setpoint_bit_2,
                             inputs.fixed_setpoint_bit_3};
  std::size_t number = 0;
  for (std::size_t bit = 0; bit < selection.size(); ++bit) number |= std::size_t{selection[bit]} << bit;
  fixed_setpoint_ = fixed_[number];
  sum_ = jogs ? jog_setpoint(inputs) : inputs.main_setpoint + inputs.supplementary_setpoint;
  directed_ = inputs.invert_setpoint ? -sum_ : sum_;
  if (inputs.inhibit_negative) directed_ = std::max(directed_, 0.0);
  if (inputs.inhibit_positive) directed_ = std::min(directed_, 0.0);
}

void SetpointChannel::follow(const AxisInputs& inputs) noexcept {
  target_ = inputs.enable_setpoint ? limited(directed_) : 0.0;
  behind_ = inputs.speed_setpoint_1 + inputs.speed_setpoint_2;
  lead_ramp(inputs);
}

/// p1140 = 0 holds the output at zero, p1143 = 1 at p1144, p1141 = 0 where it is; p1122 = 1 leaves no ramp.
void SetpointChannel::lead_ramp(const AxisInputs& inputs) noexcept {
  ramp_ = inputs.bypass_ramp ? Ramp::TorqueLimit : Ramp::Setpoint;
  const bool held = !inputs.enable_ramp || inputs.set_ramp;
  moves_ = inputs.continue_ramp && !held;
  if (held) ramp_generator_.start(inputs.enable_ramp ? limited(inputs.ramp_setting) : 0.0);
}

/// One of the two; both at once are none.
double SetpointChannel::jog_setpoint(const AxisInputs& inputs) const noexcept {
  if (inputs.jog_1 == inputs.jog_2) return 0.0;
  return jog_[inputs.jog_1 ? 0 : 1];
}

double SetpointChannel::limited(double setpoint) const noexcept {
  const bool slow = std::abs(setpoint) < minimum_;
  return std::clamp(slow ? std::copysign(minimum_, setpoint) : setpoint, backward_, forward_);
}

}  // namespace drive
