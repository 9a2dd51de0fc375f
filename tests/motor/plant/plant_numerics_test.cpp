#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "motor/math/rotation.hpp"
#include "motor/plant/substeps.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/motor/reference/machines.hpp"
#include "tests/motor/reference/plant_runner.hpp"

namespace motor {
namespace {

constexpr double kMinute = 60.0;

/// Angle since the start (rad).
double total_angle(const PlantState& state) {
  return state.rotor_angle + static_cast<double>(state.revolutions) * 2.0 * std::numbers::pi;
}

/// Speeds, torques and currents of a start, a load step and a reversal.
std::vector<std::array<double, 3>> trace(const MachineData& machine, int substeps) {
  const Load load{.inertia = machine.inertia, .coulomb_friction = 0.1, .breakaway_torque = 0.2};
  PlantRunner runner{machine, load, substeps};
  std::vector<std::array<double, 3>> rows;
  for (int i = 0; i < 1000; ++i) {
    if (i == 500) runner.plant().set_load_torque(0.5);
    const double speed = i < 600 ? 0.9 * machine.rated_speed : -0.9 * machine.rated_speed;
    runner.run(speed, 1e-3);
    rows.push_back({runner.state().speed, runner.state().torque, length(runner.state().current)});
  }
  return rows;
}

class EveryMachine : public testing::TestWithParam<int> {
 protected:
  const machines::Named& named() const { return machines::all()[static_cast<std::size_t>(GetParam())]; }
};

TEST_P(EveryMachine, ChangesByLessThanHalfAPerCentWhenTheStepIsHalved) {
  SCOPED_TRACE(named().name);
  const int usual = needed_substeps(named().data, {.inertia = named().data.inertia});
  const auto coarse = trace(named().data, usual);
  const auto fine = trace(named().data, 2 * usual);

  for (std::size_t quantity = 0; quantity < 3; ++quantity) {
    const auto less = [quantity](const auto& a, const auto& b) { return a[quantity] < b[quantity]; };
    const auto [low, high] = std::minmax_element(fine.begin(), fine.end(), less);
    const double range = (*high)[quantity] - (*low)[quantity];
    for (std::size_t i = 0; i < fine.size(); ++i)
      ASSERT_NEAR(coarse[i][quantity], fine[i][quantity], 0.005 * range)
          << "quantity " << quantity << ", row " << i;
  }
}

TEST_P(EveryMachine, NeedsOneStepAControlPeriod) {
  EXPECT_EQ(needed_substeps(named().data, {.inertia = named().data.inertia}), 1) << named().name;
}

TEST_P(EveryMachine, StaysFiniteUnderAnyVoltageAndLoad) {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  const unsigned seed =
      given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
  SCOPED_TRACE(std::string{named().name} + ", AXISD_TEST_SEED=" + std::to_string(seed));
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> any{-1.0, 1.0};
  const MachineData& machine = named().data;
  for (const double stiffness : {0.0, 2000.0}) {
    Plant plant{
        machine,
        {.inertia = machine.inertia, .coupling = {.stiffness = stiffness, .damping = 0.05, .backlash = 0.01}}};
    plant.set_brake(false);
    SpaceVector voltage{};
    for (int i = 0; i < 40000; ++i) {
      if (i % 16 == 0) {
        voltage = 323.0 * SpaceVector{any(random), any(random)};
        plant.set_load_torque(100.0 * any(random));
      }
      if (i % 4096 == 0) plant.set_temperatures(200.0 * std::abs(any(random)), 150.0 * std::abs(any(random)));
      if (i % 5000 < 4000)
        plant.step(voltage);
      else
        plant.coast(560.0 * std::abs(any(random)));
      ASSERT_TRUE(std::isfinite(plant.state().speed) && std::isfinite(plant.state().load_speed) &&
                  std::isfinite(norm(plant.state().current)) && std::isfinite(plant.energies().electrical));
      ASSERT_LT(std::abs(plant.state().torque), 1e6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryMachine, testing::Range(0, static_cast<int>(machines::all().size())));

TEST(PlantNumerics, NothingDriftsInTwentyMinutesOfSteadyRunning) {
  PlantRunner runner{MachineData{}, {.inertia = 0.003, .constant_torque = 3.0}};
  runner.run(200.0, kMinute);
  const PlantState early = runner.state();

  runner.run(200.0, 10.0 * kMinute);
  const PlantState between = runner.state();
  runner.run(200.0, 10.0 * kMinute);

  const PlantState& late = runner.state();
  EXPECT_NEAR(late.speed / early.speed, 1.0, 1e-9);
  EXPECT_NEAR(late.torque / early.torque, 1.0, 1e-9);
  EXPECT_NEAR(length(late.current) / length(early.current), 1.0, 1e-9);
  const double first = total_angle(between) - total_angle(early);
  EXPECT_NEAR((total_angle(late) - total_angle(between)) / first, 1.0, 1e-10);
  EXPECT_NEAR(first / (early.speed * 10.0 * kMinute), 1.0, 1e-7);  // the speed ripples within a control period
}

TEST(PlantNumerics, TheAngleOfAShaftThatNothingBrakesIsExactAfterAnHour) {
  Plant plant{{.coulomb_friction = 0.0, .viscous_friction = 0.0}, {}};
  plant.set_speed(100.0);

  for (int i = 0; i < 8000 * 60; ++i) plant.coast(560.0);

  EXPECT_EQ(plant.state().speed, 100.0);
  EXPECT_NEAR(total_angle(plant.state()), 100.0 * kMinute, 1e-8);
}

TEST(PlantNumerics, AShaftThatRunsAwayEndsAtAFiniteSpeed) {
  for (const bool induction : {false, true}) {
    Plant plant{{.type = induction ? MachineType::Induction : MachineType::Synchronous},
                {.constant_torque = 500.0}};
    plant.set_brake(false);
    for (int i = 0; i < 40000; ++i) plant.coast(560.0);
    EXPECT_LT(plant.state().speed, -1000.0);
    EXPECT_TRUE(std::isfinite(plant.state().speed));
    EXPECT_TRUE(std::isfinite(norm(plant.state().current)));
  }
}

TEST(PlantNumerics, AStepAllocatesNothing) {
  std::vector<PlantRunner> runners;
  for (const machines::Named& machine : machines::all()) runners.emplace_back(machine.data, Load{});
  const auto before = fakes::allocations();

  for (PlantRunner& runner : runners) {
    runner.run(100.0, 0.5);
    runner.coast(560.0, 0.5);
    runner.plant().set_temperatures(80.0, 60.0);
    runner.plant().set_load_torque(1.0);
  }

  EXPECT_EQ(fakes::allocations(), before);
}

TEST(PlantNumerics, TheDirectionOfARotorIsRightAtMaximumSpeed) {
  for (const auto& [name, machine] : machines::all()) {
    if (machine.type == MachineType::Induction) continue;  // the stator frame needs none
    PlantRunner runner{machine, {.inertia = 1e6}};
    runner.plant().set_speed(machine.maximum_speed);
    for (int i = 0; i < 200; ++i) {
      runner.run(machine.maximum_speed, kControlPeriod);
      const double angle = machine.pole_pairs * runner.state().rotor_angle;
      ASSERT_NEAR(runner.plant().direction().re, std::cos(angle), 5e-7) << name;
      ASSERT_NEAR(runner.plant().direction().im, std::sin(angle), 5e-7) << name;
    }
  }
}

TEST(Rotation, AgreesWithTheMathematicalLibrary) {
  for (int i = -20000; i <= 20000; ++i) {
    const double angle = 1.234e-3 * i;
    EXPECT_NEAR(unit_vector(angle).re, std::cos(angle), 3e-15) << angle;
    EXPECT_NEAR(unit_vector(angle).im, std::sin(angle), 3e-15) << angle;
  }
  EXPECT_NEAR(unit_vector(999.9).re, std::cos(999.9), 1e-13);
}

TEST(Rotation, OfASmallAngleIsAsExactAsItSays) {
  for (const double angle : {-0.3, -0.1, 0.0, 0.2, 0.3}) {
    EXPECT_NEAR(small_rotation(angle)[0], std::cos(angle), 2e-9);
    EXPECT_NEAR(small_rotation(angle)[1], std::sin(angle), 2e-9);
  }
  EXPECT_NEAR(small_rotation(0.6)[0], std::cos(0.6), 5e-7);
}

}  // namespace
}  // namespace motor
