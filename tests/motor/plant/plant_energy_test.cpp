#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/motor/reference/machines.hpp"
#include "tests/motor/reference/plant_runner.hpp"

namespace motor {
namespace {

/// A load in proportion to a machine, by its name.
struct LoadCase {
  const char* name;
  Load (*made)(const MachineData& machine, double torque);
};

constexpr LoadCase kLoads[] = {
    {"a mass", [](const MachineData& m, double) { return Load{.inertia = m.inertia}; }},
    {"a fan with dry friction",
     [](const MachineData& m, double torque) {
       return Load{.inertia = m.inertia,
                   .coulomb_friction = 0.05 * torque,
                   .viscous_friction = 0.05 * torque / m.rated_speed,
                   .breakaway_torque = 0.1 * torque,
                   .fan_coefficient = 0.2 * torque / (m.rated_speed * m.rated_speed)};
     }},
    {"a hoist", [](const MachineData& m,
                   double torque) { return Load{.inertia = 2.0 * m.inertia, .constant_torque = 0.3 * torque}; }},
    {"a pendulum",
     [](const MachineData& m, double torque) {
       return Load{.inertia = 2.0 * m.inertia, .pendulum_torque = 0.2 * torque};
     }},
    {"a profile",
     [](const MachineData& m, double torque) {
       Load load{.inertia = m.inertia};
       load.profile.points = {{{0.0, 0.0}, {0.1, 0.3 * torque}, {0.13, -0.2 * torque}, {0.2, 0.0}}};
       load.profile.count = 4;
       load.profile.repeats = true;
       return load;
     }},
    {"an elastic coupling",
     [](const MachineData& m, double torque) {
       const double stiffness = m.inertia * 500.0 * 500.0;
       return Load{.inertia = 2.0 * m.inertia,
                   .coulomb_friction = 0.05 * torque,
                   .coupling = {.stiffness = stiffness, .damping = 2e-5 * stiffness}};
     }},
    {"a coupling with play",
     [](const MachineData& m, double torque) {
       const double stiffness = m.inertia * 500.0 * 500.0;
       return Load{.inertia = 2.0 * m.inertia,
                   .coulomb_friction = 0.05 * torque,
                   .constant_torque = 0.1 * torque,
                   .coupling = {.stiffness = stiffness, .damping = 2e-5 * stiffness, .backlash = 0.02}};
     }},
};

/// Torque that a machine can carry on for long, from its data (N·m).
double usual_torque(const MachineData& m) {
  if (m.type == MachineType::Synchronous)
    return 1.5 * m.pole_pairs * m.synchronous.magnet_flux * std::sqrt(2.0) * m.rated_current;
  const double leakage = m.induction.stator_leakage + m.induction.rotor_leakage;
  return 0.3 * 1.5 * m.pole_pairs * 0.9 / leakage / 2.0;  // share of the breakdown torque at a flux of 0.95 V·s
}

class PlantEnergy : public testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(PlantEnergy, IsAccountedForInStartLoadBrakingReversalAndCoasting) {
  const auto& [name, machine] = machines::all()[static_cast<std::size_t>(std::get<0>(GetParam()))];
  const LoadCase& load_case = kLoads[std::get<1>(GetParam())];
  SCOPED_TRACE(std::string{name} + " with " + load_case.name);
  const double torque = usual_torque(machine);
  const Load load = load_case.made(machine, torque);
  PlantRunner runner{machine, load};
  const auto expect_balance = [&runner](const char* phase) {
    EXPECT_NEAR(runner.missing() / runner.taken(), 0.0, 1e-4) << phase << ", " << runner.taken() << " J taken";
  };

  runner.run(0.8 * machine.rated_speed, 0.6);
  expect_balance("start");
  EXPECT_GT(runner.state().speed, 0.5 * machine.rated_speed);
  runner.plant().set_load_torque(load.constant_torque + 0.3 * torque);
  runner.run(0.8 * machine.rated_speed, 0.2);
  expect_balance("load");
  runner.plant().set_load_torque(load.constant_torque);
  runner.run(0.1 * machine.rated_speed, 0.5);
  expect_balance("braking");
  runner.run(-0.8 * machine.rated_speed, 0.8);
  expect_balance("reversal");
  EXPECT_LT(runner.state().speed, -0.4 * machine.rated_speed);
  runner.coast(560.0, 0.3);
  expect_balance("coasting");
}

INSTANTIATE_TEST_SUITE_P(EveryMachineAndLoad, PlantEnergy,
                         testing::Combine(testing::Range(0, static_cast<int>(machines::all().size())),
                                          testing::Range(0, static_cast<int>(std::size(kLoads)))));

TEST(PlantEnergyFlow, BrakingGivesEnergyBackThroughTheTerminals) {
  PlantRunner runner{MachineData{}, {.inertia = 0.005}};
  runner.run(300.0, 0.5);
  const double kinetic = runner.plant().stored().kinetic;
  const double before = runner.used().electrical;

  runner.run(0.0, 0.5);

  EXPECT_LT(runner.used().electrical - before, -0.5 * kinetic);
  EXPECT_GT(runner.used().electrical - before, -kinetic);
}

TEST(PlantEnergyFlow, AStopAtAWallLosesTheMotionInItsDamper) {
  PlantRunner runner{MachineData{},
                     {.inertia = 0.005, .end_stops = {.upper = 30.0, .stiffness = 3e3, .damping = 3.0}}};

  runner.run(100.0, 1.0);

  EXPECT_NEAR(runner.missing() / runner.taken(), 0.0, 1e-4);
  EXPECT_EQ(runner.state().revolutions, 4);  // 30 rad, and a little into the wall
  EXPECT_NEAR(runner.state().rotor_angle + 8.0 * std::numbers::pi, 30.0, 0.1);
}

TEST(PlantEnergyFlow, SaturationNeitherMakesNorLosesEnergyAtTheMaximumCurrent) {
  MachineData machine{};
  machine.synchronous.torque_saturation = 0.25;
  machine.synchronous.d_inductance = 4e-3;
  PlantRunner runner{machine, {.inertia = 0.02}};

  runner.run(300.0, 0.3);
  runner.run(-300.0, 0.5);

  EXPECT_NEAR(runner.missing() / runner.taken(), 0.0, 1e-4);
}

/// Where a control hunts, the current jumps through the bend of saturation, with and against the field.
TEST(PlantEnergyFlow, SaturationNeitherMakesNorLosesEnergyWhileTheCurrentJumps) {
  const MachineData machine{};
  Plant plant{machine, {.inertia = 0.008}};
  plant.set_brake(false);
  const double gain = 0.7 * machine.synchronous.d_inductance / kControlPeriod;
  std::mt19937 random{5};
  std::uniform_real_distribution<double> angle{0.0, 2.0 * std::numbers::pi};
  double missing = plant.stored().sum();
  double taken = 0.0;
  for (int step = 0; step < 16000; ++step) {
    const double towards = angle(random);
    plant.step(gain * (35.0 * SpaceVector{std::cos(towards), std::sin(towards)} - plant.state().current));
    const PlantEnergies& e = plant.energies();
    missing += e.electrical - e.copper - e.iron - e.friction - e.load;
    taken += std::abs(e.electrical);
  }

  EXPECT_NEAR((missing - plant.stored().sum()) / taken, 0.0, 1e-4) << taken << " J taken";
}

}  // namespace
}  // namespace motor
