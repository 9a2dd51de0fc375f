// What loads that are set from outside do to a shaft: how fast it gets, and what holds it.
#include <cmath>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "tests/motor/reference/machines.hpp"
#include "tests/motor/reference/plant_runner.hpp"

namespace motor {
namespace {

constexpr double kLink = 560.0;  // V

void coast(Plant& plant, double seconds) {
  const auto steps = std::lround(seconds / kControlPeriod);
  for (std::int64_t i = 0; i < steps; ++i) plant.coast(kLink);
}

class Runaway : public testing::TestWithParam<int> {
 protected:
  const machines::Named& named() const { return machines::all()[static_cast<std::size_t>(GetParam())]; }
  const MachineData& machine() const { return named().data; }
  double pull() const { return 20.0 * machine().maximum_torque; }
};

TEST_P(Runaway, NoLoadTurnsAShaftWithoutPulsesFasterThanItsRotorHolds) {
  PlantRunner runner{machine(), {.constant_torque = pull()}};
  for (int i = 0; i < 400; ++i) {
    runner.coast(kLink, 0.01);
    ASSERT_LE(std::abs(runner.state().speed), bursting_speed(machine())) << named().name;
  }

  EXPECT_EQ(runner.state().speed, -bursting_speed(machine())) << named().name;
  EXPECT_TRUE(runner.plant().is_held_back());
  const double done = std::abs(runner.used().load);
  EXPECT_NEAR(runner.missing(), 0.0, 1e-3 * done) << named().name;
}

TEST_P(Runaway, NorOneWithPulses) {
  PlantRunner runner{machine(), {.inertia = machine().inertia, .constant_torque = -pull()}};
  for (int i = 0; i < 400; ++i) {
    runner.run(0.0, 0.01);
    ASSERT_LE(std::abs(runner.state().speed), bursting_speed(machine())) << named().name;
    ASSERT_TRUE(std::isfinite(norm(runner.state().current))) << named().name;
  }
}

TEST_P(Runaway, NorALoadBehindACoupling) {
  const Load load{.inertia = machine().inertia,
                  .constant_torque = pull(),
                  .coupling = {.stiffness = 2000.0, .damping = 0.05, .backlash = 0.01}};
  Plant plant{machine(), load};
  for (int i = 0; i < 400; ++i) {
    coast(plant, 0.01);
    ASSERT_LE(std::abs(plant.state().speed), bursting_speed(machine())) << named().name;
    ASSERT_LE(std::abs(plant.state().load_speed), bursting_speed(machine())) << named().name;
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, Runaway, testing::Range(0, static_cast<int>(machines::all().size())));

TEST(LoadTorque, AShaftThatALoadHasDrivenComesToRestWhenItIsTakenAway) {
  const Load behind{
      .inertia = 0.001, .coulomb_friction = 0.05, .coupling = {.stiffness = 2000.0, .damping = 0.05}};
  for (const Load& load : {Load{}, behind}) {
    Plant plant{{}, load};
    plant.set_load_torque(50.0);
    coast(plant, 5.0);
    ASSERT_TRUE(plant.is_held_back());

    plant.set_load_torque(0.0);
    coast(plant, 60.0);

    EXPECT_EQ(plant.state().speed, 0.0);
    EXPECT_FALSE(plant.is_held_back());
    EXPECT_TRUE(plant.rests());
  }
}

TEST(LoadTorque, FrictionBrakesEitherDirectionAndNeverDrives) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.0, .viscous_friction = 0.0};
  for (const double speed : {100.0, -100.0}) {
    Plant plant{machine, {}};
    plant.set_speed(speed);
    plant.set_load_torque(0.5, LoadTorqueType::Friction);

    coast(plant, 0.2);
    EXPECT_NEAR(plant.state().speed, std::copysign(100.0 - 0.5 / 0.002 * 0.2, speed), 1e-9);
    coast(plant, 0.2);

    EXPECT_EQ(plant.state().speed, 0.0);
    EXPECT_TRUE(plant.rests());
  }
}

TEST(LoadTorque, TheNextOneTakesThePlaceOfTheLastAndOfTheConfiguredOne) {
  const MachineData machine{.inertia = 0.002, .coulomb_friction = 0.0, .viscous_friction = 0.0};
  for (const double stiffness : {0.0, 2000.0}) {
    Plant plant{machine,
                {.inertia = 0.002,
                 .constant_torque = 1.0,
                 .friction_torque = 5.0,
                 .coupling = {.stiffness = stiffness, .damping = 0.05}}};
    coast(plant, 0.1);
    EXPECT_EQ(plant.state().speed, 0.0) << "the configured friction holds the configured weight";

    plant.set_load_torque(1.0);
    coast(plant, 0.1);
    EXPECT_NEAR(plant.state().speed, -1.0 / 0.004 * 0.1, 0.5) << "nothing is left of the friction";

    plant.set_load_torque(5.0, LoadTorqueType::Friction);
    coast(plant, 1.0);
    EXPECT_NEAR(plant.state().load_speed, 0.0, 1e-12) << "nothing is left of the weight";

    plant.set_load_torque(-1.0);
    coast(plant, 0.1);
    EXPECT_NEAR(plant.state().speed, 1.0 / 0.004 * 0.1, 0.5);
  }
}

TEST(LoadTorque, ABrakeAndAFrictionLoadAddUp) {
  Plant plant{{.coulomb_friction = 0.0, .viscous_friction = 0.0},
              {.constant_torque = 7.0, .friction_torque = 4.0, .brake = {.torque = 4.0, .opening_time = 0.0}}};
  coast(plant, 0.1);
  EXPECT_EQ(plant.state().speed, 0.0);

  plant.set_brake(false);
  coast(plant, 0.01);

  EXPECT_NEAR(plant.state().speed, -3.0 / MachineData{}.inertia * 0.01, 1e-9);
}

}  // namespace
}  // namespace motor
