// Counts of the encoder as length units (p2504 to p2506, r2524).
#include "drive/positioning/actual_position/length_scale.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace drive {
namespace {

constexpr std::int64_t kPerRevolution = 2048LL << 11;

LengthScale scale_of(std::int32_t motor, std::int32_t load, std::int32_t units) {
  return LengthScale{{.gear_motor = motor, .gear_load = load, .units_per_load = units}};
}

TEST(LengthScale, IsThatOfTheGear) {
  EXPECT_EQ(LengthScale{}.units_per_revolution(), 10000.0);
  EXPECT_EQ(scale_of(10, 1, 360000).units_per_revolution(), 36000.0);
  EXPECT_NEAR(scale_of(3, 7, 10007).units_per_revolution(), 23349.667, 0.001);
  EXPECT_EQ(scale_of(1, -1, 10000).units_per_revolution(), -10000.0);
}

TEST(LengthScale, IsExactOverManyRevolutions) {
  const LengthScale scale = scale_of(3, 7, 10007);

  EXPECT_EQ(scale.length(30'000 * kPerRevolution).whole, 700'490'000);
  EXPECT_EQ(scale.length(-30'000 * kPerRevolution).whole, -700'490'000);
  EXPECT_EQ(scale.length(3'000'000'000LL * kPerRevolution).whole, 70'049'000'000'000);
  EXPECT_EQ(scale.length(3'000'000'000LL * kPerRevolution).rest, 0.0);
  EXPECT_LE(scale.length(91'970 * kPerRevolution).whole, std::numeric_limits<std::int32_t>::max());
  EXPECT_GT(scale.length(91'971 * kPerRevolution).whole, std::numeric_limits<std::int32_t>::max());
}

TEST(LengthScale, RoundsAHalfAwayFromZero) {
  const LengthScale scale{{.pulses = 1, .fine_bits = 2, .units_per_load = 2}};  // half a unit a count

  EXPECT_EQ(scale.length(1).whole, 1);
  EXPECT_EQ(scale.length(1).rest, -0.5);
  EXPECT_EQ(scale.length(-1).whole, -1);
  EXPECT_EQ(scale.length(-1).rest, 0.5);
  EXPECT_EQ(scale.length(3).whole, 2);
  EXPECT_EQ(scale.length(-3).whole, -2);
  EXPECT_EQ(scale.length(2).whole, 1);
}

TEST(LengthScale, KeepsWhatRoundingLeaves) {
  const LengthScale scale = scale_of(3, 7, 10007);

  for (std::int64_t counts = -50'000'000; counts < 50'000'000; counts += 1'234'567) {
    const Length length = scale.length(counts);
    EXPECT_LE(std::abs(length.rest), 0.5);
    const double exact = static_cast<double>(counts) * scale.units_per_revolution() / kPerRevolution;
    EXPECT_NEAR(length.exact(), exact, 1e-6);
  }
}

TEST(LengthScale, TurnsTheOtherWayWithANegativeGear) {
  const LengthScale forward = scale_of(3, 7, 10007);
  const LengthScale backward = scale_of(3, -7, 10007);

  for (const std::int64_t counts : {1LL, 419'431LL, 123'456'789LL, -987'654'321LL})
    EXPECT_EQ(backward.length(counts).whole, -forward.length(counts).whole);
}

TEST(LengthScale, StaysAtTheEndsOfItsRange) {
  const LengthScale coarse{{.pulses = 1, .fine_bits = 2, .gear_load = 1 << 20, .units_per_load = 2147483647}};

  EXPECT_EQ(coarse.length(std::numeric_limits<std::int64_t>::max()).whole, 1LL << 61);
  EXPECT_EQ(coarse.length(std::numeric_limits<std::int64_t>::min()).whole, -(1LL << 61));
  EXPECT_EQ(scale_of(1, 0, 10000).length(123'456).whole, 0);
}

TEST(LengthScale, KnowsWhetherRevolutionsAreAMultipleOfALength) {
  EXPECT_TRUE(scale_of(1, 1, 10000).is_multiple(4096, 360000 / 9));
  EXPECT_FALSE(scale_of(1, 1, 10000).is_multiple(4096, 360000));
  EXPECT_FALSE(scale_of(3, 7, 10007).is_multiple(4096, 10007));
  EXPECT_TRUE(scale_of(3, 7, 10007).is_multiple(4098, 10007));
}

}  // namespace
}  // namespace drive
