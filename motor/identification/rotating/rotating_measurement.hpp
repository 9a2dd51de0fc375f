#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motor/control/observation.hpp"
#include "motor/control/signals.hpp"
#include "motor/identification/model/measurement_state.hpp"
#include "motor/identification/rotating/encoder_test.hpp"
#include "motor/identification/rotating/field_reader.hpp"
#include "motor/identification/rotating/inertia_test.hpp"
#include "motor/identification/rotating/magnet_flux_test.hpp"
#include "motor/identification/rotating/rotating_step.hpp"
#include "motor/identification/rotating/rotating_task.hpp"
#include "motor/identification/rotating/saturation_test.hpp"
#include "motor/identification/rotating/speed_plan.hpp"
#include "motor/identification/rotating/stall_watch.hpp"

namespace motor {

/// The end of a rotating measurement: the shaft comes to rest.
class ComingToRest final : public RotatingStep {
 public:
  SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept override;
  void take(const FieldBlock& /*block*/, const SpeedPlace& /*place*/) noexcept override {}
  bool finish(RotatingFindings& /*found*/) noexcept override { return true; }
};

/// Rotating measurement (p1960): leads the control by its commands, and learns from what the drive sees while it
/// uses its sensors.
class RotatingMeasurement {
 public:
  /// Begins with @p task at the next step(); Failed at once where the task allows no direction or speed, or its
  /// control has no field.
  void start(const RotatingTask& task) noexcept;
  /// The command for the next control period, from what was seen after the last one. Once Done it keeps the shaft
  /// at rest, once Failed it takes the pulses off.
  DriveCommand step(const Observation& seen) noexcept;
  /// The share of the rated flux that the control must keep from now on.
  double flux_share() const noexcept { return flux_share_; }

  MeasurementState state() const noexcept { return state_; }
  /// Of measurement_step, what it does, or what it failed at: the value of F07985.
  std::uint16_t progress() const noexcept { return progress_; }
  /// The share of its steps that it has behind it, 0 to 1.
  double share() const noexcept;
  /// Complete in the state Done.
  const RotatingResult& result() const noexcept { return found_.result; }

 private:
  /// A step, and the tasks that want it.
  struct PlannedStep {
    std::uint16_t progress;
    bool (*wanted)(const RotatingTask& task);
    RotatingStep& (*step)(RotatingMeasurement& measurement);
  };
  static const std::array<PlannedStep, 5> kSequence;

  void begin(const Observation& seen) noexcept;
  void go_on(const Observation& seen) noexcept;
  void begin_step(std::size_t index) noexcept;
  bool out_of_bounds(const Observation& seen) noexcept;
  void fail() noexcept;
  DriveCommand command() const noexcept;

  RotatingTask task_{};
  RotatingFindings found_{};
  FieldReader reader_;
  SpeedWalk walk_;
  StallWatch stall_;
  EncoderTest encoder_test_;
  MagnetFluxTest magnet_flux_;
  SaturationTest saturation_;
  InertiaTest inertia_;
  ComingToRest rest_;
  MeasurementState state_ = MeasurementState::Idle;
  std::uint16_t progress_ = measurement_step::kNone;
  std::size_t row_ = 0;  // of kSequence
  int waiting_ = 0;      // periods until the first step begins
  double flux_share_ = 1.0;
  double highest_ = 0.0;  // speeds that the step may reach (rad/s)
  double lowest_ = 0.0;
};

}  // namespace motor
