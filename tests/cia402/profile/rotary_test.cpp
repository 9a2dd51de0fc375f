#include <cstdint>

#include <gtest/gtest.h>

#include "cia402/modes/profile/set_point.hpp"
#include "cia402/motion/position_range.hpp"
#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

using Route = SetPoint::Route;

constexpr Span kCircle{-180.0, 179.0};  // 360 units

Limits rotary() {
  return {.velocity = 1e9, .acceleration = 1e9, .deceleration = 1e9, .range = kCircle};
}

/// The target of an axis that stands at @p from.
double target(Route route, double from, double position) {
  const SetPoint set_point{.route = route, .position = position};
  return target_of(set_point, {.target = from, .demand = from, .actual = from}, rotary()).position;
}

TEST(PositionRange, CountsTurns) {
  EXPECT_EQ(turns_before(0.0, kCircle), 0.0);
  EXPECT_EQ(turns_before(179.0, kCircle), 0.0);
  EXPECT_EQ(turns_before(179.49, kCircle), 0.0);
  EXPECT_EQ(turns_before(179.5, kCircle), 360.0);
  EXPECT_EQ(turns_before(-180.49, kCircle), 0.0);
  EXPECT_EQ(turns_before(-181.0, kCircle), -360.0);
  EXPECT_EQ(turns_before(3600.0, kCircle), 3600.0);
}

TEST(RotaryAxis, GoesTheWayOfItsOptions) {
  struct Row {
    Route route;
    double from, position, target;
  };
  for (const Row& row : {
           Row{Route::Linear, 350.0, 20.0, 380.0},     // shown -10
           Row{Route::Linear, 100.0, -100.0, -100.0},  // not over the end of the range
           Row{Route::Linear, 0.0, 1000.0, 1000.0},    // more than a turn
           Row{Route::Positive, 100.0, 90.0, 450.0}, Row{Route::Positive, 100.0, 110.0, 110.0},
           Row{Route::Positive, 100.0, 100.0, 100.0}, Row{Route::Positive, 100.3, 100.0, 100.0},  // shown 100
           Row{Route::Negative, 100.0, 110.0, -250.0}, Row{Route::Negative, 100.0, 90.0, 90.0},
           Row{Route::Negative, 100.0, 100.0, 100.0}, Row{Route::Negative, 99.7, 100.0, 100.0},
           Row{Route::Shortest, 100.0, -100.0, 260.0}, Row{Route::Shortest, -100.0, 100.0, -260.0},
           Row{Route::Shortest, 0.0, -180.0, 180.0},  // a tie is positive
           Row{Route::Shortest, 10.0, -170.0, 190.0}, Row{Route::Shortest, 7210.0, 5.0, 7205.0},
           Row{Route::Positive, -7210.0, 5.0, -7195.0},
           Row{Route::Shortest, 0.0, 725.0, 5.0},  // a coordinate beyond the range is that within
       })
    EXPECT_EQ(target(row.route, row.from, row.position), row.target)
        << static_cast<int>(row.route) << " from " << row.from << " to " << row.position;
}

TEST(RotaryAxis, DoesNotTurnBackWhereItMayGoOneWayOnly) {
  PositionedAxis axis;
  axis.limits = rotary();
  axis.settings.option_code = 2U << 6U;
  axis.give(170.0);
  axis.run(150);
  const double at = axis.position();
  ASSERT_GT(axis.velocity(), 500.0);
  axis.give(at + 1.0, kImmediately);
  double before = at;
  axis.run_until([&] {
    EXPECT_GE(axis.position(), before);
    before = axis.position();
    return axis.is_reached();
  });
  EXPECT_EQ(axis.position(), at + 361.0);
}

TEST(RotaryAxis, ReachesTheSameTargetAgainWhileItBrakes) {
  for (const std::int16_t profile : {std::int16_t{0}, std::int16_t{3}}) {
    PositionedAxis axis;
    axis.limits = rotary();
    axis.settings.option_code = 2U << 6U;
    axis.settings.motion_profile = profile;
    axis.give(170.0);
    axis.run_until(
        [&] {
          axis.give(170.0, kImmediately);
          axis.cycle();
          return axis.is_reached();
        },
        5000);
    EXPECT_EQ(axis.position(), 170.0) << profile;
  }
}

TEST(RotaryAxis, StaysWithinSoftwareLimitsOfItsTurn) {
  PositionedAxis axis{3600.0};
  axis.limits = rotary();
  axis.limits.software = Span{-90.0, 90.0};
  axis.settings.option_code = 3U << 6U;
  axis.give(170.0);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 3690.0);
  EXPECT_TRUE(axis.demand.is_limited);
  axis.limits.software = Span{-1000.0, 1000.0};  // wider than the range
  axis.give(-170.0);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 3790.0);
}

TEST(RotaryAxis, LosesNothingInManyTurns) {
  PositionedAxis axis;
  axis.limits = rotary();
  axis.settings.velocity = axis.settings.acceleration = axis.settings.deceleration = 1e6;
  axis.settings.option_code = 2U << 6U;
  for (int i = 1; i <= 3000; ++i) {
    axis.give(static_cast<double>((i * 120) % 360 - 180));
    axis.run_until_reached();
  }
  EXPECT_EQ(axis.position(), 3000 * 120.0 + 180.0);  // the first way is 300
}

}  // namespace
}  // namespace cia402
