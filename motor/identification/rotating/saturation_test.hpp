#pragma once

#include <array>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/identification/rotating/rotating_step.hpp"

namespace motor {

/// Saturation characteristic of an induction machine: at no load and constant speed the stator voltage shows the
/// flux, and the current along it is what magnetises.
class SaturationTest final : public RotatingStep {
 public:
  SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept override;
  void take(const FieldBlock& block, const SpeedPlace& place) noexcept override;
  bool finish(RotatingFindings& found) noexcept override;

 private:
  static constexpr std::size_t kLevels = 5;
  /// Sums of what was seen at a level of flux.
  struct Level {
    SpaceVector voltage{};  // behind the resistance (V)
    SpaceVector current{};  // A
    SpaceVector threshold{};
    double frequency = 0.0;
    double power = 0.0;     // behind the resistance (W)
    double per_volt = 0.0;  // power that each volt of threshold voltage takes (W/V)
    int blocks = 0;
  };
  bool find_threshold(RotatingFindings& found) const noexcept;
  FluxPoint point_of(const Level& level, double threshold) const noexcept;

  InductionCircuit circuit_{};
  double rated_flux_ = 1.0;               // V·s
  double rated_current_ = 1.0;            // A
  std::array<double, kLevels> shares_{};  // of the rated flux
  std::array<Level, kLevels> levels_{};
};

}  // namespace motor
