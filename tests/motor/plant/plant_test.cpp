#include "motor/plant/plant.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "tests/motor/reference/plant_runner.hpp"

namespace motor {
namespace {

constexpr double kLink = 560.0;  // V

MachineData frictionless() {
  return {.inertia = 0.002, .coulomb_friction = 0.0, .viscous_friction = 0.0};
}

void coast(Plant& plant, double seconds, double voltage = kLink) {
  const auto steps = std::lround(seconds / kControlPeriod);
  for (std::int64_t i = 0; i < steps; ++i) plant.coast(voltage);
}

/// A plant whose shaft turns at @p speed, its brake open.
Plant turning(const MachineData& machine, const Load& load, double speed) {
  Plant plant{machine, load};
  plant.set_brake(false);
  coast(plant, load.brake.torque > 0.0 ? load.brake.opening_time + kControlPeriod : 0.0);
  plant.set_speed(speed);
  return plant;
}

TEST(Plant, CoastsDownUnderDryFrictionLinearlyAndStandsExactlyStill) {
  MachineData machine = frictionless();
  machine.coulomb_friction = 0.1;
  Plant plant = turning(machine, {}, 100.0);

  coast(plant, 1.0);
  EXPECT_NEAR(plant.state().speed, 100.0 - 0.1 / 0.002, 1e-9);
  EXPECT_FALSE(plant.rests());
  coast(plant, 1.001);

  EXPECT_EQ(plant.state().speed, 0.0);
  EXPECT_TRUE(plant.rests());
}

TEST(Plant, CoastsDownUnderDryAndViscousFrictionAndIronLossesAsTheExactSolutionSays) {
  MachineData machine = frictionless();
  machine.coulomb_friction = 0.06;
  machine.hysteresis_torque = 0.04;
  machine.viscous_friction = 0.003;
  machine.eddy_current_drag = 0.001;
  Plant plant = turning(machine, {}, 200.0);

  coast(plant, 0.6);

  const double tail = 0.1 / 0.004;  // w(t) = (w0 + T/B) exp(-B t/J) - T/B
  EXPECT_NEAR(plant.state().speed, (200.0 + tail) * std::exp(-0.004 / 0.002 * 0.6) - tail, 1e-6);
}

TEST(Plant, SlowsDownHyperbolicallyWithAFan) {
  Plant plant = turning(frictionless(), {.fan_coefficient = 1e-5}, 300.0);

  coast(plant, 1.0);

  EXPECT_NEAR(plant.state().speed, 300.0 / (1.0 + 1e-5 / 0.002 * 300.0), 1e-6);
}

TEST(Plant, AHoistFallsFreelyWithoutBrakeAndNeverCreepsWithIt) {
  const Load hoist{.inertia = 0.003, .constant_torque = hoist_torque(10.0, 0.05), .brake = {.torque = 8.0}};
  Plant held{frictionless(), hoist};
  Plant fallen = turning(frictionless(), hoist, 0.0);

  coast(held, 60.0);
  coast(fallen, 0.1);

  EXPECT_EQ(held.state().speed, 0.0);
  EXPECT_EQ(held.state().rotor_angle, 0.0);
  EXPECT_TRUE(held.rests());
  EXPECT_NEAR(fallen.state().speed, -hoist.constant_torque / 0.005 * 0.1, 0.02);
}

TEST(Plant, TheBrakeActsAfterItsTimesAndStopsAFallingLoad) {
  const Load hoist{.constant_torque = 2.0, .brake = {.torque = 8.0, .opening_time = 0.1, .closing_time = 0.05}};
  Plant plant{frictionless(), hoist};
  plant.set_brake(false);

  coast(plant, 0.0995);
  EXPECT_EQ(plant.state().speed, 0.0);
  EXPECT_FALSE(plant.rests());
  coast(plant, 0.1005);
  EXPECT_NEAR(plant.state().speed, -100.0, 0.5);
  plant.set_brake(true);
  coast(plant, 0.0495);
  EXPECT_NEAR(plant.state().speed, -149.5, 0.5);
  coast(plant, 0.052);

  EXPECT_EQ(plant.state().speed, 0.0);
  EXPECT_TRUE(plant.rests());
}

TEST(Plant, StaticFrictionHoldsMoreThanTurningFrictionBrakes) {
  const Load load{.inertia = 0.001, .coulomb_friction = 0.5, .breakaway_torque = 1.5, .stribeck_speed = 2.0};
  Plant plant = turning(frictionless(), load, 0.0);

  plant.set_load_torque(-1.49);
  coast(plant, 1.0);
  EXPECT_EQ(plant.state().speed, 0.0);
  plant.set_load_torque(-1.51);
  coast(plant, 0.5);
  const double moving = plant.state().speed;
  EXPECT_GT(moving, 10.0);
  coast(plant, 0.2);

  // Once it moves, the excess of the static friction is gone.
  EXPECT_NEAR(plant.state().speed - moving, (1.51 - 0.5) / 0.003 * 0.2, 1e-6);
}

TEST(Plant, APendulumSwingsWithItsPeriod) {
  constexpr double kTorque = 2.0;
  Plant plant = turning(frictionless(), {.inertia = 0.018, .pendulum_torque = kTorque}, 0.1);
  const double period = 2.0 * std::numbers::pi * std::sqrt(0.02 / kTorque);

  coast(plant, 0.25 * period);
  EXPECT_NEAR(plant.state().rotor_angle, 0.1 * std::sqrt(0.02 / kTorque), 1e-5);
  EXPECT_NEAR(plant.state().speed, 0.0, 1e-3);
  coast(plant, 10.75 * period);

  EXPECT_NEAR(plant.state().speed, 0.1, 1e-4);
}

TEST(Plant, FollowsAProfileOverTimeAgainAndAgain) {
  Load load{};
  load.profile.points = {{{0.0, 0.0}, {0.5, 4.0}, {1.0, 0.0}}};
  load.profile.count = 3;
  load.profile.repeats = true;
  MachineData machine = frictionless();
  machine.maximum_speed = 5000.0;
  Plant plant = turning(machine, load, 5000.0);

  coast(plant, 0.5, 1e5);
  EXPECT_NEAR(plant.state().speed, 5000.0 - 1.0 / 0.002, 1e-6);
  coast(plant, 4.5, 1e5);

  EXPECT_NEAR(plant.state().speed, 5000.0 - 5.0 * 2.0 / 0.002, 1e-6);
}

TEST(Plant, AProfileThatJumpsDoesSoAtItsTime) {
  Load load{};
  load.profile.points = {{{0.0, 1.0}, {0.1, 1.0}, {0.1, -1.0}}};
  load.profile.count = 3;
  Plant plant = turning(frictionless(), load, 100.0);

  coast(plant, 0.1);
  EXPECT_NEAR(plant.state().speed, 50.0, 1e-9);
  coast(plant, 0.1);

  EXPECT_NEAR(plant.state().speed, 100.0, 1e-9);
}

TEST(Plant, AWallStopsTheLoadAndThrowsItBackSlower) {
  Plant plant = turning(frictionless(), {.end_stops = {.upper = 1.0, .stiffness = 1e4, .damping = 2.0}}, 50.0);

  coast(plant, 0.019);
  EXPECT_NEAR(plant.state().speed, 50.0, 1e-9);
  coast(plant, 0.011);

  EXPECT_LT(plant.state().speed, -5.0);
  EXPECT_GT(plant.state().speed, -45.0);
  EXPECT_LT(plant.state().rotor_angle, 1.0);
}

TEST(Plant, PlayLetsTheRotorTurnAloneUntilItMeetsTheLoad) {
  const Load load{
      .inertia = 0.002, .coulomb_friction = 0.01, .coupling = {.stiffness = 1e3, .damping = 0.5, .backlash = 0.2}};
  PlantRunner runner{frictionless(), load};
  runner.run(10.0, 0.005);
  ASSERT_GT(runner.state().twist, 0.01);
  ASSERT_LT(runner.state().twist, 0.1);
  EXPECT_EQ(runner.state().load_speed, 0.0);

  runner.run(10.0, 0.5);

  EXPECT_NEAR(runner.state().load_speed, 10.0, 0.1);
  EXPECT_GT(runner.state().twist, 0.1);
}

TEST(Plant, TwoMassesOnAStiffCouplingMoveAsOne) {
  const MachineData machine = frictionless();
  Plant two = turning(
      machine, {.inertia = 0.004, .constant_torque = 1.2, .coupling = {.stiffness = 5e3, .damping = 1.0}}, 100.0);
  Plant one = turning(machine, {.inertia = 0.004, .constant_torque = 1.2}, 100.0);

  coast(two, 0.3);
  coast(one, 0.3);

  EXPECT_NEAR(two.state().speed, one.state().speed, 0.01);
  EXPECT_NEAR(two.state().load_speed, one.state().speed, 0.01);
  EXPECT_NEAR(two.state().twist, 1.2 * 0.002 / 0.006 / 5e3, 1e-6);
}

TEST(Plant, EachOfTwoMassesStandsStillOnItsOwn) {
  const Load load{.inertia = 0.002, .coulomb_friction = 3.0, .coupling = {.stiffness = 100.0, .damping = 0.1}};
  MachineData machine = frictionless();
  machine.coulomb_friction = 0.5;
  Plant plant{machine, load};

  for (int i = 0; i < 4000; ++i) plant.step({0.0, 1.2});

  EXPECT_EQ(plant.state().load_speed, 0.0);
  EXPECT_EQ(plant.state().speed, 0.0);
  EXPECT_GT(plant.state().twist, 1e-3);
}

}  // namespace
}  // namespace motor
