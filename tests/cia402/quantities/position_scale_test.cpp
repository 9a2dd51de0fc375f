// Increments as position units (608Fh, 6091h, 6092h).
#include "cia402/quantities/position_scale.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/cia402/quantities/long_number.hpp"
#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

constexpr std::int64_t kFarthest = PositionScale::kFarthest;

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

TEST(PositionScale, OfANewAxisIsTheIncrement) {
  const PositionScale scale;

  for (const std::int64_t counts : {0LL, 1LL, -1LL, 65536LL, -123'456'789'012LL, 1LL << 62}) {
    EXPECT_EQ(scale.units(counts), counts);
    EXPECT_EQ(scale.increments(counts), counts);
  }
  EXPECT_EQ(scale.units_per_revolution(), 65536.0);
}

TEST(PositionScale, FollowsGearAndFeed) {
  // 10 revolutions of the motor are 3 of the shaft, and 2 of the shaft are 7 mm in µm.
  const PositionScale scale{
      {.motor_revolutions = 10, .shaft_revolutions = 3, .feed = 7000, .feed_revolutions = 2}};

  EXPECT_EQ(scale.units_per_revolution(), 1050.0);
  EXPECT_EQ(scale.units(65536), 1050);
  EXPECT_EQ(scale.increments(1050), 65536);
  EXPECT_EQ(scale.units(65536LL * 1'000'000'000'000), 1'050'000'000'000'000);
  EXPECT_EQ(scale.exact_units(32768 + 16), 525.0 + 16.0 * 1050.0 / 65536.0);
}

TEST(PositionScale, RoundsAHalfAwayFromZero) {
  const PositionScale scale{{.increments = 4, .feed = 2}};

  EXPECT_EQ(scale.units(1), 1);
  EXPECT_EQ(scale.units(-1), -1);
  EXPECT_EQ(scale.units(2), 1);
  EXPECT_EQ(scale.units(3), 2);
  EXPECT_EQ(scale.units(-3), -2);
  EXPECT_EQ(scale.exact_units(-3), -1.5);
  const PositionScale fine{{.increments = 3, .feed = 2}};
  EXPECT_EQ(fine.increments(1), 2);
  EXPECT_EQ(fine.increments(-1), -2);
  EXPECT_EQ(fine.increments(3), 5);
  EXPECT_EQ(fine.units(1), 1);
  EXPECT_EQ(fine.units(2), 1);
}

TEST(PositionScale, StaysAtItsEnds) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const PositionScale coarse{{.increments = 1, .shaft_revolutions = kMost, .feed = kMost}};
  const PositionScale fine{
      {.increments = kMost, .motor_revolutions = kMost - 1, .feed = 1, .feed_revolutions = kMost}};

  EXPECT_EQ(coarse.units(std::numeric_limits<std::int64_t>::max()), kFarthest);
  EXPECT_EQ(coarse.units(std::numeric_limits<std::int64_t>::min()), -kFarthest);
  EXPECT_EQ(coarse.exact_units(std::numeric_limits<std::int64_t>::min()), static_cast<double>(-kFarthest));
  EXPECT_EQ(coarse.increments(-1), 0);
  EXPECT_EQ(fine.increments(1), kFarthest);
  EXPECT_EQ(fine.increments(-1), -kFarthest);
  EXPECT_EQ(fine.increments(0), 0);
  EXPECT_EQ(fine.units(std::numeric_limits<std::int64_t>::max()), 0);
}

/// Whether @p whole is |value| · units / increments, a half upwards, as a ratio of products; or stays at the end.
::testing::AssertionResult is_rounded(std::uint64_t whole, const LongNumber& twice_dividend,
                                      const LongNumber& one_less_than_rounded, const LongNumber& rounded_next) {
  const auto farthest = static_cast<std::uint64_t>(kFarthest);
  const bool is_high_enough = whole == 0 || twice_dividend >= one_less_than_rounded;
  const bool is_low_enough = whole == farthest || twice_dividend < rounded_next;
  return is_high_enough && is_low_enough ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << whole;
}

TEST(PositionScale, IsExactForAllObjectsAndCounts) {
  RandomNumbers random;
  for (int i = 0; i < 200'000; ++i) {
    const auto object = [&random] { return static_cast<std::uint32_t>(random.of_any_length(32)); };
    const PositionMechanics m{object(), object(), object(), object(), object()};
    const PositionScale scale{m};
    auto value = static_cast<std::int64_t>(random.of_any_length(63));
    if (random.by_chance(0.5)) value = -value;
    const std::uint64_t size = magnitude(value);

    // units = value · shaft · feed / (increments · motor · feed revolutions): w - 1/2 <= that < w + 1/2.
    const std::uint64_t units = magnitude(scale.units(value));
    const LongNumber twice{2, size, m.shaft_revolutions, m.feed};
    const auto times = [&m](std::uint64_t n) {
      return LongNumber{n, m.increments, m.motor_revolutions, m.feed_revolutions};
    };
    ASSERT_TRUE(is_rounded(units, twice, times(2 * units - 1), times(2 * units + 1))) << value;
    ASSERT_EQ(scale.units(-value), -scale.units(value));

    const std::uint64_t increments = magnitude(scale.increments(value));
    const LongNumber twice_back{2, size, m.increments, m.motor_revolutions, m.feed_revolutions};
    const auto back = [&m](std::uint64_t n) { return LongNumber{n, m.shaft_revolutions, m.feed}; };
    ASSERT_TRUE(is_rounded(increments, twice_back, back(2 * increments - 1), back(2 * increments + 1))) << value;
    ASSERT_EQ(scale.increments(-value), -scale.increments(value));

    const double exact = scale.exact_units(value);
    ASSERT_NEAR(exact, static_cast<double>(scale.units(value)), 0.5 + 1e-15 * std::abs(exact));
  }
}

TEST(PositionScale, KeepsTheFractionOfManyRevolutions) {
  RandomNumbers random;
  const PositionScale scale{{.motor_revolutions = 3, .shaft_revolutions = 7, .feed = 10007}};
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t revolutions = random.whole(-3'000'000, 3'000'000);
    const std::int64_t part = random.whole(0, 65535);

    // Three revolutions of the motor are 70049 units.
    const double expected =
        static_cast<double>(revolutions) * 70049.0 + static_cast<double>(part) * 70049.0 / 196608.0;
    ASSERT_NEAR(scale.exact_units(3 * revolutions * 65536 + part), expected, 1e-4);
    ASSERT_EQ(scale.units(3 * revolutions * 65536), revolutions * 70049);
  }
}

}  // namespace
}  // namespace cia402
