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
using identification::kVectorTravel;
using identification::preset;
using identification::real_train;
using identification::StandstillTrial;
using identification::task_for;

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

}  // namespace
}  // namespace motor
