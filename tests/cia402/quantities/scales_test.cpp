// Velocities, torques, currents, signs and rounding.
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "cia402/quantities/polarity.hpp"
#include "cia402/quantities/rated_scale.hpp"
#include "cia402/quantities/rounding.hpp"
#include "cia402/quantities/velocity_scale.hpp"
#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

TEST(Rounding, TakesAHalfAwayFromZero) {
  EXPECT_EQ(rounded<std::int32_t>(0.5), 1);
  EXPECT_EQ(rounded<std::int32_t>(-0.5), -1);
  EXPECT_EQ(rounded<std::int32_t>(1.5), 2);
  EXPECT_EQ(rounded<std::int32_t>(2.5), 3);
  EXPECT_EQ(rounded<std::int32_t>(-2.5), -3);
  EXPECT_EQ(rounded<std::int32_t>(0.49999999999999994), 0);
  EXPECT_EQ(rounded<std::int32_t>(2147483647.49), 2147483647);
}

TEST(Rounding, ShowsTheEndOfTheTypeBeyondIt) {
  EXPECT_EQ(rounded<std::int32_t>(1e30), 2147483647);
  EXPECT_EQ(rounded<std::int32_t>(-1e30), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(rounded<std::int16_t>(32767.5), 32767);
  EXPECT_EQ(rounded<std::int16_t>(-32768.6), -32768);
  EXPECT_EQ(rounded<std::uint16_t>(-3.0), 0);
  EXPECT_EQ(rounded<std::uint32_t>(5e9), 4294967295U);
  EXPECT_EQ(rounded<std::int32_t>(std::numeric_limits<double>::infinity()), 2147483647);
  EXPECT_EQ(rounded<std::int32_t>(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(saturated<std::int32_t>(std::int64_t{1} << 62), 2147483647);
  EXPECT_EQ(saturated<std::int32_t>(-(std::int64_t{1} << 62)), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(saturated<std::int16_t>(-32769), -32768);
  EXPECT_EQ(saturated<std::int16_t>(-77), -77);
  EXPECT_EQ(saturated<std::uint32_t>(-1), 0U);
}

TEST(VelocityScale, IsThatOfTheMotor) {
  const VelocityScale scale{65536.0};

  EXPECT_DOUBLE_EQ(scale.radians(65536.0), 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(scale.units_of_radians(std::numbers::pi), 32768.0);
  EXPECT_EQ(scale.rpm(3'276'800.0), 3000.0);
  EXPECT_EQ(scale.units_of_rpm(-3000.0), -3'276'800.0);
}

TEST(VelocityScale, GivesBackEveryRpmAndEveryUnitOfItsObjects) {
  RandomNumbers random;
  for (int i = 0; i < 100'000; ++i) {
    const VelocityScale scale{static_cast<double>(random.of_any_length(32)) /
                              static_cast<double>(random.of_any_length(16))};
    const auto rpm = static_cast<std::int16_t>(random.whole(-32768, 32767));
    const auto units = static_cast<std::int32_t>(random.whole(-2147483648LL, 2147483647LL));

    ASSERT_EQ(rounded<std::int16_t>(scale.rpm(scale.units_of_rpm(rpm))), rpm);
    ASSERT_EQ(rounded<std::int32_t>(scale.units_of_radians(scale.radians(units))), units);
  }
}

TEST(RatedScale, ShowsPerThousand) {
  const RatedScale torque{3340};  // 3.34 N·m

  EXPECT_DOUBLE_EQ(torque.physical(1000.0), 3.34);
  EXPECT_DOUBLE_EQ(torque.permille(-1.67), -500.0);
  EXPECT_EQ(torque.shown(0.00334 * 0.5000001), 1);
  EXPECT_EQ(torque.shown(1e6), 32767);
  EXPECT_EQ(torque.shown(-1e6), -32768);
  EXPECT_EQ(RatedScale{0}.shown(1.0), 0);
}

/// A value of whole µN·m (µA) is v / rated per thousand, a ratio of whole numbers.
TEST(RatedScale, RoundsAsTheExactRatioDoes) {
  RandomNumbers random;
  for (int i = 0; i < 200'000; ++i) {
    const auto rated = static_cast<std::uint32_t>(random.of_any_length(28));
    const std::int64_t micro = random.whole(-32767LL * rated, 32767LL * rated);
    const std::int64_t twice = 2 * std::abs(micro);
    if (twice % rated == 0 && twice / rated % 2 == 1) continue;  // a half, which a double can miss
    const std::int64_t size = (twice + rated) / (2LL * rated);

    ASSERT_EQ(RatedScale{rated}.shown(static_cast<double>(micro) / 1e6), micro < 0 ? -size : size)
        << micro << ' ' << rated;
  }
}

TEST(RatedScale, GivesBackEveryPermille) {
  RandomNumbers random;
  for (int permille = -32768; permille <= 32767; ++permille) {
    const RatedScale scale{static_cast<std::uint32_t>(random.of_any_length(32))};
    ASSERT_EQ(scale.shown(scale.physical(permille)), permille);
  }
}

TEST(Polarity, InvertsWhatItsBitsSay) {
  for (const unsigned other : {0x00u, 0x3Fu}) {
    const auto polarity = [other](unsigned bits) { return Polarity{static_cast<std::uint8_t>(bits | other)}; };
    EXPECT_EQ(polarity(0x00).position(5), 5);
    EXPECT_EQ(polarity(0x00).velocity(5), 5);
    EXPECT_EQ(polarity(0x80).position(5), -5);
    EXPECT_EQ(polarity(0x80).velocity(5), 5);
    EXPECT_EQ(polarity(0x40).position(2.5), 2.5);
    EXPECT_EQ(polarity(0x40).velocity(2.5), -2.5);
    EXPECT_EQ(polarity(0xC0).position(std::int64_t{-7}), 7);
    EXPECT_EQ(polarity(0xC0).velocity(-7.0), 7.0);
  }
}

TEST(Polarity, MakesTheLowerLimitOfTheUpperOne) {
  EXPECT_EQ(Polarity{0x80}.positions({-10.0, 300.0}), (Span{-300.0, 10.0}));
  EXPECT_EQ(Polarity{0x40}.positions({-10.0, 300.0}), (Span{-10.0, 300.0}));
  EXPECT_EQ(Polarity{0x80}.positions(Polarity{0x80}.positions({-10.0, 300.0})), (Span{-10.0, 300.0}));
}

}  // namespace
}  // namespace cia402
