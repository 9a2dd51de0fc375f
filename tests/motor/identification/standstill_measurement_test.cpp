#include "motor/identification/standstill_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/induction_circuit.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/motor/identification/standstill_trial.hpp"

namespace motor {
namespace {

using identification::kDegree;
using identification::preset;
using identification::real_train;
using identification::StandstillTrial;
using identification::task_for;

constexpr double kServoTravel = 210.0 * kDegree;
constexpr double kVectorTravel = 90.0 * kDegree;

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

/// Something wrong with a machine, and what must come of it.
struct Wrong {
  const char* name;
  const char* preset;
  StandstillFault fault;
  Load load{};
  EncoderDefect defect = EncoderDefect::None;
  double dc_voltage = identification::kDcVoltage;
  PlantDeviation deviation{};
  void (*spoil)(StandstillTask&) = [](StandstillTask&) {};
};
/// How GoogleTest names a case.
void PrintTo(const Wrong& wrong, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << wrong.name;
}

class StandstillFaults : public testing::TestWithParam<Wrong> {};

TEST_P(StandstillFaults, EndTheMeasurementWithThePulsesWithoutVoltage) {
  const Wrong& wrong = GetParam();
  const MachineData& machine = preset(wrong.preset);
  StandstillTrial trial{real_train(machine, wrong.deviation, wrong.load)};
  if (wrong.load.brake.torque > 0.0) {
    trial.train.set_brake(true);
    identification::pass(trial.train, {}, 0.2);
  }
  if (wrong.defect != EncoderDefect::None) trial.train.inject(wrong.defect);
  trial.dc_voltage = wrong.dc_voltage;
  StandstillTask task = task_for(machine);
  wrong.spoil(task);
  const bool servo = machine.type == MachineType::Synchronous;
  task.largest_travel = servo ? kServoTravel : kVectorTravel;

  trial.run(task);

  EXPECT_EQ(trial.measurement.state(), MeasurementState::Failed);
  EXPECT_EQ(trial.measurement.fault(), wrong.fault);
  EXPECT_LT(trial.travel, task.largest_travel);
  EXPECT_LE(trial.current, std::sqrt(2.0) * task_for(machine).settings.current_limit);
  Signals signals;
  EXPECT_EQ(trial.measurement.step({.current = {1.0, 0.0}, .dc_voltage = 540.0}, signals), SpaceVector{});
  RecordProperty("duration_ms", static_cast<int>(1e3 * trial.duration));
  RecordProperty("travel_degrees", static_cast<int>(trial.travel / kDegree));
}

constexpr double kHighBrakeTorque = 1e3;  // N·m

INSTANTIATE_TEST_SUITE_P(
    Of, StandstillFaults,
    testing::Values(Wrong{.name = "brake closed",
                          .preset = "1fk7063",
                          .fault = StandstillFault::PolePosition,
                          .load = {.brake = {.torque = kHighBrakeTorque}}},
                    Wrong{.name = "too much friction",
                          .preset = "1fk7042",
                          .fault = StandstillFault::PolePosition,
                          .load = {.coulomb_friction = 4.0}},
                    Wrong{.name = "encoder reversed",
                          .preset = "1fk7063",
                          .fault = StandstillFault::PolePosition,
                          .defect = EncoderDefect::Reversed},
                    Wrong{.name = "encoder without signals",
                          .preset = "1ft7044",
                          .fault = StandstillFault::PolePosition,
                          .defect = EncoderDefect::Loss},
                    Wrong{.name = "weight on a servo",
                          .preset = "1fk7063",
                          .fault = StandstillFault::ShaftTurns,
                          .load = {.constant_torque = 5.0}},
                    Wrong{.name = "weight on an induction machine",
                          .preset = "1ph8131",
                          .fault = StandstillFault::ShaftTurns,
                          .load = {.constant_torque = -20.0}},
                    Wrong{.name = "no DC link",
                          .preset = "1fk7063",
                          .fault = StandstillFault::VoltageLimited,
                          .dc_voltage = 0.0},
                    Wrong{.name = "low DC link, servo",
                          .preset = "1fk7063",
                          .fault = StandstillFault::VoltageLimited,
                          .dc_voltage = 10.0},
                    Wrong{.name = "low DC link, induction machine",
                          .preset = "1le1003-2k2",
                          .fault = StandstillFault::VoltageLimited,
                          .dc_voltage = 30.0},
                    Wrong{.name = "current limit far below the rated current",
                          .preset = "1ph8131",
                          .fault = StandstillFault::CurrentLimit,
                          .spoil = [](StandstillTask& task) { task.settings.current_limit = 3.0; }},
                    Wrong{.name = "resistance far beyond that of the data sheet",
                          .preset = "1fk7042",
                          .fault = StandstillFault::StatorResistance,
                          .deviation = {.stator_resistance = 25.0}},
                    Wrong{.name = "plate of another servo",
                          .preset = "1fk7063",
                          .fault = StandstillFault::StatorResistance,
                          .spoil = [](StandstillTask& task) { task.machine.rated_voltage = 3.0; }},
                    Wrong{.name = "frequency of another servo",
                          .preset = "1fk7063",
                          .fault = StandstillFault::StatorReactance,
                          .spoil = [](StandstillTask& task) { task.machine.rated_frequency = 4000.0; }},
                    Wrong{.name = "open rotor",
                          .preset = "1le1003-2k2",
                          .fault = StandstillFault::RotorTimeConstant,
                          .deviation = {.rotor_resistance = 30.0}},
                    Wrong{.name = "frequency of another induction machine",
                          .preset = "1le1003-2k2",
                          .fault = StandstillFault::Leakage,
                          .spoil = [](StandstillTask& task) { task.machine.rated_frequency = 10.0; }},
                    Wrong{.name = "wide air gap",
                          .preset = "1ph8131",
                          .fault = StandstillFault::MainReactance,
                          .deviation = {.magnetising_inductance = 0.2}}),
    [](const auto& row) {
      std::string name = row.param.name;
      std::erase_if(name, [](char c) { return c == ','; });
      std::ranges::replace(name, ' ', '_');
      return name;
    });

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
  StandstillTrial trial{real_train(machine, {}, {.brake = {.torque = kHighBrakeTorque}})};
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
