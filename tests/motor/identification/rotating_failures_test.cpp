// What a rotating measurement says, and how far the shaft gets, where there is nothing to measure.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/motor/identification/random_plants.hpp"
#include "tests/motor/identification/rotating_trial.hpp"

namespace motor {
namespace {

using identification::measure;
using identification::RotatingOutcome;
using identification::RotatingTrial;

class RotatingMeasurementFails : public testing::TestWithParam<std::string> {
 protected:
  RotatingMeasurementFails() {
    std::mt19937_64 random{identification::plant_seed()};
    trial_ = identification::random_trial(identification::preset(GetParam()), random);
    trial_.load.inertia = 2.0 * trial_.believed.inertia;
  }
  /// Makes it, and expects it to fail at @p progress within three seconds, as slow and as weak as it should be.
  RotatingOutcome expect_failed(std::uint16_t progress = measurement_step::kEncoderTest) const {
    const RotatingOutcome outcome = measure(trial_);
    EXPECT_EQ(outcome.state, MeasurementState::Failed);
    EXPECT_EQ(outcome.progress, progress);
    EXPECT_LT(outcome.seconds, 3.0);
    EXPECT_LT(outcome.highest, 0.4 * trial_.believed.rated_speed);
    EXPECT_GT(outcome.lowest, -0.4 * trial_.believed.rated_speed);
    EXPECT_LE(outcome.torque, 1.001 * trial_.believed.rated_torque);
    EXPECT_EQ(outcome.flux_share, 1.0);
    EXPECT_EQ(outcome.allocations, 0U);
    return outcome;
  }
  /// Of the shaft.
  static double revolutions(const RotatingOutcome& outcome) { return outcome.travel / (2.0 * std::numbers::pi); }

  RotatingTrial trial_;
};

TEST_P(RotatingMeasurementFails, OnALockedShaft) {
  trial_.load.coulomb_friction = 10.0 * trial_.believed.maximum_torque;

  const RotatingOutcome outcome = expect_failed();

  EXPECT_EQ(outcome.travel, 0.0);
  EXPECT_LT(outcome.seconds, 1.0);
}

TEST_P(RotatingMeasurementFails, OnALoadThatIsTooHeavy) {
  trial_.load.constant_torque = 1.5 * trial_.believed.rated_torque;

  EXPECT_LT(revolutions(expect_failed()), 1.0);
}

TEST_P(RotatingMeasurementFails, OnAWrongNumberOfPolePairs) {
  const int real = trial_.real.pole_pairs;
  for (const int believed : {real - 1, real + 1, real + 2, 2 * real}) {
    if (believed == 0) continue;
    SCOPED_TRACE(believed);
    trial_.believed.pole_pairs = static_cast<std::uint8_t>(believed);

    EXPECT_LT(revolutions(expect_failed()), 4.0);
  }
}

TEST_P(RotatingMeasurementFails, OnAReversedEncoder) {
  trial_.defect = EncoderDefect::Reversed;

  EXPECT_LT(revolutions(expect_failed()), 1.0);
}

TEST_P(RotatingMeasurementFails, OnAnEncoderThatSeesNothing) {
  trial_.defect = EncoderDefect::Loss;

  EXPECT_LT(revolutions(expect_failed()), 1.0);
}

TEST_P(RotatingMeasurementFails, OnALockedShaftWithoutEncoderToo) {
  trial_.mode = ControlMode::Sensorless;
  trial_.load.coulomb_friction = 10.0 * trial_.believed.maximum_torque;

  const RotatingOutcome outcome = measure(trial_);

  EXPECT_EQ(outcome.state, MeasurementState::Failed);
  EXPECT_EQ(outcome.progress, measurement_step::kEncoderTest);
  EXPECT_LT(outcome.seconds, 10.0);
}

TEST_P(RotatingMeasurementFails, WithoutEnoughVoltage) {
  for (const double voltage : {0.0, 30.0}) {
    trial_.dc_voltage = voltage;

    EXPECT_LT(revolutions(expect_failed()), 0.01);
  }
}

TEST_P(RotatingMeasurementFails, WhereTheMaximumSpeedShowsNothing) {
  trial_.task.maximum_speed = 0.05 * trial_.believed.rated_speed;

  EXPECT_LT(revolutions(expect_failed()), 0.01);
}

TEST_P(RotatingMeasurementFails, WithoutTorque) {
  trial_.task.torque_limits = {1e-6, -1e-6};

  EXPECT_LT(revolutions(expect_failed()), 0.01);
}

TEST_P(RotatingMeasurementFails, AtOnceIfNoDirectionIsAllowed) {
  trial_.task.forward = false;
  trial_.task.backward = false;

  EXPECT_EQ(expect_failed(measurement_step::kRotating).seconds, 0.0);
}

TEST_P(RotatingMeasurementFails, AtOnceWithoutFieldOrientation) {
  trial_.mode = ControlMode::VoltageFrequency;

  EXPECT_EQ(expect_failed(measurement_step::kRotating).seconds, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Presets, RotatingMeasurementFails, testing::ValuesIn(identification::preset_names()),
                         identification::test_name);

/// Takes the shaft away from a measurement in the middle of it.
class RotatingMeasurementOnTheWay : public testing::Test {
 protected:
  RotatingMeasurementOnTheWay() {
    train_.use_sensors(true);
    measurement_.start({.machine = machine_,
                        .settings = train_.settings(),
                        .maximum_speed = machine_.maximum_speed,
                        .torque_limits = {machine_.maximum_torque, -machine_.maximum_torque}});
  }
  void go_to(std::uint16_t progress, double seconds) {
    for (int i = 0; i < 400'000 && measurement_.progress() != progress; ++i) step();
    for (double time = 0.0; time < seconds; time += kControlPeriod) step();
  }
  void step() { command_ = measurement_.step(observed()), train_.step(540.0, command_); }
  Observation observed() const { return train_.observation(); }

  MachineData machine_ = identification::preset("1fk7063");
  DriveTrain train_ = identification::real_train(machine_, {});
  RotatingMeasurement measurement_;
  DriveCommand command_;
};

TEST_F(RotatingMeasurementOnTheWay, NoticesAShaftThatIsTornAway) {
  go_to(measurement_step::kInertia, 0.3);
  ASSERT_EQ(measurement_.state(), MeasurementState::Running);

  train_.set_load_torque(-3.0 * machine_.rated_torque);
  for (int i = 0; i < 80'000 && measurement_.state() == MeasurementState::Running; ++i) step();

  EXPECT_EQ(measurement_.state(), MeasurementState::Failed);
  EXPECT_EQ(measurement_.progress(), measurement_step::kInertia);
  EXPECT_LT(std::abs(train_.signals().true_speed), machine_.maximum_speed);
  EXPECT_FALSE(command_.pulses_enabled);
}

TEST_F(RotatingMeasurementOnTheWay, NoticesALoadThatComes) {
  go_to(measurement_step::kSaturation, 0.2);
  ASSERT_EQ(measurement_.state(), MeasurementState::Running);

  train_.set_load_torque(1.5 * machine_.rated_torque);
  for (int i = 0; i < 80'000 && measurement_.state() == MeasurementState::Running; ++i) step();

  EXPECT_EQ(measurement_.state(), MeasurementState::Failed);
  EXPECT_EQ(measurement_.progress(), measurement_step::kSaturation);
}

TEST_F(RotatingMeasurementOnTheWay, EndsAtRestAndCanBeMadeAgain) {
  go_to(measurement_step::kRotating, 0.0);
  go_to(measurement_step::kEncoderTest, 0.0);
  go_to(measurement_step::kRotating, 1.0);
  ASSERT_EQ(measurement_.state(), MeasurementState::Done);
  const RotatingResult first = measurement_.result();

  measurement_.start({.machine = machine_,
                      .settings = train_.settings(),
                      .maximum_speed = machine_.maximum_speed,
                      .torque_limits = {machine_.maximum_torque, -machine_.maximum_torque}});
  EXPECT_EQ(measurement_.state(), MeasurementState::Running);
  EXPECT_EQ(measurement_.result().inertia, 0.0);
  go_to(measurement_step::kEncoderTest, 0.0);
  go_to(measurement_step::kRotating, 1.0);

  EXPECT_EQ(measurement_.state(), MeasurementState::Done);
  EXPECT_NEAR(measurement_.result().inertia, first.inertia, 0.005 * first.inertia);
  EXPECT_NEAR(train_.signals().true_speed, 0.0, 1e-3 * machine_.rated_speed);
}

}  // namespace
}  // namespace motor
