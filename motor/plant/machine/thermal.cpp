#include "motor/plant/machine/thermal.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace motor {
namespace {

/// How deviations from the final temperatures change: heat flows between the bodies per kelvin, over their heat
/// capacities (1/s).
Eigen::Matrix2d rates_of(const ThermalData& data) noexcept {
  const double winding = data.winding_to_frame / data.winding_capacity;
  const double frame = data.winding_to_frame / data.frame_capacity;
  const double air = data.frame_to_ambient / data.frame_capacity;
  Eigen::Matrix2d rates;
  rates << -winding, winding, frame, -(frame + air);
  return rates;
}

}  // namespace

MotorThermal::MotorThermal(const ThermalData& data) noexcept
    : data_{data}, winding_{data.ambient}, frame_{data.ambient} {}

void MotorThermal::step(double dt, double copper_losses, double iron_losses) noexcept {
  if (dt < step_ || dt > step_) {
    step_ = dt;
    const Eigen::Matrix2d transition = (rates_of(data_) * dt).exp();
    transition_ = {transition(0, 0), transition(0, 1), transition(1, 0), transition(1, 1)};
  }
  const double final_frame = data_.ambient + (copper_losses + iron_losses) / data_.frame_to_ambient;
  const double final_winding = final_frame + copper_losses / data_.winding_to_frame;
  const double winding = winding_ - final_winding;
  const double frame = frame_ - final_frame;
  winding_ = final_winding + transition_[0] * winding + transition_[1] * frame;
  frame_ = final_frame + transition_[2] * winding + transition_[3] * frame;
}

}  // namespace motor
