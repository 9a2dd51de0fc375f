#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "motor/control/field/induction_circuit.hpp"
#include "tests/motor/identification/standstill_trial.hpp"

namespace motor {
namespace {

using identification::Preset;
using identification::StandstillTrial;

constexpr int kPlants = 20;

/// A quantity, what it is in truth, and how wrong it may be.
struct Quantity {
  std::string_view name;
  MachineType type;
  double StandstillResult::*found;
  double (*truth)(const MachineData&);
  double tolerance;
};

constexpr std::array kQuantities{
    Quantity{"R_s (%)", MachineType::Synchronous, &StandstillResult::stator_resistance,
             [](const MachineData& m) { return m.stator_resistance; }, 0.02},
    Quantity{"L_d (%)", MachineType::Synchronous, &StandstillResult::d_inductance,
             [](const MachineData& m) { return m.synchronous.d_inductance; }, 0.03},
    Quantity{"L_q (%)", MachineType::Synchronous, &StandstillResult::q_inductance,
             [](const MachineData& m) { return m.synchronous.q_inductance; }, 0.03},
    Quantity{"R_s (%)", MachineType::Induction, &StandstillResult::stator_resistance,
             [](const MachineData& m) { return m.stator_resistance; }, 0.02},
    Quantity{"L_sgm (%)", MachineType::Induction, &StandstillResult::leakage,
             [](const MachineData& m) { return induction_circuit(m).leakage; }, 0.03},
    Quantity{"R_R (%)", MachineType::Induction, &StandstillResult::rotor_resistance,
             [](const MachineData& m) { return induction_circuit(m).rotor_resistance; }, 0.05},
    Quantity{"L_M (%)", MachineType::Induction, &StandstillResult::magnetising_inductance,
             [](const MachineData& m) { return induction_circuit(m).magnetising_inductance; }, 0.05},
};

/// As a row of the table in docs/explanation/physics.md.
void print_row(std::string_view preset, std::string_view quantity, double worst) {
  std::cout << "| " << preset << " | " << quantity << " | " << std::fixed << std::setprecision(2) << worst
            << " |\n";
}

class StandstillAccuracy : public testing::TestWithParam<Preset> {
 protected:
  /// Measures @p machine at a random electrical angle and remembers what was worst.
  void measure(const PlantDeviation& deviation, double turned) {
    const Preset& preset = GetParam();
    StandstillTrial trial{identification::turned_train(preset.machine, deviation, turned)};

    trial.run(identification::task_for(preset.machine));

    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done)
        << "fault " << static_cast<int>(trial.measurement.fault()) << " after " << trial.duration << " s";
    const MachineData real = real_machine(preset.machine, deviation);
    for (const Quantity& quantity : kQuantities) {
      if (quantity.type != real.type) continue;
      const double error = std::abs(trial.result().*quantity.found / quantity.truth(real) - 1.0);
      EXPECT_LT(error, quantity.tolerance) << quantity.name;
      note(quantity.name, 100.0 * error);
    }
    EXPECT_LT(std::abs(trial.result().pole_position), 5.0 * identification::kDegree);
    note("pole position (deg)", std::abs(trial.result().pole_position) / identification::kDegree);
    note("travel (deg)", trial.travel / identification::kDegree);
    note("duration (s)", trial.duration);
    note("current (% of rated)", 100.0 * trial.current / (std::sqrt(2.0) * preset.machine.rated_current));
  }
  void note(std::string_view name, double value) { worst_[name] = std::max(worst_[name], value); }

  std::map<std::string_view, double> worst_;
};

TEST_P(StandstillAccuracy, IsThatOfTheFactsForAnySpecimen) {
  const std::uint64_t seed = identification::plant_seed();
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> angle{0.0, 2.0 * std::numbers::pi};
  for (int plant = 0; plant < kPlants; ++plant) {
    SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed) + ", plant " + std::to_string(plant));
    const PlantDeviation deviation = identification::random_deviation(random);
    measure(deviation, angle(random));
  }
  for (const auto& [name, value] : worst_) print_row(GetParam().name, name, value);
}

INSTANTIATE_TEST_SUITE_P(Presets, StandstillAccuracy, testing::ValuesIn(identification::presets()),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::ranges::replace(name, '-', '_');
                           return "Of" + name;
                         });

}  // namespace
}  // namespace motor
