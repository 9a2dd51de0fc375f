// ip: from set-points to the demand, and its bits.
#include "cia402/modes/cyclic/interpolated_position.hpp"

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/timeline.hpp"

namespace cia402 {
namespace {

constexpr std::uint16_t kEnabled = 0x000F;
constexpr std::uint16_t kInterpolating = 0x001F;
constexpr std::uint16_t kHalted = 0x011F;

/// ip with an axis that is where the demand is, T = 10 ms.
struct Interpolation : testing::Test {
  Interpolation() { mode.enter({}, kEnabled); }

  Demand cycle() {
    const Demand demand = mode.cycle(settings, limits, {.position = last + error});
    last = demand.motion.position;
    return demand;
  }
  void set_point(double position, TimeNs time) {
    mode.set_point(position, timeline.instant(time), settings, limits);
  }
  double position_at(TimeNs time) {
    timeline.run_to(time);
    return timeline.demand_at(time).motion.position;
  }
  bool has_reached() const { return mode.bits(false).bit_10; }
  bool is_active() const { return mode.bits(false).bit_12; }

  CyclicSettings settings{.period = 10ms,
                          .deceleration = 1e6,
                          .quick_stop_deceleration = 2e6,
                          .position_window = 5.0,
                          .position_window_time = 10ms};
  Limits limits{.velocity = 1e9, .acceleration = 1e9, .deceleration = 1e9};
  double error = 0.0;
  double last = 0.0;
  InterpolatedPosition mode;
  Timeline timeline{[this] { return cycle(); }};
};

TEST_F(Interpolation, FollowsSetPointsWhileBit4IsSetOnly) {
  set_point(100.0, 0ms);
  EXPECT_FALSE(is_active());
  EXPECT_EQ(position_at(20ms), 0.0);
  mode.controlword(kInterpolating);
  EXPECT_TRUE(is_active());
  EXPECT_EQ(position_at(40ms), 0.0);  // the set-point from before does not count
  set_point(100.0, 40ms);
  EXPECT_NEAR(position_at(45ms), 50.0, 1e-9);
  EXPECT_EQ(position_at(50ms), 100.0);
  EXPECT_EQ(timeline.demand_at(50ms).lead, Lead::Position);
}

TEST_F(Interpolation, IsEnabledByABit4ThatIsSetAlready) {
  mode.enter({.position = 30.0}, kInterpolating);
  EXPECT_TRUE(is_active());
  EXPECT_EQ(position_at(10ms), 30.0);
  set_point(130.0, 10ms);
  EXPECT_EQ(position_at(20ms), 130.0);
}

TEST_F(Interpolation, BrakesWith6084hWithoutBit4) {
  mode.controlword(kInterpolating);
  set_point(100.0, 0ms);  // 10 a ms
  timeline.run_to(5ms);
  mode.controlword(kEnabled);
  EXPECT_FALSE(is_active());
  set_point(500.0, 5ms);
  const double rest = 50.0 + 0.5 * 1e4 * 1e4 / 1e6;
  EXPECT_NEAR(position_at(6ms), 50.0 + 9.5, 1e-9);
  EXPECT_NEAR(position_at(100ms), rest, 1e-9);
  mode.controlword(kInterpolating);
  EXPECT_NEAR(position_at(200ms), rest, 1e-9);
  set_point(200.0, 200ms);
  EXPECT_EQ(position_at(210ms), 200.0);
}

TEST_F(Interpolation, GoesOnFromTheBrakingDemand) {
  mode.controlword(kInterpolating);
  set_point(100.0, 0ms);
  timeline.run_to(5ms);
  mode.controlword(kEnabled);
  timeline.run_to(6ms);
  mode.controlword(kInterpolating);
  set_point(100.0, 6ms);
  EXPECT_NEAR(position_at(11ms), 59.5 + 0.5 * 40.5, 1e-9);
}

TEST_F(Interpolation, ReachesThePositionAfterTheTimeInTheWindow) {
  EXPECT_TRUE(has_reached());  // at rest on entry
  mode.controlword(kInterpolating);
  error = 6.0;
  set_point(100.0, 0ms);
  EXPECT_FALSE(has_reached());
  timeline.run_to(100ms);
  EXPECT_FALSE(has_reached());
  error = 5.0;
  timeline.run_to(110ms);
  EXPECT_FALSE(has_reached());
  timeline.run_to(111ms);
  EXPECT_TRUE(has_reached());
  set_point(100.0, 111ms);  // where it is
  EXPECT_TRUE(has_reached());
  error = -5.1;
  timeline.run_to(112ms);
  EXPECT_FALSE(has_reached());
  error = 0.0;
  settings.position_window_time = 0ms;
  timeline.run_to(113ms);
  EXPECT_TRUE(has_reached());
  set_point(101.0, 113ms);
  EXPECT_FALSE(has_reached());
}

TEST_F(Interpolation, HasNotReachedWhatALimitKeepsItFrom) {
  limits.software = Span{-50.0, 50.0};
  mode.controlword(kInterpolating);
  set_point(100.0, 0ms);
  timeline.run_to(1s);
  EXPECT_TRUE(mode.demand().is_limited);
  EXPECT_FALSE(has_reached());
  EXPECT_TRUE(is_active());
}

TEST_F(Interpolation, IgnoresSetPointsInAHalt) {
  mode.controlword(kInterpolating);
  set_point(100.0, 0ms);
  timeline.run_to(5ms);
  mode.controlword(kHalted);
  EXPECT_FALSE(is_active());
  set_point(0.0, 5ms);
  mode.controlword(kInterpolating);
  EXPECT_FALSE(is_active());
  mode.resume({.position = 60.0});
  EXPECT_TRUE(is_active());
  EXPECT_EQ(position_at(50ms), 60.0);
  set_point(70.0, 50ms);
  EXPECT_EQ(position_at(60ms), 70.0);
}

TEST_F(Interpolation, IsSupervisedLikeCsp) {
  settings.is_supervised = true;
  mode.controlword(kInterpolating);
  timeline.run_to(100ms);
  EXPECT_FALSE(mode.is_lost());
  set_point(100.0, 100ms);
  EXPECT_NEAR(position_at(120ms), 200.0, 1e-9);
  EXPECT_FALSE(is_active());
  EXPECT_NEAR(position_at(200ms), 200.0 + 0.5 * 1e4 * 1e4 / 2e6, 1e-9);
  EXPECT_TRUE(mode.is_lost());
  set_point(0.0, 200ms);
  EXPECT_TRUE(is_active());
  EXPECT_FALSE(mode.is_lost());
}

TEST_F(Interpolation, HasNoBitsWhenItIsLeft) {
  mode.controlword(kInterpolating);
  EXPECT_EQ(mode.bits(true), (ModeBits{.bit_10 = true, .bit_12 = true, .bit_13 = true}));
  mode.leave();
  EXPECT_EQ(mode.bits(true), ModeBits{});
}

}  // namespace
}  // namespace cia402
