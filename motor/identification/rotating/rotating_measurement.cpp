#include "motor/identification/rotating/rotating_measurement.hpp"

#include <algorithm>
#include <cmath>

#include "motor/identification/rotating/test_speeds.hpp"

namespace motor {
namespace {

constexpr double kArrived = 0.03;    // of the rated speed, near enough to the setpoint
constexpr double kGain = 0.005;      // of the rated speed, that a shaft at the torque limit must gain
constexpr double kOvershoot = 0.25;  // of the speeds of a step, by which the shaft may pass them
constexpr double kSway = 0.06;       // of the rated speed, the same at standstill
constexpr double kRest = 0.4;        // s
constexpr int kFirstPeriods = 80;    // until the sensors have been read with pulses

bool is_possible(const RotatingTask& task) noexcept {
  const bool turns = (task.forward || task.backward) && task.maximum_speed > 0.0;
  return turns && task.settings.mode != ControlMode::VoltageFrequency;
}

}  // namespace

const std::array<RotatingMeasurement::PlannedStep, 5> RotatingMeasurement::kSequence{{
    {measurement_step::kEncoderTest, [](const RotatingTask&) { return true; },
     [](RotatingMeasurement& m) -> RotatingStep& { return m.encoder_test_; }},
    {measurement_step::kSaturation,
     [](const RotatingTask& task) { return task.finds_flux && task.machine.type == MachineType::Synchronous; },
     [](RotatingMeasurement& m) -> RotatingStep& { return m.magnet_flux_; }},
    {measurement_step::kSaturation,
     [](const RotatingTask& task) { return task.finds_flux && task.machine.type == MachineType::Induction; },
     [](RotatingMeasurement& m) -> RotatingStep& { return m.saturation_; }},
    {measurement_step::kInertia, [](const RotatingTask& task) { return task.finds_inertia; },
     [](RotatingMeasurement& m) -> RotatingStep& { return m.inertia_; }},
    {measurement_step::kRotating, [](const RotatingTask&) { return true; },
     [](RotatingMeasurement& m) -> RotatingStep& { return m.rest_; }},
}};

SpeedPlan ComingToRest::start(const RotatingTask& /*task*/, const RotatingFindings& /*found*/) noexcept {
  SpeedPlan plan;
  plan.add({.speed = 0.0, .hold = kRest});
  return plan;
}

void RotatingMeasurement::start(const RotatingTask& task) noexcept {
  *this = {};
  task_ = task;
  state_ = is_possible(task) ? MeasurementState::Running : MeasurementState::Failed;
  progress_ = measurement_step::kRotating;
  waiting_ = kFirstPeriods;
}

DriveCommand RotatingMeasurement::step(const Observation& seen) noexcept {
  if (state_ != MeasurementState::Running) return command();
  if (waiting_ == 0)
    go_on(seen);
  else if (--waiting_ == 0)
    begin(seen);
  return command();
}

void RotatingMeasurement::begin(const Observation& seen) noexcept {
  found_.slope = cautious_slope(task_);
  found_.dc_voltage = seen.dc_voltage;
  reader_.start(task_.machine, task_.settings);
  begin_step(0);
}

void RotatingMeasurement::begin_step(std::size_t index) noexcept {
  row_ = index;
  while (!kSequence[row_].wanted(task_)) ++row_;
  const PlannedStep& row = kSequence[row_];
  progress_ = row.progress;
  const SpeedPlan plan = row.step(*this).start(task_, found_);
  if (plan.count == 0) return fail();
  walk_.start(plan, found_.slope, kArrived * task_.machine.rated_speed);
  stall_ = StallWatch{kGain * task_.machine.rated_speed};
  const double sway = kSway * task_.machine.rated_speed;
  const double now = walk_.setpoint();
  highest_ = std::min((1.0 + kOvershoot) * std::max(walk_.highest(), now) + sway, task_.maximum_speed);
  lowest_ = std::max((1.0 + kOvershoot) * std::min(walk_.lowest(), now) - sway, -task_.maximum_speed);
}

/// Whether the shaft turns faster than the step wants or another way, or does not follow at all.
bool RotatingMeasurement::out_of_bounds(const Observation& seen) noexcept {
  return stall_.step(walk_.goal(), seen) || seen.speed > highest_ || seen.speed < lowest_;
}

void RotatingMeasurement::go_on(const Observation& seen) noexcept {
  if (out_of_bounds(seen)) return fail();
  const SpeedWalk::Progress walked = walk_.step(seen, seen.magnetised);
  flux_share_ = walk_.flux_share();
  RotatingStep& step = kSequence[row_].step(*this);
  if (const FieldBlock* const block = reader_.take(seen)) step.take(*block, walk_.place());
  found_.result.travel = std::max(found_.result.travel, std::abs(reader_.angle()));
  if (walked == SpeedWalk::Progress::Running) return;
  if (walked == SpeedWalk::Progress::Late || !step.finish(found_)) return fail();
  if (row_ + 1 == kSequence.size()) {
    state_ = MeasurementState::Done;
    return;
  }
  found_.dc_voltage = seen.dc_voltage;
  begin_step(row_ + 1);
}

double RotatingMeasurement::share() const noexcept {
  return static_cast<double>(row_) / static_cast<double>(kSequence.size());
}

void RotatingMeasurement::fail() noexcept {
  state_ = MeasurementState::Failed;
  flux_share_ = 1.0;
}

DriveCommand RotatingMeasurement::command() const noexcept {
  if (state_ != MeasurementState::Running && state_ != MeasurementState::Done) return {};
  return {.pulses_enabled = true,
          .speed_setpoint = walk_.setpoint(),
          .acceleration_setpoint = walk_.slope(),
          .limits = test_limits(task_)};
}

}  // namespace motor
