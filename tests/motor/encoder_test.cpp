#include "motor/encoder.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr double kPeriod = 125e-6;
constexpr double kTurn = 2.0 * std::numbers::pi;

Encoder fine_encoder() {
  Encoder encoder{MachineData{}};
  encoder.configure(kPeriod);
  return encoder;
}

TEST(Encoder, CountsPulsesTimesFineResolutionInARevolution) {
  Encoder encoder = fine_encoder();

  encoder.turn(kTurn * 1.0000001);

  EXPECT_EQ(encoder.counts(), 2048 * 2048);
}

TEST(Encoder, LosesNothingInAMillionSmallTurnsThereAndBack) {
  Encoder encoder = fine_encoder();

  for (int i = 0; i < 1'000'000; ++i) encoder.turn(kTurn * 0.00333333);
  EXPECT_NEAR(static_cast<double>(encoder.counts()), 3333.33 * 4194304.0, 2.0);
  for (int i = 0; i < 1'000'000; ++i) encoder.turn(-kTurn * 0.00333333);

  EXPECT_LE(std::abs(encoder.counts()), 1);
}

TEST(Encoder, IsBelowZeroAsSoonAsItTurnsBackwards) {
  Encoder encoder = fine_encoder();

  encoder.turn(-kTurn * 1e-9);

  EXPECT_EQ(encoder.counts(), -1);
}

TEST(Encoder, MeasuresAConstantSpeedWithinTheToleratedRipple) {
  Encoder encoder = fine_encoder();

  for (int i = 0; i < 800; ++i) encoder.turn(100.0 * kPeriod);

  EXPECT_NEAR(encoder.speed(), 100.0, 2e-5 * MachineData{}.rated_speed);
}

TEST(Encoder, MeasuresExactlyZeroAfterTheShaftHasStopped) {
  Encoder encoder = fine_encoder();
  for (int i = 0; i < 800; ++i) encoder.turn(100.0 * kPeriod);

  for (int i = 0; i < 800; ++i) encoder.turn(0.0);

  EXPECT_EQ(encoder.speed(), 0.0);
}

TEST(Encoder, SmoothsACoarseEncoderMoreThanAFineOneButNeverBeyondTwoMilliseconds) {
  Encoder coarse{MachineData{.encoder = {.pulses = 1024, .fine_bits = 2}}};
  coarse.configure(kPeriod);

  EXPECT_GT(coarse.filter_time(), fine_encoder().filter_time());
  EXPECT_LE(coarse.filter_time(), 2e-3);
  EXPECT_LT(fine_encoder().filter_time(), 0.5e-3);
}

}  // namespace
}  // namespace motor
