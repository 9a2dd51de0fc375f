#include "motor/identification/rotating_measurement.hpp"

namespace motor {

void RotatingMeasurement::start(const RotatingTask& task) noexcept {
  task_ = task;
  result_ = {};
  state_ = MeasurementState::Running;
  progress_ = measurement_step::kRotating;
}

Command RotatingMeasurement::step(const Observation& /*seen*/) noexcept {
  state_ = MeasurementState::Failed;
  return {};
}

}  // namespace motor
