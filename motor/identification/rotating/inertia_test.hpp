#pragma once

#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/rotating/rotating_step.hpp"

namespace motor {

/// Inertia and friction from ramps, without any derivative: what the torque has given to the shaft is
///   int T dt = J w + B theta + T_c int sign(w) dt + T_load t + constant,
/// by least squares over all that is faster than the least speed, where power shows the torque.
class InertiaTest final : public RotatingStep {
 public:
  SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept override;
  void take(const FieldBlock& block, const SpeedPlace& place) noexcept override;
  bool finish(RotatingFindings& found) noexcept override;

 private:
  void begin_pass() noexcept;

  double least_speed_ = 0.0;
  bool both_directions_ = true;
  bool threshold_known_ = false;
  double threshold_voltage_ = 0.0;
  double rotor_inertia_ = 0.0;
  LeastSquares<5> shaft_;  // inertia, viscous friction, constant torque, dry friction, threshold voltage
  // Since the speed last came from below the least one.
  double angle_ = 0.0;
  double time_ = 0.0;
  double impulse_ = 0.0;
  double lost_impulse_ = 0.0;
};

}  // namespace motor
