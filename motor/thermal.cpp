#include "motor/thermal.hpp"

namespace motor {
namespace {

/// Heat flow between the bodies per kelvin, over the heat capacity of one: the rates at which they follow (1/s).
struct Rates {
  double winding;  // winding towards frame
  double frame;    // frame towards winding
  double air;      // frame towards air
};

Rates rates_of(const ThermalData& data) noexcept {
  return {data.winding_to_frame / data.winding_capacity, data.winding_to_frame / data.frame_capacity,
          data.frame_to_ambient / data.frame_capacity};
}

}  // namespace

MotorThermal::MotorThermal(const ThermalData& data) noexcept
    : data_{data}, winding_{data.ambient}, frame_{data.ambient} {
  const Rates r = rates_of(data);
  const double sum = r.winding + r.frame + r.air;
  const double root = std::sqrt(sum * sum - 4.0 * r.winding * r.air);
  fast_rate_ = -0.5 * (sum + root);
  slow_rate_ = r.winding * r.air / fast_rate_;  // their product; a difference would cancel
}

/// The exponential of a 2 x 2 matrix with two different real eigenvalues.
MotorThermal::Transition MotorThermal::transition(double dt) const noexcept {
  const Rates r = rates_of(data_);
  const double fast = std::exp(fast_rate_ * dt) / (fast_rate_ - slow_rate_);
  const double slow = std::exp(slow_rate_ * dt) / (slow_rate_ - fast_rate_);
  const double both = fast + slow;
  const double crossed = fast * slow_rate_ + slow * fast_rate_;
  return {.winding_winding = -r.winding * both - crossed,
          .winding_frame = r.winding * both,
          .frame_winding = r.frame * both,
          .frame_frame = -(r.frame + r.air) * both - crossed};
}

void MotorThermal::step(double dt, double copper_losses, double iron_losses) noexcept {
  if (dt < step_ || dt > step_) {
    step_ = dt;
    transition_ = transition(dt);
  }
  const double final_frame = data_.ambient + (copper_losses + iron_losses) / data_.frame_to_ambient;
  const double final_winding = final_frame + copper_losses / data_.winding_to_frame;
  const double winding = winding_ - final_winding;
  const double frame = frame_ - final_frame;
  winding_ = final_winding + transition_.winding_winding * winding + transition_.winding_frame * frame;
  frame_ = final_frame + transition_.frame_winding * winding + transition_.frame_frame * frame;
}

}  // namespace motor
