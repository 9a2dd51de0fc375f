#pragma once

#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/rotating/rotating_step.hpp"

namespace motor {

/// Flux of the magnets: what the speed induces beside resistance and inductances. The voltage that dead time and
/// valves take changes its sign with the current, so it is found beside it where the shaft speeds up and slows
/// down alternately.
class MagnetFluxTest final : public RotatingStep {
 public:
  SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept override;
  void take(const FieldBlock& block, const SpeedPlace& place) noexcept override;
  bool finish(RotatingFindings& found) noexcept override;

 private:
  MachineData machine_{};
  bool with_encoder_ = true;
  double least_frequency_ = 0.0;  // electrical rad/s
  double least_current_ = 0.0;    // A
  LeastSquares<2> strong_;        // flux and threshold voltage, from strong currents
  LeastSquares<2> all_;           // the same from all
};

}  // namespace motor
