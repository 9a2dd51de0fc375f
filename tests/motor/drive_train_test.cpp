#include "motor/drive_train.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr TorqueLimits kFullTorque{35.0, -35.0};
constexpr double kDcVoltage = 540.0;

DriveCommand at_speed(double rpm, TorqueLimits limits = kFullTorque) {
  return {.pulses_enabled = true, .speed_setpoint = rpm * kRpm, .limits = limits};
}

void run(DriveTrain& train, const DriveCommand& command, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kControlPeriod));
  for (int i = 0; i < steps; ++i) train.step(kDcVoltage, command);
}

TEST(DriveTrain, ReachesTheSpeedSetpointAndHoldsItUnderLoad) {
  DriveTrain train{MachineData{}, {.inertia = 0.003, .constant_torque = 5.0}};

  run(train, at_speed(3000.0), 1.0);

  EXPECT_NEAR(train.signals().true_speed, 3000.0 * kRpm, 0.01);
  EXPECT_NEAR(train.signals().measured_speed, 3000.0 * kRpm, 0.02);
  const double friction = 0.1 + 2e-4 * 3000.0 * kRpm;
  EXPECT_NEAR(train.signals().torque, 5.0 + friction, 0.1);
  EXPECT_FALSE(train.signals().torque_limit_reached);
}

TEST(DriveTrain, AcceleratesAtTheTorqueLimitNeitherFasterNorSlower) {
  const MachineData machine{};
  DriveTrain train{machine, {}};

  run(train, at_speed(6000.0, {10.0, -10.0}), 0.05);

  EXPECT_TRUE(train.signals().torque_limit_reached);
  EXPECT_EQ(train.signals().torque_setpoint, 10.0);
  const double free = 10.0 / machine.inertia * 0.05;
  EXPECT_LT(train.signals().true_speed, free);
  EXPECT_GT(train.signals().true_speed, 0.95 * free);
}

struct StepCase {
  double rpm;
  double load_inertia;
  std::uint32_t pulses;
  std::uint8_t fine_bits;
};
/// How GoogleTest names a case.
void PrintTo(const StepCase& c, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << c.rpm << " rpm, load " << c.load_inertia << " kg m2, encoder " << c.pulses << " x 2^"
       << int{c.fine_bits};
}

class SpeedStep : public testing::TestWithParam<StepCase> {};

TEST_P(SpeedStep, OvershootsByLessThanOnePerCentOfRatedSpeedAndSettles) {
  const MachineData machine{.encoder = {.pulses = GetParam().pulses, .fine_bits = GetParam().fine_bits}};
  DriveTrain train{machine, {.inertia = GetParam().load_inertia}};
  const double target = GetParam().rpm * kRpm;
  double highest = 0.0;

  for (int i = 0; i < 16000; ++i) {
    train.step(kDcVoltage, at_speed(GetParam().rpm));
    highest = std::max(highest, train.signals().true_speed);
  }

  EXPECT_LT(highest - target, 0.01 * machine.rated_speed);
  EXPECT_NEAR(train.signals().true_speed, target, 2e-3 * machine.rated_speed);
}

INSTANTIATE_TEST_SUITE_P(SmallAndLarge, SpeedStep,
                         testing::Values(StepCase{50.0, 0.0, 2048, 11}, StepCase{1000.0, 0.0, 2048, 11},
                                         StepCase{3000.0, 0.0, 2048, 11}, StepCase{6000.0, 0.0, 2048, 11},
                                         StepCase{3000.0, 0.015, 2048, 11}, StepCase{3000.0, 0.15, 2048, 11},
                                         StepCase{3000.0, 0.0, 1024, 2}));

TEST(DriveTrain, TheControllerSeesTheEncoderAndNotTheShaft) {
  const MachineData coarse{.encoder = {.pulses = 1024, .fine_bits = 2}};
  DriveTrain train{coarse, {}};
  run(train, at_speed(100.0), 1.0);
  double lowest = 1e9;
  double highest = -1e9;

  for (int i = 0; i < 8000; ++i) {
    train.step(kDcVoltage, at_speed(100.0));
    lowest = std::min(lowest, train.signals().torque_setpoint);
    highest = std::max(highest, train.signals().torque_setpoint);
  }

  EXPECT_GT(highest - lowest, 0.05);  // 12 rad/s an increment cannot go unnoticed
}

TEST(DriveTrain, HasNoTorqueWithThePulsesOffAndCoastsToAnExactStandstill) {
  DriveTrain train{MachineData{}, {}};
  run(train, at_speed(1000.0), 1.0);
  const double start = train.signals().true_speed;

  run(train, {}, 2e-3);  // the currents leave through the diodes
  EXPECT_EQ(train.signals().current, 0.0);
  EXPECT_EQ(train.signals().true_torque, 0.0);
  EXPECT_EQ(train.signals().torque_setpoint, 0.0);
  EXPECT_GT(train.signals().true_speed, 0.99 * start);
  EXPECT_FALSE(train.rests());

  const double tail = 0.1 / 2e-4;
  const double stops_after = 0.00151 / 2e-4 * std::log(1.0 + start / tail);
  run(train, {}, 0.97 * stops_after);
  EXPECT_GT(train.signals().true_speed, 0.0);
  run(train, {}, 0.06 * stops_after);
  EXPECT_EQ(train.signals().true_speed, 0.0);
  EXPECT_TRUE(train.rests());
}

TEST(DriveTrain, DoesNotRememberALoadAcrossAPulseInhibit) {
  DriveTrain train{MachineData{}, {.constant_torque = 10.0}};
  run(train, at_speed(100.0), 1.0);
  train.set_load_torque(0.0);
  run(train, {}, 1.0);
  ASSERT_TRUE(train.rests());

  run(train, at_speed(0.0), 0.1);

  EXPECT_EQ(train.signals().torque_setpoint, 0.0);
  EXPECT_NEAR(train.signals().true_torque, 0.0, 1e-9);
  EXPECT_EQ(train.signals().true_speed, 0.0);
}

TEST(DriveTrain, HoldsAWeightAtZeroSpeedWithoutLettingItSinkOn) {
  DriveTrain train{MachineData{}, {.inertia = 0.002, .constant_torque = hoist_torque(20.0, 0.04)}};
  run(train, at_speed(0.0), 2.0);
  const std::int64_t held = train.signals().encoder_counts;

  run(train, at_speed(0.0), 10.0);

  EXPECT_EQ(train.signals().encoder_counts, held);
  EXPECT_EQ(train.signals().true_speed, 0.0);
}

TEST(DriveTrain, CountsWhatTheShaftHasTurned) {
  const MachineData machine{};
  DriveTrain train{machine, {}};

  for (int i = 0; i < 16000; ++i) {
    train.step(kDcVoltage, at_speed(i < 8000 ? 2000.0 : -500.0));
    const PlantState& state = train.plant_state();
    const double turned = static_cast<double>(state.revolutions) + state.rotor_angle / (2.0 * std::numbers::pi);
    const double expected = turned * increments_per_revolution(machine);
    ASSERT_NEAR(static_cast<double>(train.signals().encoder_counts), expected, 1.01) << i;
  }
}

TEST(DriveTrain, GivesWhatIsCalculatedInOnePeriodInTheNext) {
  DriveTrain train{MachineData{}, {}};

  train.step(kDcVoltage, at_speed(3000.0));
  EXPECT_GT(train.signals().torque_setpoint, 20.0);
  EXPECT_EQ(train.signals().voltage, 0.0);
  EXPECT_EQ(train.signals().true_torque, 0.0);
  train.step(kDcVoltage, at_speed(3000.0));

  EXPECT_NEAR(train.signals().voltage, kDcVoltage / std::numbers::sqrt3, 1.0);
  EXPECT_GT(train.signals().true_torque, 1.0);
}

TEST(DriveTrain, FollowsATorqueSetpointInTorqueControl) {
  DriveTrain train{MachineData{}, {.inertia = 0.05}};
  DriveCommand command{
      .pulses_enabled = true, .torque_control = true, .torque_setpoint = 4.0, .limits = kFullTorque};

  run(train, command, 0.1);

  EXPECT_EQ(train.signals().torque_setpoint, 4.0);
  EXPECT_NEAR(train.signals().true_torque, 4.0, 0.02);
  EXPECT_FALSE(train.signals().torque_limit_reached);
  command.torque_setpoint = 50.0;
  run(train, command, 0.01);
  EXPECT_LT(train.signals().torque_setpoint, 35.1);
  EXPECT_TRUE(train.signals().torque_limit_reached);
}

TEST(DriveTrain, AddsAnAdditionalTorqueInSpeedControl) {
  DriveTrain plain{MachineData{}, {.constant_torque = 5.0}};
  DriveTrain helped{MachineData{}, {.constant_torque = 5.0}};
  DriveCommand command = at_speed(0.0);
  command.additional_torque = 5.0;

  run(plain, at_speed(0.0), 2e-3);
  run(helped, command, 2e-3);

  EXPECT_LT(std::abs(helped.signals().true_speed), 0.5 * std::abs(plain.signals().true_speed));
}

TEST(DriveTrain, LetsThePowerLimitsActWithTheSpeed) {
  DriveTrain train{MachineData{}, {.inertia = 0.01}};
  ControlSettings settings = train.settings();
  settings.motoring_power_limit = 1500.0;
  settings.regenerative_power_limit = -900.0;
  train.tune(settings);
  run(train, at_speed(3000.0), 5.0);
  run(train, at_speed(-3000.0), 2e-3);

  const double speed = train.signals().true_speed;
  EXPECT_NEAR(train.signals().torque_limits.upper, 1500.0 / speed, 0.05 * 1500.0 / speed);
  EXPECT_NEAR(train.signals().torque_limits.lower, -900.0 / speed, 0.05 * 900.0 / speed);
  EXPECT_NEAR(train.signals().torque_setpoint, train.signals().torque_limits.lower, 1e-9);
}

TEST(DriveTrain, PrecontrolTakesTheFollowingErrorAway) {
  double error[2] = {};
  for (const int share : {0, 1}) {
    DriveTrain train{MachineData{}, {.inertia = 0.003}};
    ControlSettings settings = train.settings();
    settings.acceleration_precontrol = share;
    train.tune(settings);
    DriveCommand command = at_speed(0.0);
    command.acceleration_setpoint = 500.0;
    for (int i = 0; i < 1000; ++i) {
      command.speed_setpoint += command.acceleration_setpoint * kControlPeriod;
      train.step(kDcVoltage, command);
    }
    error[share] = command.speed_setpoint - train.signals().true_speed;
  }

  EXPECT_GT(error[0], 1.0);
  EXPECT_LT(std::abs(error[1]), 0.3 * error[0]);
}

TEST(DriveTrain, WarmsWithItsLossesAndCoolsWhileItRests) {
  DriveTrain train{MachineData{}, {.coulomb_friction = 50.0}};
  run(train, at_speed(1000.0, {20.0, -20.0}), 20.0);
  const Signals hot = train.signals();
  EXPECT_GT(hot.winding_temperature, 25.0);
  EXPECT_GT(hot.overload, 0.4);
  EXPECT_GT(hot.heat_sink_temperature, 31.0);
  EXPECT_GT(hot.chip_temperature, hot.heat_sink_temperature + 5.0);
  run(train, {}, 0.1);
  ASSERT_TRUE(train.rests());

  train.rest(10.0 * 3600.0);

  EXPECT_NEAR(train.signals().winding_temperature, 20.0, 0.1);
  EXPECT_NEAR(train.signals().overload, 0.0, 1e-3);
  EXPECT_NEAR(train.signals().heat_sink_temperature, 30.0, 0.1);
}

TEST(DriveTrain, RunsAwayWithAReversedEncoderAndStaysFinite) {
  DriveTrain train{MachineData{}, {}};
  run(train, at_speed(100.0), 0.5);
  train.inject(EncoderDefect::Reversed);

  run(train, at_speed(100.0), 0.5);

  EXPECT_TRUE(train.signals().torque_limit_reached);
  EXPECT_GT(std::abs(train.signals().true_speed - 100.0 * kRpm), 5.0);
  EXPECT_TRUE(std::isfinite(train.signals().true_speed));
}

TEST(DriveTrain, StillControlsAMachineWhoseDataAreNotQuiteRight) {
  DriveTrain train{MachineData{}, {}};
  MachineData believed{};
  believed.stator_resistance *= 0.7;
  believed.synchronous.d_inductance *= 1.3;
  believed.synchronous.q_inductance *= 1.3;
  believed.synchronous.magnet_flux *= 0.9;
  train.set_machine(believed);

  run(train, at_speed(2000.0), 1.0);

  EXPECT_NEAR(train.signals().true_speed, 2000.0 * kRpm, 0.01);
  EXPECT_LT(train.signals().torque, train.signals().true_torque);  // it believes in weaker magnets
}

}  // namespace
}  // namespace motor
