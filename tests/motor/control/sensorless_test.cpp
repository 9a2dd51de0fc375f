// Machines that run without encoder: sensorless speed control and V/f control.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/fakes/allocation_counter.hpp"
#include "tests/motor/reference/trial.hpp"

namespace motor {
namespace {

class Sensorless : public testing::TestWithParam<NamedMachine> {
 protected:
  const MachineData& machine() const { return GetParam().data; }
  /// Slope that reaches the rated speed in a second (rad/s²).
  double slope() const { return machine().rated_speed; }
  double current_limit() const { return std::numbers::sqrt2 * machine().maximum_current; }
};

TEST_P(Sensorless, StartsAndHoldsEverySpeedFromATenthToTheRatedOne) {
  Trial run{machine(), ControlMode::Sensorless};
  run.go(0.5);
  for (const double share : {0.1, 0.15, 0.5, 1.0}) {
    const double target = share * machine().rated_speed;

    run.ramp_to(target, slope(), 1.5);

    EXPECT_NEAR(run.train.signals().true_speed, target, 0.01 * machine().rated_speed) << share;
    EXPECT_NEAR(run.train.signals().measured_speed, run.train.signals().true_speed, 0.005 * machine().rated_speed)
        << share;
    EXPECT_LT(run.highest, target + 0.05 * machine().rated_speed) << share;
    EXPECT_LT(run.current, 1.1 * current_limit()) << share;
  }
}

TEST_P(Sensorless, CarriesTheRatedTorqueAboveTheChangeover) {
  for (const double share : {0.25, 1.0}) {
    Trial run{machine(), ControlMode::Sensorless};
    run.go(0.5);
    const double target = share * machine().rated_speed;
    run.ramp_to(target, slope(), 1.5);
    run.train.set_load_torque(machine().rated_torque);

    run.go(1.5);

    EXPECT_LT(run.lowest, 0.9999 * target) << share;
    EXPECT_NEAR(run.train.signals().true_speed, target, 5e-3 * machine().rated_speed) << share;
    EXPECT_NEAR(run.train.signals().torque, machine().rated_torque, 0.15 * machine().rated_torque) << share;
  }
}

TEST_P(Sensorless, ReversesThroughStandstillAndBack) {
  Trial run{machine(), ControlMode::Sensorless};
  run.go(0.5);
  run.ramp_to(machine().rated_speed, slope(), 1.5);

  run.ramp_to(-machine().rated_speed, slope(), 3.0);
  EXPECT_NEAR(run.train.signals().true_speed, -machine().rated_speed, 5e-3 * machine().rated_speed);
  EXPECT_GT(run.lowest, -1.05 * machine().rated_speed);

  run.ramp_to(machine().rated_speed, slope(), 3.0);
  EXPECT_NEAR(run.train.signals().true_speed, machine().rated_speed, 5e-3 * machine().rated_speed);
  EXPECT_LT(run.current, 1.2 * current_limit());

  run.ramp_to(0.0, slope(), 2.0);
  EXPECT_NEAR(run.train.signals().true_speed, 0.0, 0.01 * machine().rated_speed);
}

TEST_P(Sensorless, WorksWithAHotMachineThoughTheControlKnowsTheColdOne) {
  MachineData hot = machine();
  const double rate = 3.0 * hot.stator_resistance * hot.rated_current * hot.rated_current / 40.0;
  hot.thermal = {
      .winding_capacity = rate, .frame_capacity = rate, .winding_to_frame = rate, .frame_to_ambient = rate};
  Trial run{hot, ControlMode::Sensorless};
  run.go(0.5);
  run.ramp_to(0.5 * hot.rated_speed, slope(), 1.5);
  run.train.set_load_torque(0.8 * hot.rated_torque);

  run.go(10.0);

  EXPECT_GT(run.train.signals().winding_temperature, 50.0);
  EXPECT_NEAR(run.train.signals().true_speed, 0.5 * hot.rated_speed, 0.015 * hot.rated_speed);
}

TEST_P(Sensorless, NeverSeesTheShaft) {
  Trial run{machine(), ControlMode::Sensorless, {.coulomb_friction = 20.0 * machine().maximum_torque}};
  run.go(0.5);

  run.ramp_to(0.05 * machine().rated_speed, slope(), 0.5);

  EXPECT_EQ(run.train.signals().true_speed, 0.0);  // jammed, and below the changeover nothing tells
  EXPECT_GT(run.train.signals().measured_speed, 0.04 * machine().rated_speed);
  run.ramp_to(machine().rated_speed, slope(), 3.0);
  EXPECT_TRUE(std::isfinite(run.train.signals().measured_speed));
  EXPECT_LT(run.current, 1.3 * current_limit());
}

TEST_P(Sensorless, StaysFiniteWithALoadThatRunsAway) {
  Trial run{machine(), ControlMode::Sensorless};
  run.go(0.5);
  run.ramp_to(0.5 * machine().rated_speed, slope(), 1.0);
  run.train.set_load_torque(-3.0 * machine().maximum_torque);

  run.go(0.5);

  EXPECT_TRUE(std::isfinite(run.train.signals().measured_speed));
  EXPECT_TRUE(std::isfinite(run.train.signals().true_speed));
  EXPECT_TRUE(std::isfinite(run.energy));
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, Sensorless, testing::ValuesIn(machines()), name_of);

class VoltageFrequency : public Sensorless {};

TEST_P(VoltageFrequency, RunsUpAndReverses) {
  Trial run{machine(), ControlMode::VoltageFrequency};
  run.go(0.5);
  run.ramp_to(0.9 * machine().rated_speed, slope(), 2.0);
  EXPECT_NEAR(run.train.signals().true_speed, 0.9 * machine().rated_speed, 0.005 * machine().rated_speed);
  EXPECT_NEAR(run.train.signals().measured_speed, run.train.signals().true_speed, 0.005 * machine().rated_speed);

  run.ramp_to(-0.9 * machine().rated_speed, slope(), 3.0);

  EXPECT_NEAR(run.train.signals().true_speed, -0.9 * machine().rated_speed, 0.005 * machine().rated_speed);
}

TEST_P(VoltageFrequency, StaysFiniteAtAJammedLoadAndLimitsTheCurrent) {
  Trial run{machine(), ControlMode::VoltageFrequency, {.coulomb_friction = 20.0 * machine().maximum_torque}};

  run.ramp_to(machine().rated_speed, slope(), 2.0);

  EXPECT_EQ(run.train.signals().true_speed, 0.0);
  EXPECT_LT(run.current, 2.0 * current_limit());
  if (machine().type == MachineType::Induction) {
    EXPECT_TRUE(run.train.signals().torque_limit_reached);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, VoltageFrequency, testing::ValuesIn(machines()), name_of);

class SlipCompensation : public testing::TestWithParam<NamedMachine> {};

TEST_P(SlipCompensation, TakesMostOfTheSlipAway) {
  const MachineData& machine = GetParam().data;
  double slip[2] = {};
  for (const int compensated : {0, 1}) {
    Trial run{machine, ControlMode::VoltageFrequency};
    ControlSettings settings = run.train.settings();
    settings.voltage_frequency.slip_compensation = compensated;
    run.train.tune(settings);
    run.ramp_to(0.7 * machine.rated_speed, machine.rated_speed, 1.5);
    run.train.set_load_torque(0.8 * machine.rated_torque);
    run.go(2.0);
    slip[compensated] = 0.7 * machine.rated_speed - run.train.signals().true_speed;
  }

  EXPECT_GT(slip[0], 0.01 * machine.rated_speed);
  EXPECT_LT(std::abs(slip[1]), 0.4 * slip[0]);
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, SlipCompensation, testing::ValuesIn(machines(MachineType::Induction)),
                         name_of);

TEST(VoltageFrequencyControl, TheBoostGivesTheTorqueToStart) {
  const MachineData machine = machines(MachineType::Induction).front().data;
  double speed[2] = {};
  for (const int boosted : {0, 1}) {
    Trial run{machine, ControlMode::VoltageFrequency, {.coulomb_friction = 0.9 * machine.rated_torque}};
    ControlSettings settings = run.train.settings();
    settings.voltage_frequency.boost = boosted * 30.0;
    run.train.tune(settings);
    run.go(0.5);
    run.ramp_to(0.05 * machine.rated_speed, machine.rated_speed, 1.0);
    speed[boosted] = run.train.signals().true_speed;
  }

  EXPECT_LT(speed[0], 0.01 * machine.rated_speed);
  EXPECT_GT(speed[1], 0.03 * machine.rated_speed);
}

class EveryMode : public testing::TestWithParam<ControlMode> {};

TEST_P(EveryMode, SurvivesALinkThatCollapsesAndComesBack) {
  for (const NamedMachine& machine : machines()) {
    Trial run{machine.data, GetParam()};
    run.go(0.5);
    run.ramp_to(0.6 * machine.data.rated_speed, machine.data.rated_speed, 1.0);

    for (int i = 0; i < 800; ++i) run.train.step(i < 400 ? 540.0 - 1.35 * i : 0.0, run.command);
    for (int i = 0; i < 400; ++i) run.train.step(1.35 * i, run.command);
    run.command.pulses_enabled = false;  // as the undervoltage would have done
    run.go(0.1);
    run.command.pulses_enabled = true;
    run.command.speed_setpoint = 0.0;
    run.go(3.0);

    EXPECT_TRUE(std::isfinite(run.energy)) << machine.name;
    EXPECT_LT(std::abs(run.train.signals().true_speed), 0.25 * machine.data.rated_speed) << machine.name;
  }
}

TEST_P(EveryMode, AllocatesNothing) {
  for (const NamedMachine& machine : machines()) {
    Trial run{machine.data, GetParam()};
    const auto before = fakes::allocations();

    run.ramp_to(0.3 * machine.data.rated_speed, machine.data.rated_speed, 0.5);
    run.command.pulses_enabled = false;
    run.go(0.1);
    run.train.rest(1.0);
    run.train.tune(run.train.settings());

    EXPECT_EQ(fakes::allocations(), before) << machine.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryMode,
                         testing::Values(ControlMode::VoltageFrequency, ControlMode::Sensorless,
                                         ControlMode::Encoder));

TEST(VdcMaxController, CutsTheGeneratingTorqueWhenTheLinkRises) {
  const MachineData machine{};
  Trial run{machine, ControlMode::Encoder};
  ControlSettings settings = run.train.settings();
  settings.vdc_max = 770.0;
  run.train.tune(settings);
  run.go_to(machine.rated_speed, 1.0);
  run.command.speed_setpoint = 0.0;

  for (int i = 0; i < 8; ++i) run.train.step(760.0, run.command);
  EXPECT_NEAR(run.train.signals().torque_limits.lower, -0.5 * run.train.signals().torque_limits.upper, 1.0);
  for (int i = 0; i < 80; ++i) run.train.step(775.0, run.command);

  EXPECT_EQ(run.train.signals().torque_setpoint, 0.0);
  EXPECT_NEAR(run.train.signals().true_torque, 0.0, 0.01 * machine.maximum_torque);
  EXPECT_TRUE(run.train.signals().torque_limit_reached);
}

}  // namespace
}  // namespace motor
