// Lanes of SSE2 calculate as one number does, to the last bit.
#ifdef __SSE2__
#include "motor/lockstep/sse2_lanes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "motor/math/number.hpp"
#include "tests/motor/lockstep/lockstep_trial.hpp"

namespace motor {
namespace {

constexpr int kRandom = 200'000;

/// Numbers at which something changes, and random ones of all sizes.
std::vector<double> numbers() {
  constexpr double kWholeFrom = 4503599627370496.0;
  const double next = std::nextafter(kWholeFrom, 0.0);
  std::vector<double> result{0.0,
                             0.3,
                             0.5,
                             0.9999999999999999,
                             1.0,
                             1.5,
                             2.5,
                             1e300,
                             next,
                             kWholeFrom,
                             kWholeFrom + 1.0,
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
  lockstep_trial::Dice dice{1};
  for (int i = 0; i < kRandom; ++i)
    result.push_back(std::ldexp(dice.between(0.5, 1.0), static_cast<int>(dice.whole(-60, 60))));
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) result.push_back(-result[i]);
  return result;
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// Holds @p in_lanes of every number against @p alone.
template <class InLanes, class Alone>
void compare(InLanes in_lanes, Alone alone) {
  const std::vector<double> all = numbers();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::array pair{all[i], all[all.size() - 1 - i]};
    const Sse2Lanes result = in_lanes(Sse2Lanes{[&](auto lane) { return pair[lane]; }});
    for (std::size_t lane = 0; lane < pair.size(); ++lane)
      ASSERT_EQ(bits(result[lane]), bits(alone(pair[lane]))) << pair[lane];
  }
}

TEST(Sse2Lanes, RoundDown) {
  compare([](const Sse2Lanes& a) { return floor(a); }, [](double a) { return std::floor(a); });
}

TEST(Sse2Lanes, TakeSigns) {
  compare([](const Sse2Lanes& a) { return abs(a); }, [](double a) { return std::abs(a); });
  compare([](const Sse2Lanes& a) { return copysign(Sse2Lanes{2.0}, a); },
          [](double a) { return std::copysign(2.0, a); });
  compare([](const Sse2Lanes& a) { return -a; }, [](double a) { return -a; });
}

TEST(Sse2Lanes, AreBoundedLikeOneNumber) {
  for (const double bound : {-1.0, -0.0, 0.0, 1.5}) {
    compare([&](const Sse2Lanes& a) { return minimum<Sse2Lanes>(a, bound); },
            [&](double a) { return std::min(a, bound); });
    compare([&](const Sse2Lanes& a) { return minimum<Sse2Lanes>(bound, a); },
            [&](double a) { return std::min(bound, a); });
    compare([&](const Sse2Lanes& a) { return maximum<Sse2Lanes>(a, bound); },
            [&](double a) { return std::max(a, bound); });
    compare([&](const Sse2Lanes& a) { return maximum<Sse2Lanes>(bound, a); },
            [&](double a) { return std::max(bound, a); });
    compare([&](const Sse2Lanes& a) { return bounded<Sse2Lanes>(a, bound, 2.0); },
            [&](double a) { return std::clamp(a, bound, 2.0); });
  }
}

TEST(Sse2Lanes, HaveConditionsOfTheirOwn) {
  const auto lanes = [](double first, double second) {
    return Sse2Lanes{[&](auto lane) { return lane == 0 ? first : second; }};
  };
  const Sse2Mask first = lanes(1.0, 3.0) < lanes(2.0, 2.0);
  const Sse2Mask second = lanes(1.0, 3.0) > lanes(2.0, 2.0);

  EXPECT_TRUE(first[0]);
  EXPECT_FALSE(first[1]);
  EXPECT_TRUE(any_of(first));
  EXPECT_FALSE(all_of(first));
  EXPECT_TRUE(all_of(first || second));
  EXPECT_FALSE(any_of(first && second));
  EXPECT_TRUE(all_of(!first || first));
  EXPECT_FALSE((!first)[0]);
  const Sse2Lanes chosen_ones = select<Sse2Lanes>(first, lanes(10.0, 11.0), lanes(20.0, 21.0));
  EXPECT_EQ(chosen_ones[0], 10.0);
  EXPECT_EQ(chosen_ones[1], 21.0);
}

TEST(Sse2Lanes, AreUnequalWhereOneIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();

  EXPECT_TRUE(all_of(Sse2Lanes{none} != Sse2Lanes{none}));
  EXPECT_FALSE(any_of(Sse2Lanes{none} == Sse2Lanes{none}));
  EXPECT_FALSE(any_of(Sse2Lanes{none} <= Sse2Lanes{1.0}));
  EXPECT_FALSE(any_of(Sse2Lanes{none} >= Sse2Lanes{1.0}));
}

}  // namespace
}  // namespace motor
#endif
