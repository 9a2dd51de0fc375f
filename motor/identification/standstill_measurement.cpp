#include "motor/identification/standstill_measurement.hpp"

namespace motor {

void StandstillMeasurement::start(const StandstillTask& task) noexcept {
  task_ = task;
  result_ = {};
  state_ = MeasurementState::Running;
  progress_ = measurement_step::kStandstill;
}

SpaceVector StandstillMeasurement::step(const Measurement& /*measured*/, Signals& /*signals*/) noexcept {
  state_ = MeasurementState::Failed;
  fault_ = StandstillFault::CurrentLimit;
  return {};
}

MachineData identified_machine(const MachineData& believed, const StandstillResult& /*result*/) noexcept {
  return believed;
}

}  // namespace motor
