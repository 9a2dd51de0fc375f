#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "drive/positioning/profile/trapezoid_profile.hpp"

namespace drive {
namespace {

using Event = TrapezoidProfile::Event;

constexpr double kCycle = 1e-3;

/// Orders by chance, of sizes that real axes have.
class RandomMotion : public testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>{low, high}(random_); }
  /// Between 10^@p low and 10^@p high.
  double of_size(double low, double high) { return std::pow(10.0, between(low, high)); }
  bool by_chance(double share) { return between(0.0, 1.0) < share; }
  MotionLimits limits() {
    return {by_chance(0.1) ? 0.0 : of_size(2.0, 5.7), of_size(3.0, 6.0), of_size(3.0, 6.0)};
  }
  double target(const TrapezoidProfile& profile) {
    if (by_chance(0.1)) return between(-1.0, 1.0) < 0.0 ? -kEndless : kEndless;
    if (by_chance(0.1)) return profile.position();
    const double stop = profile.position() +
                        std::copysign(profile.braking_distance(profile.limits().deceleration), profile.velocity());
    if (by_chance(0.2)) return stop + between(-1e-3, 1e-3);
    return std::round(profile.position() + (by_chance(0.5) ? 1.0 : -1.0) * of_size(-2.0, 5.5));
  }
  void order(TrapezoidProfile& profile) {
    if (by_chance(0.15)) return profile.brake(of_size(3.0, 6.0));
    profile.move_to(target(profile), limits(), by_chance(0.3));
  }

  static constexpr double kEndless = std::numeric_limits<double>::infinity();

 private:
  static constexpr unsigned kSeed = 20261123;
  std::mt19937_64 random_{kSeed};
  testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
};

TEST_F(RandomMotion, KeepsItsLimitsWithoutAJump) {
  TrapezoidProfile profile;
  profile.place(0.0);
  double fastest = 0.0;  // what the velocity may be; it falls to its limit with the deceleration
  double steepest = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    if (by_chance(0.01)) {
      const double before = profile.position();
      const double speed = profile.velocity();
      const double deceleration = profile.limits().deceleration;
      order(profile);
      ASSERT_EQ(profile.velocity(), speed);
      ASSERT_NEAR(profile.position(), before, 1e-9 + 1e-15 * std::abs(before));
      steepest = std::max({profile.limits().acceleration, profile.limits().deceleration, deceleration});
      fastest = std::max(std::abs(speed), profile.limits().velocity);
    }
    const double before = profile.position();
    const double speed = profile.velocity();
    profile.advance(kCycle);

    ASSERT_LE(std::abs(profile.velocity()), fastest * (1.0 + 1e-12)) << i;
    ASSERT_LE(std::abs(profile.acceleration()), steepest * (1.0 + 1e-6)) << i;
    ASSERT_LE(std::abs(profile.velocity() - speed), steepest * kCycle * (1.0 + 1e-6) + 1e-9) << i;
    const double mean = 0.5 * (profile.velocity() + speed) * kCycle;
    ASSERT_NEAR(profile.position() - before, mean, 0.25 * steepest * kCycle * kCycle + 2e-9) << i;
    if (std::abs(profile.velocity()) <= profile.limits().velocity)
      fastest = std::min(fastest, std::max(profile.limits().velocity, std::abs(profile.velocity())));
  }
}

TEST_F(RandomMotion, EndsExactlyAtItsTargetInTheLeastTime) {
  for (int i = 0; i < 20'000; ++i) {
    TrapezoidProfile profile;
    const double start = std::round(between(-1e6, 1e6));
    const double way = (by_chance(0.5) ? 1.0 : -1.0) * std::ceil(of_size(0.0, 6.0));
    const MotionLimits given{of_size(2.0, 5.7), of_size(3.0, 6.0), of_size(3.0, 6.0)};
    profile.place(start);
    profile.move_to(start + way, given);
    const auto end = profile.advance(1e6, false, true);

    const double a = given.acceleration;
    const double d = given.deceleration;
    const double peak = std::min(given.velocity, std::sqrt(2.0 * std::abs(way) * a * d / (a + d)));
    const double cruise = std::abs(way) - 0.5 * peak * peak * (1.0 / a + 1.0 / d);
    const double least = peak / a + peak / d + std::max(0.0, cruise) / peak;
    ASSERT_EQ(end.event, Event::Standstill);
    ASSERT_EQ(profile.position(), start + way);
    ASSERT_EQ(profile.velocity(), 0.0);
    ASSERT_NEAR(1e6 - end.left, least, 1e-9 + 1e-12 * least);
  }
}

TEST_F(RandomMotion, ReachesTheTargetAfterAnyOrders) {
  for (int i = 0; i < 20'000; ++i) {
    TrapezoidProfile profile;
    profile.place(0.0);
    for (int orders = 0; orders < 4; ++orders) {
      order(profile);
      profile.advance(of_size(-5.0, 0.0));
    }
    const double goal = std::round(profile.position() + between(-1e4, 1e4));
    profile.move_to(goal, {of_size(2.0, 5.7), of_size(3.0, 6.0), of_size(3.0, 6.0)});
    profile.advance(1e6);
    ASSERT_EQ(profile.position(), goal) << i;
    ASSERT_TRUE(profile.has_arrived()) << i;
  }
}

TEST_F(RandomMotion, DependsOnNoLengthOfCycle) {
  for (int i = 0; i < 1000; ++i) {
    TrapezoidProfile once;
    once.place(0.0);
    order(once);
    once.advance(of_size(-4.0, 0.0));
    once.move_to(target(once), {of_size(2.0, 5.0), of_size(4.0, 6.0), of_size(4.0, 6.0)});
    TrapezoidProfile often = once;

    once.advance(1.0);
    for (int cycle = 0; cycle < 1000; ++cycle) often.advance(kCycle);
    ASSERT_NEAR(once.position(), often.position(), 1e-9) << i;
    ASSERT_NEAR(once.velocity(), often.velocity(), 1e-7) << i;
  }
}

}  // namespace
}  // namespace drive
