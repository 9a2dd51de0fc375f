// The position range 607Bh.
#include "cia402/quantities/position_range.hpp"

#include <gtest/gtest.h>

#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

TEST(PositionRange, IsNotInForceAtTheEndsOfItsTypeNorWhenItIsEmpty) {
  EXPECT_EQ(range_in_force(kLowest, kHighest), std::nullopt);
  EXPECT_EQ(range_in_force(10, 10), std::nullopt);
  EXPECT_EQ(range_in_force(10, -10), std::nullopt);
  EXPECT_EQ(range_in_force(0, kHighest), (Span{0.0, 2147483647.0}));
  EXPECT_EQ(range_in_force(kLowest, 0), (Span{-2147483648.0, 0.0}));
  EXPECT_EQ(modulus_of({0.0, 359.0}), 360.0);
  EXPECT_EQ(modulus_of(*range_in_force(kLowest, kHighest - 1)), 4294967295.0);
}

TEST(PositionRange, WrapsToTheOtherEnd) {
  const Span range{-100.0, 259.0};

  EXPECT_EQ(wrapped(std::int64_t{-100}, range), -100);
  EXPECT_EQ(wrapped(std::int64_t{259}, range), 259);
  EXPECT_EQ(wrapped(std::int64_t{260}, range), -100);
  EXPECT_EQ(wrapped(std::int64_t{-101}, range), 259);
  EXPECT_EQ(wrapped(std::int64_t{36'000'000'007}, range), 7);
  EXPECT_EQ(wrapped(std::int64_t{-36'000'000'007}, range), -7);
  EXPECT_EQ(turns_of(259.9, range), 0.0);
  EXPECT_EQ(turns_of(260.0, range), 1.0);
  EXPECT_EQ(turns_of(-100.1, range), -1.0);
}

TEST(PositionRange, KnowsTheNearestOfEqualPlaces) {
  const Span range{0.0, 359.0};

  EXPECT_EQ(nearest(10.0, 350.0, range), 370.0);
  EXPECT_EQ(nearest(350.0, 10.0, range), -10.0);
  EXPECT_EQ(nearest(100.0, 150.0, range), 100.0);
  EXPECT_EQ(nearest(180.0, 0.0, range), 180.0);
  EXPECT_EQ(nearest(0.0, 180.0, range), 360.0);
  EXPECT_EQ(nearest(-36'000'000.0, 5.0, range), 0.0);
}

TEST(PositionRange, HoldsEveryPlaceOfEveryRange) {
  RandomNumbers random;
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t low = random.whole(kLowest, kHighest - 1);
    const std::int64_t high = random.whole(low + 1, kHighest);
    const auto range = range_in_force(static_cast<std::int32_t>(low), static_cast<std::int32_t>(high));
    if (!range) continue;
    const std::int64_t position = random.whole(-(1LL << 44), 1LL << 44);
    const std::int64_t modulus = high - low + 1;

    const std::int64_t place = wrapped(position, *range);
    ASSERT_GE(place, low);
    ASSERT_LE(place, high);
    ASSERT_EQ((position - place) % modulus, 0);
    ASSERT_EQ(turns_of(static_cast<double>(position), *range), static_cast<double>((position - place) / modulus));

    const std::int64_t from = random.whole(-(1LL << 40), 1LL << 40);
    const double near = nearest(static_cast<double>(place), static_cast<double>(from), *range);
    ASSERT_EQ((static_cast<std::int64_t>(near) - place) % modulus, 0);
    ASSERT_GT(near - static_cast<double>(from), -0.5 * static_cast<double>(modulus));
    ASSERT_LE(near - static_cast<double>(from), 0.5 * static_cast<double>(modulus));
  }
}

TEST(PositionRange, WrapsTheEndsOf64Bits) {
  EXPECT_EQ(wrapped(std::numeric_limits<std::int64_t>::max(), {-8.0, 7.0}), -1);
  EXPECT_EQ(wrapped(std::numeric_limits<std::int64_t>::min(), {-8.0, 7.0}), 0);
  EXPECT_EQ(wrapped(std::numeric_limits<std::int64_t>::min(), {1.0, 16.0}), 16);
}

}  // namespace
}  // namespace cia402
