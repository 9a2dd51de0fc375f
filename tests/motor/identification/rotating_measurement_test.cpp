// What a rotating measurement finds, held against what turns.
#include "motor/identification/rotating/rotating_measurement.hpp"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "motor/identification/model/field_model.hpp"
#include "tests/motor/identification/random_plants.hpp"
#include "tests/motor/identification/rotating_trial.hpp"

namespace motor {
namespace {

using identification::measure;
using identification::random_trial;
using identification::RotatingOutcome;
using identification::RotatingTrial;

constexpr int kPlants = 20;

/// Largest deviations from the truth, as shares of it; friction as share of the rated torque.
struct Worst {
  double inertia = 0.0;
  double flux = 0.0;
  double friction = 0.0;
  double seconds = 0.0;
  double travel = 0.0;
};

/// Largest deviation of a flux of the characteristic from what its current makes.
double deviation_of_characteristic(const RotatingTrial& trial, const RotatingResult& found) {
  const InductionCircuit real = induction_circuit(trial.real);
  const double rated_current = std::numbers::sqrt2 * trial.believed.induction.magnetising_current;
  double worst = 0.0;
  for (std::size_t i = 0; i < found.flux.size(); ++i) {
    const double flux = standing_flux(real, found.magnetising_current[i] * rated_current);
    worst = std::max(worst, std::abs(found.flux[i] * rated_flux(trial.believed) / flux - 1.0));
  }
  InductionCircuit fitted = real;
  fitted.magnetising_inductance = found.fitted_magnetising_inductance;
  fitted.saturation_flux = found.fitted_saturation_flux;
  for (const double share : {0.3, 0.6, 1.0, 1.3}) {
    const double current = share * rated_current;
    worst = std::max(worst, std::abs(standing_flux(fitted, current) / standing_flux(real, current) - 1.0));
  }
  return worst;
}

double deviation_of_flux(const RotatingTrial& trial, const RotatingResult& found) {
  if (trial.real.type == MachineType::Induction) return deviation_of_characteristic(trial, found);
  return std::abs(found.magnet_flux / trial.real.synchronous.magnet_flux - 1.0);
}

double deviation_of_inertia(const RotatingTrial& trial, const RotatingResult& found) {
  return std::abs(found.inertia / trial.inertia() - 1.0);
}

/// Forwards, at a quarter of the rated speed.
double deviation_of_drag(const RotatingTrial& trial, const RotatingResult& found) {
  const double speed = 0.25 * trial.believed.rated_speed;
  const double drag = found.coulomb_friction + found.load_torque + found.viscous_friction * speed;
  return std::abs(drag - trial.drag(speed) - trial.load.constant_torque) / trial.believed.rated_torque;
}

/// Twenty plants of a preset.
class RotatingMeasurementOf : public testing::TestWithParam<std::string> {
 protected:
  /// Measures them after @p change of each trial.
  template <class Change>
  Worst worst_of_plants(Change change) const {
    std::mt19937_64 random{identification::plant_seed()};
    Worst worst;
    for (int i = 0; i < kPlants; ++i) {
      RotatingTrial trial = random_trial(identification::preset(GetParam()), random);
      change(trial);
      const RotatingOutcome outcome = measure(trial);
      EXPECT_TRUE(outcome.done()) << "plant " << i << " failed at " << outcome.progress;
      EXPECT_LT(outcome.highest, 0.5 * trial.believed.rated_speed);
      EXPECT_GT(outcome.lowest, -0.5 * trial.believed.rated_speed);
      EXPECT_TRUE(trial.mode == ControlMode::Sensorless || std::abs(outcome.result.travel - outcome.travel) < 0.2);
      worst.inertia = std::max(worst.inertia, deviation_of_inertia(trial, outcome.result));
      worst.flux = std::max(worst.flux, deviation_of_flux(trial, outcome.result));
      worst.friction = std::max(worst.friction, deviation_of_drag(trial, outcome.result));
      worst.seconds = std::max(worst.seconds, outcome.seconds);
      worst.travel = std::max(worst.travel, outcome.travel);
    }
    print(worst);
    return worst;
  }

 private:
  static void print(const Worst& worst) {
    std::printf("| %s | %.2f %% | %.2f %% | %.1f %% | %.0f s | %.0f |\n", GetParam().c_str(),
                100.0 * worst.inertia, 100.0 * worst.flux, 100.0 * worst.friction, worst.seconds,
                worst.travel / (2.0 * std::numbers::pi));
  }
};

TEST_P(RotatingMeasurementOf, FindsInertiaAndFluxOfRandomPlants) {
  const Worst worst = worst_of_plants([](RotatingTrial&) {});

  EXPECT_LT(worst.inertia, 0.01);
  EXPECT_LT(worst.flux, 0.01);
  EXPECT_LT(worst.friction, 0.01);
}

TEST_P(RotatingMeasurementOf, FindsThemByTheDataSheetAlone) {
  const Worst worst =
      worst_of_plants([this](RotatingTrial& trial) { trial.believed = identification::preset(GetParam()); });

  EXPECT_LT(worst.inertia, 0.02);
  EXPECT_LT(worst.flux, 0.04);
  EXPECT_LT(worst.friction, 0.03);
}

TEST_P(RotatingMeasurementOf, FindsThemWithoutEncoder) {
  const Worst worst = worst_of_plants([](RotatingTrial& trial) { trial.mode = ControlMode::Sensorless; });

  EXPECT_LT(worst.inertia, 0.05);
  EXPECT_LT(worst.flux, 0.02);
  EXPECT_LT(worst.friction, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Presets, RotatingMeasurementOf, testing::ValuesIn(identification::preset_names()),
                         identification::test_name);

/// A servo and an induction motor under special conditions.
class RotatingMeasurementWith : public testing::TestWithParam<std::string> {
 protected:
  RotatingMeasurementWith() {
    std::mt19937_64 random{identification::plant_seed()};
    trial_ = random_trial(identification::preset(GetParam()), random);
    trial_.load.inertia = 2.0 * trial_.believed.inertia;
  }
  double rated_torque() const { return trial_.believed.rated_torque; }
  /// Makes it, and expects inertia and drag.
  RotatingOutcome expect_found(double tolerance = 0.02) const {
    const RotatingOutcome outcome = measure(trial_);
    EXPECT_TRUE(outcome.done()) << "failed at " << outcome.progress;
    EXPECT_LT(deviation_of_inertia(trial_, outcome.result), tolerance);
    EXPECT_LT(std::abs(outcome.last_speed), 0.01 * trial_.believed.rated_speed);
    EXPECT_LE(outcome.torque, 1.001 * rated_torque());
    return outcome;
  }

  RotatingTrial trial_;
};

TEST_P(RotatingMeasurementWith, ACoarseEncoder) {
  for (MachineData* const machine : {&trial_.believed, &trial_.real}) {
    machine->encoder.pulses = 1024;
    machine->encoder.fine_bits = 2;
  }

  const RotatingOutcome outcome = expect_found();
  EXPECT_LT(deviation_of_flux(trial_, outcome.result), 0.01);
}

TEST_P(RotatingMeasurementWith, AHoist) {
  trial_.load.constant_torque = 0.4 * rated_torque();
  trial_.load.brake = {.torque = 2.0 * rated_torque()};

  const RotatingOutcome outcome = expect_found();
  EXPECT_LT(deviation_of_flux(trial_, outcome.result), 0.01);
  EXPECT_NEAR(outcome.result.load_torque, trial_.load.constant_torque, 0.02 * rated_torque());
}

TEST_P(RotatingMeasurementWith, ALotOfFriction) {
  trial_.load.coulomb_friction = 0.2 * rated_torque();
  trial_.load.breakaway_torque = 0.3 * rated_torque();
  trial_.load.viscous_friction = 0.1 * rated_torque() / trial_.believed.rated_speed;

  const RotatingOutcome outcome = expect_found();
  EXPECT_NEAR(outcome.result.coulomb_friction, trial_.drag(0.0), 0.02 * rated_torque());
  EXPECT_NEAR(outcome.result.load_torque, 0.0, 0.01 * rated_torque());
}

TEST_P(RotatingMeasurementWith, AFan) {
  const double speed = trial_.believed.rated_speed;
  trial_.load.fan_coefficient = 0.5 * rated_torque() / (speed * speed);

  expect_found();
}

TEST_P(RotatingMeasurementWith, AnElasticCoupling) {
  const double load = trial_.load.inertia;
  const double inertia = trial_.real.inertia * load / (trial_.real.inertia + load);
  const double resonance = 2.0 * std::numbers::pi * 60.0;
  trial_.load.coupling = {.stiffness = resonance * resonance * inertia, .damping = 0.04 * resonance * inertia};

  expect_found(0.03);
}

TEST_P(RotatingMeasurementWith, ForwardsOnly) {
  trial_.task.backward = false;

  const RotatingOutcome outcome = expect_found();
  EXPECT_GT(outcome.lowest, -0.02 * trial_.believed.rated_speed);
  EXPECT_LT(deviation_of_drag(trial_, outcome.result), 0.02);
}

TEST_P(RotatingMeasurementWith, BackwardsOnly) {
  trial_.task.forward = false;

  const RotatingOutcome outcome = expect_found();
  EXPECT_LT(outcome.highest, 0.02 * trial_.believed.rated_speed);
}

TEST_P(RotatingMeasurementWith, ARampTime) {
  trial_.task.ramp_time = 5.0;

  const RotatingOutcome outcome = expect_found();
  // Six ramps of inertia alone are as long as that.
  EXPECT_GT(outcome.seconds, 11.0 * outcome.highest / trial_.believed.maximum_speed * trial_.task.ramp_time);
}

TEST_P(RotatingMeasurementWith, ALowMaximumSpeed) {
  trial_.task.maximum_speed = 0.2 * trial_.believed.rated_speed;

  const RotatingOutcome outcome = expect_found();
  EXPECT_LT(outcome.highest, trial_.task.maximum_speed);
  EXPECT_GT(outcome.lowest, -trial_.task.maximum_speed);
}

TEST_P(RotatingMeasurementWith, LittleTorque) {
  const double limit = 0.3 * rated_torque();
  trial_.task.torque_limits = {limit, -limit};

  EXPECT_LE(expect_found().torque, 1.001 * limit);
}

TEST_P(RotatingMeasurementWith, ALowDcVoltage) {
  trial_.dc_voltage = 150.0;

  const RotatingOutcome outcome = expect_found();
  EXPECT_LT(deviation_of_flux(trial_, outcome.result), 0.01);
}

TEST_P(RotatingMeasurementWith, OnlyWhatIsAskedFor) {
  trial_.task.finds_flux = false;
  const RotatingOutcome inertia = expect_found();
  trial_.task.finds_flux = true;
  trial_.task.finds_inertia = false;
  const RotatingOutcome flux = measure(trial_);

  EXPECT_EQ(inertia.result.magnet_flux, 0.0);
  EXPECT_EQ(inertia.result.flux[0], 0.0);
  EXPECT_EQ(flux.result.inertia, 0.0);
  EXPECT_LT(deviation_of_flux(trial_, flux.result), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Motors, RotatingMeasurementWith, testing::Values("1fk7042", "1ph8131"),
                         identification::test_name);

}  // namespace
}  // namespace motor
