#include "tests/motor/identification/rotating_trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/fakes/allocation_counter.hpp"
#include "tests/motor/identification/random_plants.hpp"

namespace identification {
namespace {

constexpr double kLongest = 300.0;  // s

void watch(const motor::DriveTrain& train, RotatingOutcome& outcome) {
  const motor::PlantState& plant = train.plant_state();
  outcome.highest = std::max(outcome.highest, plant.speed);
  outcome.lowest = std::min(outcome.lowest, plant.speed);
  outcome.torque = std::max(outcome.torque, std::abs(train.signals().torque_setpoint));
  const double turns = static_cast<double>(plant.revolutions);
  outcome.travel = std::max(outcome.travel, std::abs(2.0 * std::numbers::pi * turns + plant.rotor_angle));
}

motor::RotatingTask task_of(const RotatingTrial& trial, const motor::ControlSettings& settings) {
  motor::RotatingTask task = trial.task;
  task.machine = trial.believed;
  task.settings = settings;
  if (task.maximum_speed <= 0.0) task.maximum_speed = trial.believed.maximum_speed;
  const double torque = trial.believed.maximum_torque;
  if (task.torque_limits.upper <= 0.0) task.torque_limits = {torque, -torque};
  return task;
}

}  // namespace

double RotatingTrial::drag(double speed) const {
  return real.coulomb_friction + real.hysteresis_torque + load.coulomb_friction +
         speed * (real.viscous_friction + real.eddy_current_drag + load.viscous_friction);
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) names.push_back(preset.name);
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& tested) {
  std::string name = tested.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

RotatingTrial random_trial(const motor::MachineData& machine, std::mt19937_64& random) {
  std::uniform_real_distribution<double> load{0.0, 5.0};
  std::uniform_real_distribution<double> error{-1.0, 1.0};
  RotatingTrial trial;
  trial.real = motor::real_machine(machine, random_deviation(random));
  trial.load.inertia = load(random) * machine.inertia;
  const motor::MachineData& real = trial.real;
  motor::MachineData& believed = trial.believed;
  believed = machine;
  believed.stator_resistance = real.stator_resistance * (1.0 + 0.005 * error(random));
  believed.synchronous.d_inductance = real.synchronous.d_inductance * (1.0 + 0.01 * error(random));
  believed.synchronous.q_inductance = real.synchronous.q_inductance * (1.0 + 0.01 * error(random));
  believed.induction.stator_leakage = real.induction.stator_leakage * (1.0 + 0.01 * error(random));
  believed.induction.rotor_leakage = real.induction.rotor_leakage * (1.0 + 0.01 * error(random));
  believed.induction.rotor_resistance = real.induction.rotor_resistance * (1.0 + 0.02 * error(random));
  believed.induction.magnetising_inductance = real.induction.magnetising_inductance * (1.0 + 0.02 * error(random));
  return trial;
}

RotatingOutcome measure(const RotatingTrial& trial) {
  const motor::InverterData inverter = real_inverter(trial.believed);
  motor::DriveTrain train{trial.believed, trial.real, trial.load, inverter};
  motor::ControlSettings settings = motor::computed_settings(trial.believed, inverter, trial.believed.inertia);
  settings.mode = trial.mode;
  train.tune(settings);
  train.use_sensors(true);
  if (trial.defect != motor::EncoderDefect::None) train.inject(trial.defect);
  train.set_brake(false);
  motor::RotatingMeasurement measurement;
  RotatingOutcome outcome;
  const std::uint64_t before = fakes::allocations();
  measurement.start(task_of(trial, settings));
  while (measurement.state() == motor::MeasurementState::Running && outcome.seconds < kLongest) {
    const motor::DriveCommand command = measurement.step(train.observation());
    train.set_flux_share(measurement.flux_share());
    train.step(trial.dc_voltage, command);
    outcome.seconds += motor::kControlPeriod;
    watch(train, outcome);
  }
  outcome.allocations = fakes::allocations() - before;
  outcome.state = measurement.state();
  outcome.progress = measurement.progress();
  outcome.result = measurement.result();
  outcome.last_speed = train.plant_state().speed;
  outcome.flux_share = measurement.flux_share();
  return outcome;
}

}  // namespace identification
