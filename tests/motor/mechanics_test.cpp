#include "motor/mechanics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr double kStep = 125e-6;

MachineData frictionless() {
  return {.inertia = 0.002, .coulomb_friction = 0.0, .viscous_friction = 0.0};
}

void run(Mechanics& shaft, double torque, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kStep));
  for (int i = 0; i < steps; ++i) shaft.step(kStep, torque);
}

/// A shaft that turns at @p speed, brought there against any friction.
Mechanics turning(const MachineData& machine, const Load& load, double speed) {
  Mechanics shaft{machine, load};
  while (shaft.speed() < speed) shaft.step(1e-6, 1000.0);
  return shaft;
}

TEST(Mechanics, AcceleratesByTorqueOverRotorAndLoadInertia) {
  Mechanics shaft{frictionless(), {.inertia = 0.006}};

  run(shaft, 4.0, 0.5);

  EXPECT_NEAR(shaft.speed(), 4.0 / 0.008 * 0.5, 1e-6);
}

TEST(Mechanics, CoastsDownLinearlyUnderDryFrictionAndStandsExactlyStill) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.1, .viscous_friction = 0.0};
  Mechanics shaft = turning(machine, {}, 100.0);
  const double start = shaft.speed();

  run(shaft, 0.0, 1.0);

  EXPECT_NEAR(shaft.speed(), start - 0.1 / 0.002 * 1.0, 1e-6);
  run(shaft, 0.0, 1.1);
  EXPECT_EQ(shaft.speed(), 0.0);
  EXPECT_TRUE(shaft.rests());
}

TEST(Mechanics, CoastsDownAsTheExactSolutionOfDryAndViscousFrictionSays) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.1, .viscous_friction = 0.004};
  Mechanics shaft = turning(machine, {}, 200.0);
  const double start = shaft.speed();
  const double tail = 0.1 / 0.004;  // w(t) = (w0 + Fc/B) exp(-B t/J) - Fc/B

  run(shaft, 0.0, 0.6);

  const double exact = (start + tail) * std::exp(-0.004 / 0.002 * 0.6) - tail;
  EXPECT_NEAR(shaft.speed(), exact, 0.002 * start);
  const double stops_after = 0.002 / 0.004 * std::log(1.0 + start / tail);
  run(shaft, 0.0, stops_after - 0.6 - 0.005);
  EXPECT_GT(shaft.speed(), 0.0);
  run(shaft, 0.0, 0.010);
  EXPECT_EQ(shaft.speed(), 0.0);
}

TEST(Mechanics, DoesNotCreepUnderALoadBelowTheDryFriction) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.1, .viscous_friction = 0.0};
  Mechanics shaft{machine, {.constant_torque = 0.0999}};

  for (int i = 0; i < 80000; ++i) {
    shaft.step(kStep, 0.0);
    ASSERT_EQ(shaft.speed(), 0.0);
  }

  EXPECT_TRUE(shaft.rests());
}

TEST(Mechanics, StartsToTurnBackwardsUnderALoadAboveTheDryFriction) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.1, .viscous_friction = 0.0};
  Mechanics shaft{machine, {.constant_torque = 0.3}};

  EXPECT_FALSE(shaft.rests());
  run(shaft, 0.0, 0.1);

  EXPECT_NEAR(shaft.speed(), -0.2 / 0.002 * 0.1, 1e-6);
}

TEST(Mechanics, AHoistPullsTheSameWayInBothDirectionsOfRotation) {
  const double torque = hoist_torque(10.0, 0.05);
  EXPECT_NEAR(torque, 4.903, 0.001);
  Mechanics shaft = turning(frictionless(), {.constant_torque = torque}, 50.0);
  const double start = shaft.speed();

  run(shaft, 0.0, 0.1);

  EXPECT_NEAR(shaft.speed(), start - torque / 0.002 * 0.1, 1e-6);
  EXPECT_LT(shaft.speed(), 0.0);
}

TEST(Mechanics, AFanSlowsDownHyperbolically) {
  Mechanics shaft = turning(frictionless(), {.fan_coefficient = 1e-5}, 300.0);
  const double start = shaft.speed();

  run(shaft, 0.0, 1.0);

  EXPECT_NEAR(shaft.speed(), start / (1.0 + 1e-5 / 0.002 * start * 1.0), 0.1);
}

TEST(Mechanics, ComesToRestOnViscousFrictionAloneInTheEnd) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.0, .viscous_friction = 0.01};
  Mechanics shaft = turning(machine, {}, 100.0);

  run(shaft, 0.0, 6.0);

  EXPECT_EQ(shaft.speed(), 0.0);
}

}  // namespace
}  // namespace motor
