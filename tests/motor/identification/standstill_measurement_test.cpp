#include "motor/identification/standstill/standstill_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/data/rating_plate.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/motor/identification/standstill_trial.hpp"

namespace motor {
namespace {

using identification::preset;
using identification::real_train;
using identification::StandstillTrial;
using identification::task_for;

TEST(RandomPlants, AreMadeOfAllDeliveredMotors) {
  EXPECT_EQ(identification::presets().size(), 7U);
  std::mt19937_64 random{identification::plant_seed()};
  const PlantDeviation one = identification::random_deviation(random);
  EXPECT_NE(one, identification::random_deviation(random));
}

TEST(StandstillMeasurement, DoesNothingBeforeItIsStartedAndAfterItsEnd) {
  StandstillMeasurement measurement;
  Signals signals;
  EXPECT_EQ(measurement.state(), MeasurementState::Idle);
  EXPECT_EQ(measurement.step({.dc_voltage = 540.0}, signals), SpaceVector{});

  StandstillTrial trial{real_train(preset("1fk7063"), {})};
  trial.run(task_for(preset("1fk7063")));

  ASSERT_EQ(trial.measurement.state(), MeasurementState::Done);
  EXPECT_EQ(trial.measurement.step({.current = {1.0, 0.0}, .dc_voltage = 540.0}, signals), SpaceVector{});
}

TEST(StandstillMeasurement, FindsADoubledResistanceDoubled) {
  for (const char* const name : {"1fk7063", "1ph8131"}) {
    const MachineData& machine = preset(name);
    StandstillTrial trial{real_train(machine, {.stator_resistance = 2.0})};

    trial.run(task_for(machine));

    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << name;
    EXPECT_NEAR(trial.result().stator_resistance, 2.0 * machine.stator_resistance,
                0.02 * 2.0 * machine.stator_resistance)
        << name;
  }
}

TEST(StandstillMeasurement, FindsInductancesHalvedAndDoubled) {
  const MachineData& machine = preset("1fk7063");
  StandstillTrial trial{real_train(machine, {.d_inductance = 0.5, .q_inductance = 2.0})};

  trial.run(task_for(machine));

  ASSERT_EQ(trial.measurement.state(), MeasurementState::Done);
  EXPECT_NEAR(trial.result().d_inductance / machine.synchronous.d_inductance, 0.5, 0.015);
  EXPECT_NEAR(trial.result().q_inductance / machine.synchronous.q_inductance, 2.0, 0.06);
}

TEST(StandstillMeasurement, FindsWhatEachPhaseLosesToDeadTimeAndValves) {
  for (const char* const name : {"1fk7063", "1ft7044", "1ph8131"}) {
    StandstillTrial trial{real_train(preset(name), {})};

    trial.run(task_for(preset(name)));

    EXPECT_NEAR(trial.result().threshold_voltage, 1.5e-6 * 8e3 * identification::kDcVoltage + 1.0, 0.1) << name;
  }
}

TEST(StandstillMeasurement, ReducesTheResistanceOfAHotWindingToTheTemperatureOfTheData) {
  for (const char* const name : {"1fk7063", "1le1003-2k2"}) {
    MachineData machine = preset(name);
    machine.thermal.ambient = 100.0;
    StandstillTrial trial{real_train(machine, {})};
    trial.train.rest(1e5);
    StandstillTask task = task_for(machine);
    task.winding_temperature = trial.train.signals().winding_temperature;
    ASSERT_NEAR(task.winding_temperature, 100.0, 0.1);

    trial.run(task);

    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << name;
    EXPECT_NEAR(trial.result().stator_resistance / machine.stator_resistance, 1.0, 0.02) << name;
    if (machine.type == MachineType::Induction) {
      EXPECT_NEAR(trial.result().rotor_resistance / induction_circuit(machine).rotor_resistance, 1.0, 0.05);
    }
  }
}

TEST(StandstillMeasurement, StartsFromTheRatingPlateOfAnInductionMachineAlone) {
  for (const char* const name : {"1le1003-2k2", "1ph8131", "im-2k2"}) {
    const MachineData believed = circuit_from_plate(preset(name));
    const InductionCircuit truth = induction_circuit(preset(name));
    DriveTrain train{believed, preset(name), {}, identification::real_inverter(believed)};
    train.use_sensors(true);
    StandstillTrial trial{std::move(train)};

    trial.run(task_for(believed));

    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << name;
    EXPECT_NEAR(trial.result().stator_resistance / truth.stator_resistance, 1.0, 0.02) << name;
    EXPECT_NEAR(trial.result().leakage / truth.leakage, 1.0, 0.03) << name;
    EXPECT_NEAR(trial.result().rotor_resistance / truth.rotor_resistance, 1.0, 0.05) << name;
    EXPECT_NEAR(trial.result().magnetising_inductance / truth.magnetising_inductance, 1.0, 0.05) << name;
  }
}

TEST(StandstillMeasurement, BearsAPowerUnitOfTwiceTheSizeAndOneWithoutLosses) {
  for (const identification::Preset& row : identification::presets()) {
    InverterData big = inverter_of(2.0 * row.machine.maximum_current);
    big.dead_time = 1.5e-6;
    big.forward_voltage = 1.0;
    for (const InverterData& inverter : {big, inverter_for(row.machine.maximum_current)}) {
      DriveTrain train{row.machine, row.machine, {}, inverter};
      train.use_sensors(true);
      StandstillTrial trial{std::move(train)};

      trial.run(task_for(row.machine));

      ASSERT_EQ(trial.measurement.state(), MeasurementState::Done) << row.name;
      const MachineData found = identified_machine(row.machine, trial.result());
      EXPECT_NEAR(found.stator_resistance / row.machine.stator_resistance, 1.0, 0.02) << row.name;
      EXPECT_NEAR(found.synchronous.d_inductance / row.machine.synchronous.d_inductance, 1.0, 0.03) << row.name;
      EXPECT_NEAR(found.synchronous.q_inductance / row.machine.synchronous.q_inductance, 1.0, 0.03) << row.name;
      EXPECT_NEAR(found.induction.magnetising_inductance / row.machine.induction.magnetising_inductance, 1.0, 0.05)
          << row.name;
    }
  }
}

TEST(StandstillMeasurement, KeepsItsCurrentsBelowALowLimit) {
  for (const identification::Preset& row : identification::presets()) {
    StandstillTask task = task_for(row.machine);
    task.settings.current_limit = 0.6 * row.machine.rated_current;
    StandstillTrial trial{real_train(row.machine, {})};

    trial.run(task);

    EXPECT_EQ(trial.measurement.state(), MeasurementState::Done) << row.name;
    EXPECT_LE(trial.current, std::sqrt(2.0) * task.settings.current_limit) << row.name;
    EXPECT_NEAR(trial.result().stator_resistance / row.machine.stator_resistance, 1.0, 0.02) << row.name;
  }
}

TEST(StandstillMeasurement, DoesNotNeedTheShaftOfAnInductionMachine) {
  const MachineData& machine = preset("1ph8131");
  StandstillTrial trial{real_train(machine, {}, {.brake = {.torque = 1e3}})};
  trial.train.set_brake(true);
  identification::pass(trial.train, {}, 0.2);

  trial.run(task_for(machine));

  EXPECT_EQ(trial.measurement.state(), MeasurementState::Done);
  EXPECT_EQ(trial.travel, 0.0);
}

TEST(StandstillMeasurement, ShowsWhatItDoesAndTheCurrentsInTheRotorFrame) {
  using namespace measurement_step;
  StandstillTrial servo{real_train(preset("1fk7063"), {})};
  const double rated = std::sqrt(2.0) * preset("1fk7063").rated_current;

  double along = 0.0;
  servo.run(task_for(preset("1fk7063")), [&] {
    const Signals& seen = servo.train.signals();
    if (servo.measurement.progress() == kDeadTime) along = std::max(along, seen.d_current_setpoint);
    EXPECT_EQ(seen.torque, 0.0);
    EXPECT_FALSE(seen.magnetised);
  });

  EXPECT_EQ(servo.progress, (std::set<std::uint16_t>{kEncoderTest, kSaliency, kCircuit, kStatorResistance,
                                                     kDeadTime, kStandstill}));
  EXPECT_NEAR(along, rated, 0.01 * rated);
  StandstillTrial induction{real_train(preset("1ph8131"), {})};
  induction.run(task_for(preset("1ph8131")));
  EXPECT_EQ(induction.progress, (std::set<std::uint16_t>{kLeakage, kRotorTimeConstant, kCircuit, kStatorResistance,
                                                         kDeadTime, kStandstill}));
}

TEST(StandstillMeasurement, CanBeStartedAgain) {
  const MachineData& machine = preset("1fk7063");
  StandstillTrial trial{real_train(machine, {})};
  trial.dc_voltage = 0.0;
  trial.run(task_for(machine));
  ASSERT_EQ(trial.measurement.state(), MeasurementState::Failed);
  identification::pass(trial.train, {}, 0.1);
  trial.dc_voltage = identification::kDcVoltage;

  trial.run(task_for(machine));

  EXPECT_EQ(trial.measurement.state(), MeasurementState::Done);
  EXPECT_EQ(trial.measurement.fault(), StandstillFault::None);
}

TEST(StandstillMeasurement, AllocatesNothing) {
  for (const char* const name : {"1fk7063", "1ph8131"}) {
    const StandstillTask task = task_for(preset(name));
    DriveTrain train = real_train(preset(name), {});
    StandstillMeasurement measurement;
    train.lead_by(&measurement);
    const std::uint64_t before = fakes::allocations();

    measurement.start(task);
    while (measurement.state() == MeasurementState::Running) train.step(540.0, {.pulses_enabled = true});

    EXPECT_EQ(fakes::allocations(), before) << name;
    EXPECT_EQ(measurement.state(), MeasurementState::Done) << name;
  }
}

TEST(IdentifiedMachine, HasTheCircuitThatWasFound) {
  for (const identification::Preset& row : identification::presets()) {
    const StandstillResult result{.stator_resistance = 1.1 * row.machine.stator_resistance,
                                  .d_inductance = 4e-3,
                                  .q_inductance = 6e-3,
                                  .rotor_resistance = 0.7,
                                  .leakage = 13e-3,
                                  .magnetising_inductance = 120e-3};

    const MachineData found = identified_machine(row.machine, result);

    EXPECT_EQ(found.stator_resistance, result.stator_resistance);
    EXPECT_EQ(found.inertia, row.machine.inertia);
    if (found.type == MachineType::Synchronous) {
      EXPECT_EQ(found.synchronous.d_inductance, result.d_inductance);
      EXPECT_EQ(found.synchronous.q_inductance, result.q_inductance);
      continue;
    }
    const InductionCircuit circuit = induction_circuit(found);
    EXPECT_NEAR(circuit.rotor_resistance, result.rotor_resistance, 1e-12);
    EXPECT_NEAR(circuit.leakage, result.leakage, 1e-12);
    EXPECT_NEAR(circuit.magnetising_inductance, result.magnetising_inductance, 1e-12);
    EXPECT_NEAR(found.induction.stator_leakage / found.induction.rotor_leakage,
                row.machine.induction.stator_leakage / row.machine.induction.rotor_leakage, 1e-12);
    EXPECT_EQ(found.induction.saturation_flux, row.machine.induction.saturation_flux);
  }
}

}  // namespace
}  // namespace motor
