#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/identification/standstill/standstill_measurement.hpp"
#include "tests/motor/identification/standstill_trial.hpp"

namespace motor {
namespace {

using identification::kDegree;
using identification::kServoTravel;
using identification::preset;
using identification::real_train;
using identification::StandstillTrial;
using identification::task_for;

/// Turns the shaft by about @p angle (rad) while the encoder has no signals, so that it is wrong ever after.
void misplace_encoder(DriveTrain& train, double angle) {
  const auto turned = [&train] {
    const double a = train.plant_state().rotor_angle;
    return a > std::numbers::pi ? a - 2.0 * std::numbers::pi : a;
  };
  const double torque = angle > 0.0 ? -1.0 : 1.0;
  train.inject(EncoderDefect::Loss);
  train.set_load_torque(torque);
  while (std::abs(turned()) < 0.5 * std::abs(angle)) train.step(identification::kDcVoltage, {});
  train.set_load_torque(-torque);
  while (train.signals().true_speed * angle > 0.0) train.step(identification::kDcVoltage, {});
  train.set_load_torque(0.0);
  identification::pass(train, {}, 0.1);
  train.inject(EncoderDefect::None);
}

/// Electrical angle of the rotor past where the encoder has it (rad).
double misplacement(const DriveTrain& train, const MachineData& machine) {
  const double counted = static_cast<double>(train.encoder().counts()) / increments_per_revolution(machine);
  const double angle = train.plant_state().rotor_angle - 2.0 * std::numbers::pi * counted;
  return machine.pole_pairs * std::remainder(angle, 2.0 * std::numbers::pi);
}

TEST(PoleTest, FindsHowFarTheEncoderIsWrong) {
  for (const char* const name : {"1fk7042", "1fk7063", "1ft7044", "ipmsm-2k2"}) {
    const MachineData& machine = preset(name);
    for (const double degrees : {-12.0, -6.0, 7.0, 12.0}) {
      StandstillTrial trial{real_train(machine, {})};
      misplace_encoder(trial.train, degrees * kDegree / machine.pole_pairs);
      const double truth = misplacement(trial.train, machine);
      ASSERT_NEAR(truth, degrees * kDegree, 3.0 * kDegree) << name;

      trial.run(task_for(machine));

      ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << name << ' ' << degrees;
      EXPECT_NEAR(trial.result().pole_position, truth, 5.0 * kDegree) << name;
      EXPECT_NEAR(trial.result().d_inductance / machine.synchronous.d_inductance, 1.0, 0.03) << name;
      EXPECT_NEAR(trial.result().q_inductance / machine.synchronous.q_inductance, 1.0, 0.03) << name;
    }
  }
}

TEST(PoleTest, RefusesAnEncoderThatIsWrongByFarTooMuch) {
  for (const double degrees : {-150.0, -90.0, -45.0, -25.0, 25.0, 45.0, 90.0, 150.0}) {
    const MachineData& machine = preset("1fk7063");
    StandstillTrial trial{real_train(machine, {})};
    misplace_encoder(trial.train, degrees * kDegree / machine.pole_pairs);

    trial.run(task_for(machine));

    EXPECT_EQ(trial.measurement.state(), MeasurementState::Failed) << degrees;
    EXPECT_EQ(trial.measurement.fault(), StandstillFault::PolePosition) << degrees;
    EXPECT_LT(trial.travel, 30.0 * kDegree) << degrees;
  }
}

TEST(PoleTest, WorksWithCoarseEncodersHeavyLoadsAndFriction) {
  MachineData machine = preset("1fk7063");
  machine.encoder.pulses = 1024;
  machine.encoder.fine_bits = 2;
  for (const Load& load : {Load{}, Load{.inertia = 0.02}, Load{.coulomb_friction = 2.0},
                           Load{.inertia = 0.01, .coulomb_friction = 1.0, .constant_torque = 0.3}}) {
    StandstillTrial trial{real_train(machine, {}, load)};

    trial.run(task_for(machine));

    EXPECT_EQ(trial.measurement.fault(), StandstillFault::None);
    EXPECT_NEAR(trial.result().pole_position, 0.0, 5.0 * kDegree)
        << load.inertia << " kg m2, " << load.coulomb_friction << " N m";
    EXPECT_LT(trial.travel, 30.0 * kDegree);
  }
}

TEST(PoleTest, WaitsForAShaftThatSwingsWithAnElasticLoad) {
  const MachineData& machine = preset("1fk7063");
  for (const double frequency : {30.0, 60.0, 100.0, 200.0}) {
    const double reduced = 0.5 * machine.inertia;  // of rotor and load, which are alike
    const double w = 2.0 * std::numbers::pi * frequency;
    Load load{.inertia = machine.inertia, .coulomb_friction = 0.02 * machine.rated_torque};
    load.coupling = {.stiffness = reduced * w * w, .damping = 2.0 * 0.05 * reduced * w};
    StandstillTrial trial{real_train(machine, {}, load)};

    trial.run(task_for(machine));

    EXPECT_EQ(trial.measurement.state(), MeasurementState::Done) << frequency << " Hz";
    EXPECT_NEAR(trial.result().pole_position, 0.0, 5.0 * kDegree) << frequency << " Hz";
  }
}

TEST(RotorAlignment, TurnsARotorThatNoEncoderSeesIntoItsPlace) {
  MachineData machine = preset("1fk7063");
  machine.encoder.type = EncoderType::None;
  for (const double degrees : {-170.0, -90.0, -20.0, 0.0, 45.0, 135.0, 180.0}) {
    StandstillTrial trial{real_train(machine, {})};
    misplace_encoder(trial.train, degrees * kDegree / machine.pole_pairs);

    trial.run(task_for(machine));

    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << degrees;
    EXPECT_NEAR(trial.result().stator_resistance / machine.stator_resistance, 1.0, 0.02) << degrees;
    EXPECT_NEAR(trial.result().d_inductance / machine.synchronous.d_inductance, 1.0, 0.03) << degrees;
    EXPECT_NEAR(trial.result().q_inductance / machine.synchronous.q_inductance, 1.0, 0.03) << degrees;
    EXPECT_LT(trial.travel, kServoTravel) << degrees;
  }
}

}  // namespace
}  // namespace motor
