#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <utility>

#include "motor/data/control_period.hpp"
#include "motor/identification/standstill/standstill_measurement.hpp"
#include "tests/motor/identification/random_plants.hpp"

namespace identification {

inline constexpr double kDcVoltage = 540.0;  // V
inline constexpr double kDegree = std::numbers::pi / 180.0;
/// The furthest that the shaft of a servo, or another one, may turn (rad).
inline constexpr double kServoTravel = 210.0 * kDegree;
inline constexpr double kVectorTravel = 90.0 * kDegree;

/// What a drive that believes in @p data_sheet starts with.
inline motor::StandstillTask task_for(const motor::MachineData& data_sheet) {
  const motor::InverterData inverter = real_inverter(data_sheet);
  return {.machine = data_sheet, .settings = motor::computed_settings(data_sheet, inverter, data_sheet.inertia)};
}

/// Lets @p seconds pass under @p command.
inline void pass(motor::DriveTrain& train, const motor::DriveCommand& command, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / motor::kControlPeriod));
  for (int i = 0; i < steps; ++i) train.step(kDcVoltage, command);
}

/// real_train() that was led to another place, about @p angle (rad) from where it was switched on, and stopped.
inline motor::DriveTrain turned_train(const motor::MachineData& data_sheet, const motor::PlantDeviation& deviation,
                                      double angle) {
  motor::DriveTrain train = real_train(data_sheet, deviation);
  motor::DriveCommand command{.pulses_enabled = true};
  command.limits = {data_sheet.rated_torque, -data_sheet.rated_torque};
  pass(train, command, 1.0);
  command.speed_setpoint = angle;
  pass(train, command, 1.0);
  command.speed_setpoint = 0.0;
  pass(train, command, 1.0);
  pass(train, {}, 0.5);
  return train;
}

/// A measurement at standstill, and what happened to the machine meanwhile.
class StandstillTrial {
 public:
  explicit StandstillTrial(motor::DriveTrain measured_train) : train{std::move(measured_train)} {}

  /// Lets it run to its end or for a minute, with @p each called after every step.
  void run(const motor::StandstillTask& task, const std::function<void()>& each = {}) {
    constexpr double kLongest = 60.0;
    measurement.start(task);
    train.lead_by(&measurement);
    const double from = angle();
    while (measurement.state() == motor::MeasurementState::Running && duration < kLongest) {
      train.step(dc_voltage, {.pulses_enabled = true});
      duration += motor::kControlPeriod;
      travel = std::max(travel, std::abs(angle() - from));
      current = std::max(current, train.signals().current);
      progress.insert(measurement.progress());
      if (each) each();
    }
    train.lead_by(nullptr);
  }
  const motor::StandstillResult& result() const { return measurement.result(); }
  /// True angle of the shaft since power-on (rad).
  double angle() const {
    const motor::PlantState& state = train.plant_state();
    return 2.0 * std::numbers::pi * static_cast<double>(state.revolutions) + state.rotor_angle;
  }

  motor::DriveTrain train;
  motor::StandstillMeasurement measurement;
  double dc_voltage = kDcVoltage;
  double duration = 0.0;             // s
  double travel = 0.0;               // true (rad)
  double current = 0.0;              // highest (A peak)
  std::set<std::uint16_t> progress;  // all that was shown
};

}  // namespace identification
