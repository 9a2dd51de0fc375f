#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motor/drive_train.hpp"
#include "motor/identification/rotating/rotating_measurement.hpp"

namespace identification {

/// A rotating measurement to be made: what turns, what the drive believes, and what it is told.
struct RotatingTrial {
  motor::MachineData believed{};
  motor::MachineData real{};
  motor::Load load{};
  motor::ControlMode mode = motor::ControlMode::Encoder;
  motor::EncoderDefect defect = motor::EncoderDefect::None;
  double dc_voltage = 540.0;
  motor::RotatingTask task{};  ///< machine and settings are filled in, and limits where they are 0

  /// Of rotor and load (kg·m²).
  double inertia() const { return real.inertia + load.inertia; }
  /// What friction and iron brake with at @p speed (N·m).
  double drag(double speed) const;
};

/// How it went.
struct RotatingOutcome {
  motor::MeasurementState state{};
  std::uint16_t progress = 0;
  motor::RotatingResult result{};
  double seconds = 0.0;
  double highest = 0.0;     ///< true speed (rad/s)
  double lowest = 0.0;      ///< true speed (rad/s)
  double torque = 0.0;      ///< largest setpoint, either way (N·m)
  double travel = 0.0;      ///< the furthest way from the start (rad)
  double last_speed = 0.0;  ///< true one (rad/s)
  double flux_share = 1.0;  ///< at the end
  std::uint64_t allocations = 0;

  bool done() const { return state == motor::MeasurementState::Done; }
};

/// Names of the presets.
std::vector<std::string> preset_names();
/// The name of a preset as a part of the name of a test.
std::string test_name(const testing::TestParamInfo<std::string>& tested);
/// A random machine of the data sheet @p machine with a load of up to five rotors, after the identification at
/// standstill: what that finds is believed within its accuracy, all else as the data sheet says.
RotatingTrial random_trial(const motor::MachineData& machine, std::mt19937_64& random);
/// Makes it, with the speed controller set for the rotor alone.
RotatingOutcome measure(const RotatingTrial& trial);

}  // namespace identification
