#include "motor/plant/encoder.hpp"

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

/// Turns @p encoder by @p revolutions in steps of a 50th of a revolution; each step is one period.
void turn_by(Encoder& encoder, int revolutions) {
  for (int i = 0; i < 50 * std::abs(revolutions); ++i) encoder.turn(std::copysign(kTurn / 50.0, revolutions));
}

TEST(Encoder, KeepsEveryIncrementFarFromItsStart) {
  Encoder encoder = fine_encoder();

  encoder.move_to(1'000'000'000, 0.75 * kTurn);

  EXPECT_EQ(encoder.counts(), (4'000'000'003 << 22) / 4);
}

TEST(Encoder, WithoutSignalsKeepsItsCountsAndSaysSo) {
  Encoder encoder = fine_encoder();
  turn_by(encoder, 1);
  const std::int64_t before = encoder.counts();

  encoder.inject(EncoderDefect::Loss);
  turn_by(encoder, 3);

  EXPECT_TRUE(encoder.status().signal_lost);
  EXPECT_EQ(encoder.counts(), before);
  EXPECT_EQ(encoder.speed(), 0.0);
}

TEST(Encoder, CountsOnFromWhereItWasWhenItsSignalsAreBack) {
  Encoder encoder = fine_encoder();
  encoder.inject(EncoderDefect::Loss);
  turn_by(encoder, 3);

  encoder.inject(EncoderDefect::None);
  turn_by(encoder, 1);

  EXPECT_EQ(encoder.status(), EncoderStatus{});
  EXPECT_NEAR(static_cast<double>(encoder.counts()), 2048.0 * 2048.0, 1.0);
}

TEST(Encoder, FindsLostPulsesAtTheSecondZeroMark) {
  for (const int direction : {1, -1}) {
    Encoder encoder = fine_encoder();
    turn_by(encoder, 3 * direction);
    EXPECT_EQ(encoder.status().zero_mark_deviation, 0);

    encoder.inject(EncoderDefect::LostPulses);
    turn_by(encoder, direction);
    EXPECT_EQ(encoder.status().zero_mark_deviation, 0);
    turn_by(encoder, 2 * direction);

    EXPECT_EQ(encoder.status().zero_mark_deviation, -2048 * 4 / 256);
    EXPECT_FALSE(encoder.status().signal_lost);
  }
}

TEST(Encoder, ForgetsADeviationWhenItIsAcknowledgedAndThePulsesAreBack) {
  Encoder encoder = fine_encoder();
  encoder.inject(EncoderDefect::LostPulses);
  turn_by(encoder, 3);

  encoder.inject(EncoderDefect::None);
  encoder.acknowledge();
  turn_by(encoder, 3);

  EXPECT_EQ(encoder.status(), EncoderStatus{});
}

TEST(Encoder, SwingingAboutAZeroMarkFindsNothing) {
  Encoder encoder = fine_encoder();

  for (int i = 0; i < 1000; ++i) encoder.turn(i % 2 == 0 ? -0.1 : 0.1);

  EXPECT_EQ(encoder.status(), EncoderStatus{});
}

TEST(Encoder, CountsTheWrongWayWithExchangedTracksAndNoticesNothing) {
  Encoder encoder = fine_encoder();
  encoder.inject(EncoderDefect::Reversed);

  turn_by(encoder, 3);

  EXPECT_NEAR(static_cast<double>(encoder.counts()), -3.0 * 2048.0 * 2048.0, 1.0);
  EXPECT_LT(encoder.speed(), 0.0);
  EXPECT_EQ(encoder.status(), EncoderStatus{});
}

TEST(Encoder, OfTheAbsoluteKindKnowsItsPlaceAtPowerOnAndWrapsAfterItsRevolutions) {
  MachineData machine;
  machine.encoder = {.type = EncoderType::Absolute, .revolutions = 4096, .start_position = 4094.25};
  Encoder encoder{machine};
  encoder.configure(kPeriod);
  constexpr std::uint32_t kPerTurn = 2048U << 9U;

  EXPECT_EQ(encoder.absolute_position(), 4094U * kPerTurn + kPerTurn / 4);
  encoder.move_to(2, 0.0);

  EXPECT_EQ(encoder.absolute_position(), kPerTurn / 4);
  EXPECT_EQ(encoder.counts(), 2 << 22);
}

TEST(Encoder, OfTheIncrementalKindHasNoAbsolutePosition) {
  Encoder encoder = fine_encoder();

  encoder.move_to(3, 1.0);

  EXPECT_EQ(encoder.absolute_position(), 0U);
}

}  // namespace
}  // namespace motor
