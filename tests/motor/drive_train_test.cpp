#include "motor/drive_train.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr TorqueLimits kFullTorque{35.0, -35.0};
constexpr double kDcVoltage = 540.0;

Command at_speed(double rpm, TorqueLimits limits = kFullTorque) {
  return {.pulses_enabled = true, .speed_setpoint = rpm * kRpm, .limits = limits};
}

void run(DriveTrain& train, const Command& command, double seconds) {
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

  train.step(kDcVoltage, {});
  EXPECT_EQ(train.signals().torque, 0.0);
  EXPECT_EQ(train.signals().torque_setpoint, 0.0);
  EXPECT_GT(train.signals().true_speed, 0.999 * start);
  EXPECT_FALSE(train.rests());

  const double tail = 0.1 / 2e-4;
  const double stops_after = 0.00151 / 2e-4 * std::log(1.0 + start / tail);
  run(train, {}, 0.99 * stops_after);
  EXPECT_GT(train.signals().true_speed, 0.0);
  run(train, {}, 0.02 * stops_after);
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

  EXPECT_EQ(train.signals().torque, 0.0);
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
  double angle = 0.0;
  double before = 0.0;

  for (int i = 0; i < 16000; ++i) {
    train.step(kDcVoltage, at_speed(i < 8000 ? 2000.0 : -500.0));
    angle += 0.5 * (before + train.signals().true_speed) * kControlPeriod;
    before = train.signals().true_speed;
  }

  const double expected = angle / (2.0 * std::numbers::pi) * increments_per_revolution(machine);
  EXPECT_NEAR(static_cast<double>(train.signals().encoder_counts), expected, 2.0);
}

TEST(DriveTrain, PutsExactlyTheMotorsWorkIntoMotionAndFriction) {
  const MachineData machine{};
  DriveTrain train{machine, {.inertia = 0.001}};
  double work = 0.0;
  double friction = 0.0;
  double before = 0.0;

  for (int i = 0; i < 8000; ++i) {
    train.step(kDcVoltage, at_speed(3000.0));
    const double mean = 0.5 * (before + train.signals().true_speed);
    work += train.signals().torque * mean * kControlPeriod;
    friction += (0.1 + 2e-4 * mean) * mean * kControlPeriod;
    before = train.signals().true_speed;
  }

  const double kinetic = 0.5 * 0.00251 * before * before;
  EXPECT_NEAR(work, kinetic + friction, 0.002 * kinetic);
}

TEST(DriveTrain, StartsUpAsTheExactSolutionOfItsCurrentLoopAndMass) {
  MachineData machine{};
  machine.coulomb_friction = 0.0;
  machine.viscous_friction = 0.0;
  DriveTrain train{machine, {}};

  run(train, at_speed(6000.0), 0.01);

  const double lag = 400e-6;
  const double time = 0.01 - kControlPeriod;  // the first period calculates
  const double expected = 35.0 / machine.inertia * (time - lag * (1.0 - std::exp(-time / lag)));
  EXPECT_NEAR(train.signals().true_speed, expected, 1e-9 * expected);
}

}  // namespace
}  // namespace motor
