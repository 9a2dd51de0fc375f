// csp with synchronous set-points of which some do not come.
#include <gtest/gtest.h>

#include "tests/cia402/cyclic/position_rig.hpp"

namespace cia402 {
namespace {

constexpr double kSlope = 100'000.0;  // units/s: 1000 a period

/// Set-points 1000 · k come every 10 ms up to k = 4, so at 50 ms the first one is missing: the demand is 4000.
struct LeftRig : PositionRig {
  LeftRig() {
    settings.is_supervised = true;
    for (int k = 0; k <= 4; ++k) set_point(1000.0 * k, k * 10ms, {.velocity = 5.0, .torque = 0.5});
  }
};

struct MissingSetPoints : testing::Test {
  LeftRig rig;
};

TEST_F(MissingSetPoints, AreExtrapolatedOnce) {
  EXPECT_EQ(rig.position_at(50ms), 4000.0);
  EXPECT_DOUBLE_EQ(rig.velocity_at(50ms), kSlope);
  EXPECT_NEAR(rig.position_at(55ms), 4500.0, 1e-9);
  EXPECT_TRUE(rig.follows());
  EXPECT_NEAR(rig.position_at(59ms), 4900.0, 1e-9);
  EXPECT_TRUE(rig.follows());
}

TEST_F(MissingSetPoints, StopTheAxisWith6085hFromTheSecondOn) {
  EXPECT_NEAR(rig.position_at(60ms), 5000.0, 1e-9);
  EXPECT_FALSE(rig.follows());
  EXPECT_NEAR(rig.velocity_at(61ms), kSlope - 2000.0, 1e-6);
  EXPECT_NEAR(rig.position_at(61ms), 5000.0 + 99.0, 1e-6);
  EXPECT_EQ(rig.velocity_at(110ms), 0.0);
  EXPECT_NEAR(rig.position_at(110ms), 5000.0 + 2500.0, 1e-6);
  EXPECT_NEAR(rig.position_at(200ms), 5000.0 + 2500.0, 1e-6);
  EXPECT_FALSE(rig.follows());
}

TEST_F(MissingSetPoints, AreNotFedForwardWhileTheAxisStops) {
  rig.timeline.run_to(61ms);
  EXPECT_EQ(rig.timeline.demand_at(59ms).velocity_offset, 5.0);
  EXPECT_EQ(rig.timeline.demand_at(61ms).velocity_offset, 0.0);
  EXPECT_EQ(rig.timeline.demand_at(61ms).torque_offset, 0.5);
}

TEST_F(MissingSetPoints, AreLostWithTheThirdInARow) {
  rig.timeline.run_to(70ms);
  EXPECT_FALSE(rig.mode.is_lost());
  rig.timeline.run_to(71ms);
  EXPECT_TRUE(rig.mode.is_lost());
}

TEST_F(MissingSetPoints, AreLostAfterAsManyAsTheSettingsSay) {
  for (const std::uint32_t count : {1U, 2U, 3U, 7U}) {
    LeftRig fresh;
    fresh.settings.missed_set_points = count;
    const TimeNs due = 40ms + count * 10ms;
    fresh.timeline.run_to(due);
    EXPECT_FALSE(fresh.mode.is_lost()) << count;
    fresh.timeline.run_to(due + 1ms);
    EXPECT_TRUE(fresh.mode.is_lost()) << count;
  }
  rig.settings.missed_set_points = 0;
  rig.timeline.run_to(10s);
  EXPECT_FALSE(rig.mode.is_lost());
}

TEST_F(MissingSetPoints, AreForgottenWithTheNextOneThatComes) {
  for (int round = 0; round < 5; ++round) {
    const TimeNs time = rig.timeline.now() + 20ms + (round == 0 ? 10ms : 0ms);  // two are missing
    rig.set_point(1000.0 * static_cast<double>(time / 10ms), time);
    EXPECT_FALSE(rig.mode.is_lost());
    EXPECT_TRUE(rig.follows());
    rig.timeline.run_to(time + 10ms);
    EXPECT_NEAR(rig.mode.demand().motion.position, 1000.0 * static_cast<double>(time / 10ms), 1e-9);
  }
}

TEST_F(MissingSetPoints, LetALateOneStartFromThePresentDemand) {
  rig.timeline.run_to(60ms);
  rig.set_point(6000.0, 64300us);
  const double start = 5000.0 + kSlope * 4.3e-3 - 0.5 * 2e6 * 4.3e-3 * 4.3e-3;
  EXPECT_NEAR(rig.mode.demand().motion.position, start, 1e-6);
  EXPECT_TRUE(rig.follows());
  EXPECT_EQ(rig.timeline.now(), 64ms);
  EXPECT_NEAR(rig.position_at(65ms), start + (6000.0 - start) * 0.07, 1e-6);
  EXPECT_NEAR(rig.position_at(75ms), 6000.0 + (6000.0 - start) * 0.07, 1e-6);  // extrapolated again
}

TEST_F(MissingSetPoints, LetOneComeLateWithinTheFirstPeriod) {
  rig.set_point(5000.0, 53ms);
  EXPECT_NEAR(rig.mode.demand().motion.position, 4300.0, 1e-9);
  EXPECT_NEAR(rig.position_at(63ms), 5000.0, 1e-9);
}

TEST_F(MissingSetPoints, ChangeNothingBeforeTheFirstOne) {
  rig.mode.enter({.position = 10.0}, kEnabled);
  rig.timeline.run_to(10s);
  EXPECT_EQ(rig.mode.demand().motion.position, 10.0);
  EXPECT_FALSE(rig.mode.is_lost());
}

TEST_F(MissingSetPoints, ChangeNothingWhereNobodyHasToSendThem) {
  rig.settings.is_supervised = false;
  EXPECT_EQ(rig.position_at(10s), 4000.0);
  EXPECT_TRUE(rig.follows());
  EXPECT_FALSE(rig.mode.is_lost());
}

TEST_F(MissingSetPoints, AreExtrapolatedFromAStandstillAsAStandstill) {
  rig.set_point(4000.0, 50ms);
  EXPECT_EQ(rig.position_at(60ms), 4000.0);
  EXPECT_EQ(rig.position_at(80ms), 4000.0);
  EXPECT_FALSE(rig.follows());
  rig.timeline.run_to(81ms);
  EXPECT_TRUE(rig.mode.is_lost());
}

TEST_F(MissingSetPoints, AreTimedFromTheTrueInstant) {
  rig.set_point(5000.0, 50400us);  // from 4040 to 5000
  const double slope = (5000.0 - 4040.0) / 10e-3;
  EXPECT_NEAR(rig.position_at(70ms), 5000.0 + slope * 9.6e-3, 1e-6);
  EXPECT_NEAR(rig.velocity_at(70ms), slope, 1e-6);
  EXPECT_NEAR(rig.velocity_at(71ms), slope - 2e6 * 0.6e-3, 1e-6);
  rig.timeline.run_to(81ms);
  EXPECT_FALSE(rig.mode.is_lost());
  rig.timeline.run_to(82ms);
  EXPECT_TRUE(rig.mode.is_lost());
}

}  // namespace
}  // namespace cia402
