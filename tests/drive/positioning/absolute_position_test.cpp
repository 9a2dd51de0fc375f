// The position of an absolute encoder and its adjustment (p2507, p2525).
#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

/// An axis whose encoder tells 16 revolutions of 1000 increments apart and stands at @p place revolutions.
SensedAxis absolute_at(double place) {
  motor::EncoderData data = SensedAxis::encoder(motor::EncoderType::Absolute);
  data.start_position = place;
  return SensedAxis{data};
}

TEST(AbsolutePosition, IsKnownAtPowerOn) {
  SensedAxis axis = absolute_at(2.5);
  axis.stay();
  EXPECT_EQ(axis.shown(), 2500);
  EXPECT_FALSE(axis.position.adjusted());
  axis.turn(-3000);
  EXPECT_EQ(axis.shown(), -500);
  axis.position.power_on(axis.slice.counts);
  axis.stay();
  EXPECT_EQ(axis.shown(), 15'500) << "within the revolutions that the encoder tells apart";
}

TEST(AbsolutePosition, IsAdjustedToTheReferenceCoordinate) {
  for (const double coordinate : {0.0, 777.0, -1234.0, 15'999.0}) {
    SensedAxis axis = absolute_at(10.25);
    axis.turn(10);
    axis.position.settings.adjustment = ActualPosition::kStartAdjustment;
    axis.slice.reference_coordinate = coordinate;
    axis.stay();
    EXPECT_EQ(axis.shown(), static_cast<std::int64_t>(coordinate));
    EXPECT_EQ(axis.position.settings.adjustment, ActualPosition::kAdjusted);
    EXPECT_GE(axis.position.settings.adjustment_offset, 0.0);
    EXPECT_EQ(axis.position.status(), 0x0201);
    EXPECT_EQ(axis.position.encoder_status(0), 0x0201);
    EXPECT_TRUE(axis.position.adjustment_unsaved());
    axis.position.on_saved();
    EXPECT_FALSE(axis.position.adjustment_unsaved());
  }
}

TEST(AbsolutePosition, SurvivesPowerOffByItsParameters) {
  SensedAxis before = absolute_at(10.25);
  before.stay();
  before.position.settings.adjustment = ActualPosition::kStartAdjustment;
  before.slice.reference_coordinate = 100.0;
  before.stay();

  SensedAxis after = absolute_at(10.5);  // turned while it was off
  after.position.settings = before.position.settings;
  after.stay();
  EXPECT_EQ(after.shown(), 350);
  EXPECT_TRUE(after.position.adjusted());
  EXPECT_FALSE(after.position.adjustment_unsaved());
}

TEST(AbsolutePosition, RefusesACoordinateThatTheEncoderCannotTell) {
  SensedAxis axis = absolute_at(1.0);
  axis.stay();
  axis.position.settings.adjustment = ActualPosition::kStartAdjustment;
  axis.slice.reference_coordinate = 16'000.0;
  axis.stay();
  EXPECT_TRUE(axis.position.adjustment_refused());
  EXPECT_EQ(axis.position.largest_coordinate(), 15'999.0);
  EXPECT_EQ(axis.position.settings.adjustment, ActualPosition::kNotAdjusted);
  EXPECT_EQ(axis.shown(), 1000);
  axis.position.begin_cycle();
  EXPECT_FALSE(axis.position.adjustment_refused());
}

TEST(AbsolutePosition, LosesItsAdjustmentWithAnotherScale) {
  SensedAxis axis = absolute_at(1.0);
  axis.position.settings.adjustment = ActualPosition::kAdjusted;
  axis.stay();
  ASSERT_TRUE(axis.position.adjusted());
  axis.position.settings.gear_motor = 2;
  axis.stay();
  EXPECT_EQ(axis.position.settings.adjustment, ActualPosition::kNotAdjusted);
  EXPECT_FALSE(axis.position.adjusted());
  EXPECT_TRUE(axis.position.reference_lost());
  EXPECT_EQ(axis.shown(), 500);
}

TEST(AbsolutePosition, CannotBeAdjustedOfAnIncrementalEncoder) {
  SensedAxis axis;
  axis.position.settings.adjustment = ActualPosition::kStartAdjustment;
  axis.stay();
  EXPECT_EQ(axis.position.settings.adjustment, ActualPosition::kNotAdjusted);
  EXPECT_FALSE(axis.position.adjusted());
}

TEST(AbsolutePosition, FitsAModuloRangeOrSaysSo) {
  SensedAxis axis = absolute_at(0.0);
  axis.stay();
  EXPECT_FALSE(axis.position.multiturn_mismatch());
  axis.slice.modulo_range = 3000;
  axis.stay();
  EXPECT_TRUE(axis.position.multiturn_mismatch()) << "16 revolutions of 1000 LU";
  axis.slice.modulo_range = 4000;
  axis.stay();
  EXPECT_FALSE(axis.position.multiturn_mismatch());
  axis.position.settings.units_per_load = 999;
  axis.stay();
  EXPECT_TRUE(axis.position.multiturn_mismatch());
}

TEST(AbsolutePosition, BeyondThirtyTwoBitsComesRound) {
  motor::EncoderData data{.type = motor::EncoderType::Absolute, .revolutions = 65'535, .start_position = 60'000.0};
  SensedAxis axis{data};
  axis.position.settings.units_per_load = 100'000;  // 6·10⁹ LU from the zero of the disc
  axis.position.settings.adjustment = ActualPosition::kStartAdjustment;
  axis.slice.reference_coordinate = 12'345.0;
  axis.stay();
  EXPECT_EQ(axis.shown(), 12'345);
  SensedAxis again{data};
  again.position.settings = axis.position.settings;
  again.stay();
  EXPECT_EQ(again.shown(), 12'345);
  EXPECT_TRUE(again.position.position_valid());
}

}  // namespace
}  // namespace drive
