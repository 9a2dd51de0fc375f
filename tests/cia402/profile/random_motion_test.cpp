// Positionings by chance: continuous, within their limits, exactly to their targets, and as fast as can be.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cia402/base/demand.hpp"
#include "cia402/motion/position_profile.hpp"
#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

class RandomMotion : public testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>{low, high}(random_); }
  /// Between 10^@p low and 10^@p high.
  double of_size(double low, double high) { return std::pow(10.0, between(low, high)); }
  bool by_chance(double share) { return between(0.0, 1.0) < share; }
  double sign() { return by_chance(0.5) ? 1.0 : -1.0; }

  ProfileLimits jerk_limits() {
    return {.velocity = of_size(2.0, 5.0),
            .acceleration = of_size(3.0, 6.0),
            .deceleration = of_size(3.0, 6.0),
            .jerk = of_size(4.0, 8.0)};
  }
  ProfileLimits any_limits() {
    ProfileLimits limits = jerk_limits();
    if (by_chance(0.5)) limits.jerk = 0.0;
    return limits;
  }
  double target_near(const PositionProfile& profile) {
    return std::round(profile.position() + sign() * of_size(-1.0, 5.0));
  }

 private:
  static constexpr unsigned kSeed = 20270402;
  std::mt19937_64 random_{kSeed};
  testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
};

TEST_F(RandomMotion, IsContinuousThroughEveryOrder) {
  PositionProfile profile;
  profile.place(0.0);
  double steepest = 0.0;  // of the orders that may still be in force
  double sharpest = 0.0;  // the same; 0 = a trapezoid
  for (int i = 0; i < 400'000; ++i) {
    if (by_chance(0.01)) {
      const PositionProfile before = profile;
      const ProfileLimits limits = any_limits();
      profile.move_to(target_near(profile), limits, by_chance(0.2) ? sign() * of_size(1.0, 5.0) : 0.0);
      ASSERT_NEAR(profile.position(), before.position(), 1e-8) << i;
      ASSERT_NEAR(profile.velocity(), before.velocity(), 1e-12 * std::abs(before.velocity())) << i;
      if (sharpest > 0.0 && limits.jerk > 0.0) {
        ASSERT_NEAR(profile.acceleration(), before.acceleration(), 1e-3) << i;
      }
      sharpest = limits.jerk > 0.0 ? std::max(sharpest, limits.jerk) : 0.0;
      steepest = std::max({steepest, limits.acceleration, limits.deceleration});
    }
    const PositionProfile before = profile;
    for (double left = kCycle; left > 0.0;) left = profile.advance(left).left;
    const double change = profile.velocity() - before.velocity();
    ASSERT_LE(std::abs(change), steepest * kCycle * (1.0 + 1e-6) + 1e-3) << i;
    const double mean = 0.5 * (profile.velocity() + before.velocity()) * kCycle;
    ASSERT_NEAR(profile.position() - before.position(), mean, 0.3 * steepest * kCycle * kCycle + 1e-5) << i;
    if (sharpest > 0.0) {
      const double jump = std::abs(profile.acceleration() - before.acceleration());
      ASSERT_LE(jump, sharpest * kCycle * (1.0 + 1e-6) + 1e-3) << i;
    }
    if (profile.stands()) steepest = 0.0;
  }
}

TEST_F(RandomMotion, ReachesItsTargetAfterAnyOrders) {
  for (int i = 0; i < 30'000; ++i) {
    PositionProfile profile;
    profile.place(std::round(between(-1e9, 1e9)), by_chance(0.3) ? sign() * of_size(0.0, 5.0) : 0.0);
    for (int orders = 0; orders < 4; ++orders) {
      profile.move_to(target_near(profile), any_limits());
      profile.advance(of_size(-5.0, 0.0));
    }
    const double goal = target_near(profile);
    const ProfileLimits limits = any_limits();
    profile.move_to(goal, limits);
    for (int events = 0; events < 4 && !profile.has_arrived(); ++events) profile.advance(1e7);
    ASSERT_EQ(profile.position(), goal) << i;
    ASSERT_EQ(profile.velocity(), 0.0) << i;
    ASSERT_TRUE(profile.has_arrived()) << i;
  }
}

TEST_F(RandomMotion, IsThatOfTheTextbookFromRestToRest) {
  for (int i = 0; i < 30'000; ++i) {
    ProfileLimits limits = jerk_limits();
    const double a = limits.deceleration = limits.acceleration;
    const double j = limits.jerk;
    const double way = of_size(-2.0, 6.0);
    PositionProfile profile;
    profile.place(1000.0);
    profile.move_to(1000.0 + sign() * way, limits);
    const ProfileAdvance end = profile.advance(1e7);
    ASSERT_EQ(end.event, ProfileEvent::Arrived);

    double peak = limits.velocity;  // and how long it takes to get there
    const auto rise = [&](double v) { return v >= a * a / j ? v / a + a / j : 2.0 * std::sqrt(v / j); };
    if (peak * rise(peak) > way) {
      const double full = -0.5 * a * a / j + std::sqrt(0.25 * a * a * a * a / (j * j) + a * way);
      peak = full >= a * a / j ? full : std::cbrt(0.25 * way * way * j);
    }
    const double least = 2.0 * rise(peak) + std::max(0.0, way - peak * rise(peak)) / peak;
    ASSERT_NEAR(1e7 - end.left, least, 1e-8 + 1e-9 * least) << i;
  }
}

TEST_F(RandomMotion, KeepsItsLimits) {
  for (int i = 0; i < 3000; ++i) {
    const ProfileLimits limits = jerk_limits();
    PositionProfile profile;
    profile.place(0.0);
    const double target = sign() * of_size(-1.0, 5.0);
    profile.move_to(target, limits);
    const double most = std::max(limits.acceleration, limits.deceleration);
    double step = of_size(-5.0, -1.0);
    for (int n = 0; n < 2000 && !profile.stands(); ++n, step *= 1.003) {
      const double before = std::abs(profile.velocity());
      profile.advance(step);
      ASSERT_LE(std::abs(profile.velocity()), limits.velocity * (1.0 + 1e-9)) << i;
      ASSERT_LE(std::abs(profile.acceleration()), most * (1.0 + 1e-9)) << i;
      ASSERT_GE(target * profile.velocity(), -1e-6 * std::abs(target)) << i;
      ASSERT_LE(std::abs(profile.position()), std::abs(target) * (1.0 + 1e-9)) << i;
      ASSERT_LE(std::abs(profile.velocity()) - before, limits.acceleration * step * (1.0 + 1e-9) + 1e-6) << i;
      ASSERT_GE(std::abs(profile.velocity()) - before, -limits.deceleration * step * (1.0 + 1e-9) - 1e-6) << i;
    }
  }
}

/// Whatever is reachable without turning back is reached so.
TEST_F(RandomMotion, OvershootsOnlyWhatItCannotReach) {
  for (int i = 0; i < 20'000; ++i) {
    PositionProfile profile;
    profile.place(0.0);
    const ProfileLimits limits = any_limits();
    profile.move_to(1e7, limits);
    profile.advance(of_size(-3.0, 0.5));
    const double room = profile.stopping_way(limits) * (1.0 + 1e-6) + 1e-3;
    const double target = profile.position() + room + of_size(-4.0, 5.0);
    ProfileLimits next = any_limits();
    next.deceleration = by_chance(0.5) ? limits.deceleration : next.deceleration;
    next.jerk = by_chance(0.5) ? limits.jerk : next.jerk;
    const bool comparable = (next.jerk > 0.0) == (limits.jerk > 0.0);
    profile.move_to(target, next);
    double before = profile.position();
    for (double step = 1e-4; comparable && !profile.stands(); step *= 1.02) {
      profile.advance(step);
      ASSERT_GE(profile.position(), before - 1e-6) << i;
      ASSERT_LE(profile.position(), target + 1e-6) << i;
      before = profile.position();
    }
  }
}

TEST_F(RandomMotion, DependsOnNoLengthOfCycle) {
  for (int i = 0; i < 1000; ++i) {
    PositionProfile once;
    once.place(0.0);
    once.move_to(target_near(once), any_limits());
    once.advance(of_size(-4.0, 0.0));
    once.move_to(target_near(once), any_limits(), by_chance(0.3) ? sign() * of_size(1.0, 4.0) : 0.0);
    PositionProfile often = once;
    if (once.advance(1.0).event == ProfileEvent::Passed) continue;
    for (int cycle = 0; cycle < 1000; ++cycle) often.advance(kCycle);
    ASSERT_NEAR(once.position(), often.position(), 1e-5) << i;
    ASSERT_NEAR(once.velocity(), often.velocity(), 1e-5 * (1.0 + std::abs(once.velocity()))) << i;
  }
}

/// Random set-points through the mode: the demand never jumps, and the last target is where it ends.
TEST_F(RandomMotion, OfTheModeIsContinuousAndEndsAtItsLastTarget) {
  for (int i = 0; i < 300; ++i) {
    PositionedAxis axis;
    axis.limits = {.velocity = 1e5, .acceleration = 1e6, .deceleration = 1e6};
    double last = 0.0;
    for (int n = 0; n < 20; ++n) {
      const ProfileLimits limits = any_limits();
      axis.settings.motion_profile = limits.jerk > 0.0 ? 3 : 0;
      axis.settings.jerk = limits.jerk;
      axis.settings.velocity = limits.velocity;
      axis.settings.acceleration = limits.acceleration;
      axis.settings.deceleration = limits.deceleration;
      axis.write(kEnabled);
      const bool is_free = !axis.acknowledges();
      const double target = std::round(sign() * of_size(0.0, 4.0));
      const bool immediately = by_chance(0.4);
      axis.give(target,
                static_cast<std::uint16_t>((immediately ? kImmediately : 0) | (by_chance(0.5) ? kOnSetPoint : 0)));
      if (is_free || immediately) last = target;
      for (int cycles = static_cast<int>(of_size(0.0, 2.5)); cycles > 0; --cycles) {
        const double from = axis.position();
        const double speed = axis.velocity();
        axis.cycle();
        ASSERT_LE(std::abs(axis.velocity() - speed), 1e6 * kCycle * (1.0 + 1e-6) + 1e-3) << i;
        ASSERT_NEAR(axis.position() - from, 0.5 * (axis.velocity() + speed) * kCycle, 0.51) << i;
      }
    }
    axis.run_until([&] { return axis.is_reached() && axis.mode.target() == last; }, 2'000'000);
    ASSERT_EQ(axis.position(), last) << i;
  }
}

}  // namespace
}  // namespace cia402
