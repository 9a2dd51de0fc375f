// What p1910 = 3 finds of the saturation of random induction machines.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "motor/identification/model/field_model.hpp"
#include "tests/motor/identification/standstill_trial.hpp"

namespace motor {
namespace {

using identification::StandstillTrial;

constexpr int kPlants = 20;

class StandstillCurve : public testing::TestWithParam<const char*> {};

TEST_P(StandstillCurve, IsThatOfTheMachine) {
  const MachineData& data_sheet = identification::preset(GetParam());
  const double rated = std::numbers::sqrt2 * data_sheet.induction.magnetising_current;
  std::mt19937_64 random{identification::plant_seed()};
  double worst = 0.0, duration = 0.0;
  for (int plant = 0; plant < kPlants; ++plant) {
    SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(identification::plant_seed()) + ", plant " +
                 std::to_string(plant));
    const PlantDeviation deviation = identification::random_deviation(random);
    StandstillTrial trial{identification::real_train(data_sheet, deviation)};
    StandstillTask task = identification::task_for(data_sheet);
    task.finds_curve = true;
    trial.run(task);
    ASSERT_EQ(trial.measurement.state(), MeasurementState::Done)
        << "fault " << static_cast<int>(trial.measurement.fault()) << " after " << trial.duration << " s";
    const InductionCircuit real = induction_circuit(real_machine(data_sheet, deviation));
    const SaturationCurve& curve = trial.result().curve;
    for (std::size_t i = 0; i < curve.flux.size(); ++i) {
      const double flux = standing_flux(real, curve.magnetising_current[i] * rated);
      worst = std::max(worst, std::abs(curve.flux[i] * rated_flux(data_sheet) / flux - 1.0));
    }
    InductionCircuit fitted = real;
    fitted.magnetising_inductance = curve.fitted_magnetising_inductance;
    fitted.saturation_flux = curve.fitted_saturation_flux;
    for (const double share : {0.3, 0.6, 1.0, 1.3})
      worst = std::max(worst,
                       std::abs(standing_flux(fitted, share * rated) / standing_flux(real, share * rated) - 1.0));
    duration = std::max(duration, trial.duration);
    EXPECT_LT(trial.travel, 1.0 * identification::kDegree) << "a direct current turns nothing";
  }
  std::printf("| %s | %.1f %% | %.0f s |\n", GetParam(), 100.0 * worst, duration);
  EXPECT_LT(worst, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Presets, StandstillCurve, testing::Values("1le1003-2k2", "1ph8131", "im-2k2"));

}  // namespace
}  // namespace motor
