#pragma once

#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/rotating/rotating_step.hpp"

namespace motor {

/// Whether the shaft follows its encoder: at a moderate speed the voltage must show the flux where the control
/// believes it, which a wrong number of pole pairs or a reversed encoder puts elsewhere. Finds by the way what
/// slope suits the load.
class EncoderTest final : public RotatingStep {
 public:
  SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept override;
  void take(const FieldBlock& block, const SpeedPlace& place) noexcept override;
  bool finish(RotatingFindings& found) noexcept override;

 private:
  RotatingTask task_{};
  SpeedPlan plan_{};
  SpaceVector inductances_{};  // whose flux is not what is looked for (H)
  LeastSquares<2> shaft_;      // inertia and constant torque from what the control believes
  double impulse_ = 0.0;       // N·m·s
  double time_ = 0.0;          // s
  SpaceVector flux_{};         // sums of the last stop
  double expected_ = 0.0;
  double torque_ = 0.0;
  int blocks_ = 0;
};

}  // namespace motor
