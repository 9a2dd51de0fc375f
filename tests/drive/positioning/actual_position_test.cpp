// The position actual value (p2502 to p2516, r2521 to r2526) by the slice.
#include "drive/positioning/actual_position/actual_position.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

__extension__ using Wide = __int128;

constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();

std::int64_t rounded_quotient(Wide dividend, Wide divisor) {
  const Wide twice = 2 * (dividend < 0 ? -dividend : dividend) + divisor;
  const Wide quotient = twice / (2 * divisor);
  return static_cast<std::int64_t>(dividend < 0 ? -quotient : quotient);
}

std::int64_t within(std::int64_t value, std::int64_t range) {
  return (value % range + range) % range;
}

TEST(ActualPosition, BeginsAtZeroAndValid) {
  SensedAxis axis;
  axis.stay();

  EXPECT_EQ(axis.shown(), 0);
  EXPECT_EQ(axis.position.status(), 0x0001);
  EXPECT_FALSE(axis.position.reference_lost());
  axis.turn(2500);
  EXPECT_EQ(axis.shown(), 2500);
  EXPECT_EQ(axis.position.position(), 2500.0);
  EXPECT_EQ(axis.position.shown_of(1), 2500.0);
  EXPECT_EQ(axis.position.shown_of(2), 0.0);
}

TEST(ActualPosition, HasTheVelocityOfTheEncoder) {
  SensedAxis axis;
  axis.position.settings.gear_load = -2;
  axis.slice.speed = 2.0 * std::numbers::pi * 3.0;
  axis.stay();

  EXPECT_NEAR(axis.position.velocity(), -6000.0, 1e-9);
  EXPECT_NEAR(axis.position.velocity_of(0), -6000.0, 1e-9);
}

/// Gear 3:7 and 10007 LU a load revolution over 10⁷ motor revolutions of a modulo axis.
class ManyRevolutions : public testing::TestWithParam<int> {};

TEST_P(ManyRevolutions, OfAModuloAxisLoseNothing) {
  constexpr std::int64_t kRange = 360'000;
  constexpr std::int64_t kPerTurn = 2048LL << 11;
  constexpr std::int64_t kRevolutions = 10'000'000;
  ActualPosition position{motor::EncoderData{}};
  position.settings.gear_motor = 3;
  position.settings.gear_load = 7;
  position.settings.units_per_load = 10007;
  ActualPosition::Slice slice{.modulo_range = kRange};
  std::int64_t step = 1;

  while (slice.counts * GetParam() < kRevolutions * kPerTurn) {
    slice.counts += GetParam() * step;
    step = step * 7 % (2999 * kPerTurn) + 1;  // slices of a count to some thousand revolutions
    position.run(slice);
    const std::int64_t exact = rounded_quotient(Wide{slice.counts} * 7 * 10007, Wide{kPerTurn} * 3);
    ASSERT_EQ(position.shown(), within(exact, kRange)) << slice.counts;
    ASSERT_TRUE(position.position_valid());
  }
  slice.counts = GetParam() * 3 * kRevolutions * kPerTurn;  // whole revolutions of the load
  position.run(slice);
  EXPECT_EQ(position.shown(), within(GetParam() * 7 * 10007 * kRevolutions, kRange));
  EXPECT_EQ(position.position(), static_cast<double>(position.shown()));
}

INSTANTIATE_TEST_SUITE_P(BothWays, ManyRevolutions, testing::Values(1, -1));

TEST(ActualPosition, IsInTheModuloRangeOrNearestToTheSetpoint) {
  SensedAxis axis;
  axis.slice.modulo_range = 360;
  axis.turn(-10);
  EXPECT_EQ(axis.shown(), 350);
  axis.turn(15);
  EXPECT_EQ(axis.shown(), 5);
  EXPECT_EQ(axis.position.wrapped(), 360);
  axis.slice.setpoint = 358.0;
  axis.stay();
  EXPECT_EQ(axis.shown(), 365) << "ahead of a setpoint that has not come round yet";
  axis.slice.setpoint = 2.0;
  axis.stay();
  EXPECT_EQ(axis.shown(), 5);
}

TEST(ActualPosition, HasTheOffsetThatIsWired) {
  SensedAxis axis;
  axis.position.inputs.offset[0] = -40.0;
  axis.turn(100);
  EXPECT_EQ(axis.shown(), 60);
  EXPECT_EQ(axis.position.shown_of(1), 100.0) << "it has an offset of its own";
  axis.position.inputs.offset[0] = 0.0;
  axis.stay();
  EXPECT_EQ(axis.shown(), 100);
}

TEST(ActualPosition, IsCorrectedAtEdges) {
  SensedAxis axis;
  axis.position.inputs.correction[0] = 7.0;
  axis.position.inputs.correct[0] = true;
  axis.stay();
  axis.stay();
  EXPECT_EQ(axis.shown(), 7);
  axis.position.inputs.correct[0] = false;
  axis.position.inputs.correct_negatively[0] = true;
  axis.stay();
  axis.stay();
  EXPECT_EQ(axis.shown(), 0);
  axis.position.correct(-3);
  EXPECT_EQ(axis.shown(), -3);
}

TEST(ActualPosition, StaysAtASettingValueAndCountsNothing) {
  SensedAxis axis;
  axis.turn(20);
  axis.position.inputs.set_position[0] = true;
  axis.position.inputs.setting_value[0] = 5000.0;
  axis.turn(30);
  EXPECT_EQ(axis.shown(), 5000);
  EXPECT_TRUE(axis.position.is_held());
  axis.turn(300);
  EXPECT_EQ(axis.shown(), 5000);
  axis.position.inputs.set_position[0] = false;
  axis.turn(4);
  EXPECT_EQ(axis.shown(), 5004);
  EXPECT_FALSE(axis.position.is_held());
}

TEST(ActualPosition, IsSetWithinTheRangeOfCoordinates) {
  SensedAxis axis;
  axis.turn(123);
  EXPECT_TRUE(axis.position.set_position(-2147482648));
  EXPECT_EQ(axis.shown(), -2147482648);
  EXPECT_FALSE(axis.position.set_position(2147482648));
  EXPECT_EQ(axis.shown(), -2147482648);
  axis.slice.modulo_range = 360;
  axis.stay();
  EXPECT_TRUE(axis.position.set_position(359));
  EXPECT_FALSE(axis.position.set_position(360));
  EXPECT_FALSE(axis.position.set_position(-1));
  EXPECT_EQ(axis.shown(), 359);
}

TEST(ActualPosition, OverflowsBeyondItsNumbers) {
  SensedAxis axis;
  axis.turn(kLargest);
  EXPECT_TRUE(axis.position.position_valid());
  axis.turn(1);
  EXPECT_TRUE(axis.position.overflows());
  EXPECT_TRUE(axis.position.encoder_1_overflows());
  EXPECT_FALSE(axis.position.position_valid());
  EXPECT_TRUE(axis.position.reference_lost());
  EXPECT_EQ(axis.shown(), kLargest);
  axis.turn(-1);
  EXPECT_TRUE(axis.position.position_valid());
  EXPECT_FALSE(axis.position.reference_lost());
}

TEST(ActualPosition, NeedsAnEncoder) {
  SensedAxis other;
  other.position.settings.encoder = 2;
  other.stay();
  EXPECT_TRUE(other.position.has_no_encoder());
  EXPECT_FALSE(other.position.position_valid());
  SensedAxis none{SensedAxis::encoder(motor::EncoderType::None)};
  none.stay();
  EXPECT_TRUE(none.position.has_no_encoder());
  EXPECT_EQ(none.position.status(), 0);
}

TEST(ActualPosition, IsInvalidWhileItsEncoderHasAFault) {
  SensedAxis axis;
  axis.turn(10);
  axis.slice.encoder_faulty = true;
  axis.stay();
  EXPECT_TRUE(axis.position.encoder_faulty());
  EXPECT_FALSE(axis.position.position_valid());
  EXPECT_TRUE(axis.position.reference_lost());
  axis.slice.encoder_faulty = false;
  axis.stay();
  EXPECT_TRUE(axis.position.position_valid());
  EXPECT_EQ(axis.shown(), 10);
}

TEST(ActualPosition, BeginsAnewWithAnotherScale) {
  SensedAxis axis;
  axis.turn(500);
  axis.position.settings.units_per_load = 2000;
  axis.turn(10);
  EXPECT_EQ(axis.shown(), 20);
  EXPECT_TRUE(axis.position.reference_lost());
  axis.stay();
  EXPECT_FALSE(axis.position.reference_lost());
  EXPECT_EQ(axis.position.units_per_revolution(), 2000.0);
}

TEST(ActualPosition, OfAnIncrementalEncoderBeginsAnewWithPower) {
  SensedAxis axis;
  axis.turn(500);
  axis.position.correct(7);
  axis.position.power_on(axis.slice.counts);
  axis.turn(3);
  EXPECT_EQ(axis.shown(), 3);
}

}  // namespace
}  // namespace drive
