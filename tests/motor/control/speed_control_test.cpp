// Speed control with encoder, for every machine with the settings that p0340 computes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motor/reference/trial.hpp"

namespace motor {
namespace {

/// Time in which the machine reaches @p speed with room for flux and voltage.
double run_up_time(const MachineData& machine, double speed) {
  return 0.5 + 3.0 * 2.0 * machine.inertia * speed / machine.rated_torque;
}

class SpeedControl : public testing::TestWithParam<NamedMachine> {
 protected:
  const MachineData& machine() const { return GetParam().data; }
};

TEST_P(SpeedControl, ReachesEverySpeedWithLittleOvershootAndSettles) {
  for (const double share : {0.05, 0.5, 1.0}) {
    Trial run{machine(), ControlMode::Encoder};
    run.go(0.5);  // an induction machine builds up its flux
    const double target = share * machine().rated_speed;

    run.go_to(target, run_up_time(machine(), target));

    EXPECT_LT(run.highest - target, 0.01 * machine().rated_speed) << share;
    EXPECT_NEAR(run.train.signals().true_speed, target, 5e-4 * machine().rated_speed) << share;
    EXPECT_LT(run.current, 1.1 * std::numbers::sqrt2 * machine().maximum_current) << share;
  }
}

TEST_P(SpeedControl, RecoversFromALoadStep) {
  Trial run{machine(), ControlMode::Encoder};
  run.go_to(0.5 * machine().rated_speed, 0.5 + run_up_time(machine(), machine().rated_speed));

  run.train.set_load_torque(machine().rated_torque);
  run.go(0.5);

  const double target = 0.5 * machine().rated_speed;
  EXPECT_LT(run.lowest, target - 1e-4 * target);
  EXPECT_GT(run.lowest, target - 0.05 * machine().rated_speed);
  EXPECT_NEAR(run.train.signals().true_speed, target, 1e-3 * machine().rated_speed);
  EXPECT_NEAR(run.train.signals().torque_setpoint, machine().rated_torque, 0.1 * machine().rated_torque);
  EXPECT_FALSE(run.train.signals().torque_limit_reached);
}

TEST_P(SpeedControl, ReversesFromRatedSpeedWithinTheCurrentLimit) {
  Trial run{machine(), ControlMode::Encoder};
  run.go_to(machine().rated_speed, 0.5 + run_up_time(machine(), machine().rated_speed));

  run.go_to(-machine().rated_speed, 3.0 * run_up_time(machine(), machine().rated_speed));

  EXPECT_NEAR(run.train.signals().true_speed, -machine().rated_speed, 1e-3 * machine().rated_speed);
  EXPECT_GT(run.lowest, -1.01 * machine().rated_speed);
  EXPECT_LT(run.current, 1.15 * std::numbers::sqrt2 * machine().maximum_current);
}

TEST_P(SpeedControl, HoldsATorqueLimitFlat) {
  Trial run{machine(), ControlMode::Encoder};
  run.go(0.5);
  run.command.limits = {0.5 * machine().rated_torque, -0.5 * machine().rated_torque};
  run.go_to(machine().rated_speed, 5e-3);  // the current has followed
  const double before = run.train.signals().true_speed;

  double highest = 0.0;
  double lowest = 1e9;
  constexpr int kSteps = 80;
  for (int i = 0; i < kSteps; ++i) {
    run.go(kControlPeriod);
    highest = std::max(highest, run.train.signals().true_torque);
    lowest = std::min(lowest, run.train.signals().true_torque);
    EXPECT_TRUE(run.train.signals().torque_limit_reached);
  }

  const double limit = 0.5 * machine().rated_torque;
  EXPECT_LT(highest, 1.01 * limit);
  EXPECT_GT(lowest, 0.98 * limit);
  const double slope = (limit - machine().coulomb_friction) / (2.0 * machine().inertia);
  EXPECT_NEAR(run.train.signals().true_speed - before, slope * kSteps * kControlPeriod,
              0.05 * slope * kSteps * kControlPeriod);
}

TEST_P(SpeedControl, WeakensTheFieldUpToTheHighestSpeedOfTheMotor) {
  Trial run{machine(), ControlMode::Encoder};
  const double target = std::min(machine().maximum_speed, 3.0 * machine().rated_speed);

  run.go_to(target, 1.0 + 3.0 * run_up_time(machine(), target));

  const Signals& now = run.train.signals();
  EXPECT_NEAR(now.true_speed, target, 1e-3 * target);
  EXPECT_LT(run.highest, 1.01 * target);
  EXPECT_FALSE(now.voltage_limited);
  EXPECT_NEAR(now.voltage, 0.95 * kDcVoltage / std::numbers::sqrt3, 0.02 * kDcVoltage);
  EXPECT_LT(now.torque_limits.upper, 0.95 * machine().maximum_torque);
}

TEST_P(SpeedControl, FeedsTheEnergyOfTheMassesBackWhileItBrakes) {
  Trial run{machine(), ControlMode::Encoder};
  run.go_to(machine().rated_speed, 0.5 + run_up_time(machine(), machine().rated_speed));
  const double kinetic = run.train.stored().kinetic;
  run.command.limits = {machine().rated_torque, -machine().rated_torque};

  run.go_to(0.1 * machine().rated_speed, 2.0 * machine().inertia * machine().rated_speed / machine().rated_torque);

  EXPECT_LT(run.energy, -0.3 * kinetic);
  EXPECT_GT(run.energy, -kinetic);
}

TEST_P(SpeedControl, DrawsFromTheLinkWhatMachineAndInverterTake) {
  Trial run{machine(), ControlMode::Encoder};
  double taken = 0.0;
  double stored = -run.train.stored().sum();
  double drawn = 0.0;
  run.command.speed_setpoint = machine().rated_speed;

  for (int i = 0; i < 12000; ++i) {
    if (i == 8000) run.command.speed_setpoint = -0.5 * machine().rated_speed;
    drawn += run.train.step(kDcVoltage, run.command);
    const PlantEnergies& energies = run.train.energies();
    taken += energies.copper + energies.iron + energies.friction + energies.load + run.train.inverter_losses();
  }
  stored += run.train.stored().sum();

  EXPECT_NEAR(drawn, taken + stored, 1e-4 * (taken + stored));
  EXPECT_GT(run.train.inverter_losses(), 20.0 * kControlPeriod);
}

TEST_P(SpeedControl, EmptiesTheControllersWithThePulsesOff) {
  Trial run{machine(), ControlMode::Encoder, {.constant_torque = 0.5 * machine().rated_torque}};
  run.go_to(0.2 * machine().rated_speed, 1.0);
  run.train.set_load_torque(0.0);
  run.command.pulses_enabled = false;
  run.go(0.02);

  EXPECT_EQ(run.train.signals().torque_setpoint, 0.0);
  EXPECT_EQ(run.train.signals().torque, 0.0);
  EXPECT_EQ(run.train.signals().voltage, 0.0);
  EXPECT_EQ(run.train.signals().current, 0.0);
  EXPECT_FALSE(run.train.signals().torque_limit_reached);
}

TEST_P(SpeedControl, TakesOverASpinningShaftWithoutAJerk) {
  Trial run{machine(), ControlMode::Encoder};
  run.go_to(0.7 * machine().rated_speed, 0.5 + run_up_time(machine(), machine().rated_speed));
  run.command.pulses_enabled = false;
  run.go(0.05);
  const double speed = run.train.signals().measured_speed;
  run.command.pulses_enabled = true;

  run.go_to(speed, 0.5);

  EXPECT_LT(run.highest, speed + 0.01 * machine().rated_speed);
  EXPECT_GT(run.lowest, speed - 0.01 * machine().rated_speed);
}

TEST_P(SpeedControl, StaysFiniteAndWithinItsCurrentAtAJammedLoad) {
  Trial run{machine(), ControlMode::Encoder, {.coulomb_friction = 20.0 * machine().maximum_torque}};

  run.go_to(machine().rated_speed, 1.0);

  EXPECT_EQ(run.train.signals().true_speed, 0.0);
  EXPECT_TRUE(run.train.signals().torque_limit_reached);
  EXPECT_LT(run.current, 1.1 * std::numbers::sqrt2 * machine().maximum_current);
}

TEST_P(SpeedControl, StaysFiniteWithALoadThatRunsAway) {
  Trial run{machine(), ControlMode::Encoder};
  run.go_to(0.5 * machine().rated_speed, 0.5);
  run.train.set_load_torque(-3.0 * machine().maximum_torque);

  run.go(0.5);

  EXPECT_TRUE(std::isfinite(run.train.signals().true_speed));
  EXPECT_TRUE(std::isfinite(run.energy));
  EXPECT_TRUE(std::isfinite(run.current));
  EXPECT_GT(run.highest, 0.6 * machine().rated_speed);
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, SpeedControl, testing::ValuesIn(machines()), name_of);

class InductionMachineControl : public testing::TestWithParam<NamedMachine> {};

TEST_P(InductionMachineControl, BuildsUpItsFluxBeforeItGivesTorque) {
  Trial run{GetParam().data, ControlMode::Encoder};
  run.command.speed_setpoint = 0.5 * GetParam().data.rated_speed;
  double time = 0.0;
  double flux = 0.0;

  while (!run.train.signals().magnetised && time < 2.0) {
    EXPECT_EQ(run.train.signals().torque_setpoint, 0.0);
    EXPECT_LT(std::abs(run.train.signals().true_speed), 0.005 * GetParam().data.rated_speed);
    EXPECT_GE(run.train.signals().flux, flux);
    flux = run.train.signals().flux;
    run.go(1e-3);
    time += 1e-3;
  }

  EXPECT_GT(time, 0.02);
  EXPECT_LT(time, 0.5);
  run.go(0.05);
  EXPECT_GT(run.train.signals().true_speed, 0.02 * GetParam().data.rated_speed);
  EXPECT_NEAR(run.train.plant_state().flux, run.train.signals().flux, 0.05 * run.train.signals().flux);
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, InductionMachineControl,
                         testing::ValuesIn(machines(MachineType::Induction)), name_of);

}  // namespace
}  // namespace motor
