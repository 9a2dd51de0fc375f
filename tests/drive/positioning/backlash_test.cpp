// The play between encoder and load (p2583, r2667).
#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

TEST(Backlash, IsTakenBackAfterAReversal) {
  SensedAxis axis;
  axis.position.settings.backlash = 50;
  axis.turn(100);
  axis.slice.is_referenced = true;
  axis.stay();
  axis.turn(-30);
  EXPECT_EQ(axis.shown(), 100) << "the load has not moved yet";
  EXPECT_EQ(axis.position.backlash_compensation(), 30.0);
  axis.turn(-30);
  EXPECT_EQ(axis.shown(), 90);
  EXPECT_EQ(axis.position.backlash_compensation(), 50.0);
  axis.turn(40);
  EXPECT_EQ(axis.shown(), 90);
  axis.turn(20);
  EXPECT_EQ(axis.shown(), 100);
  EXPECT_EQ(axis.position.backlash_compensation(), 0.0);
}

TEST(Backlash, CountsFromTheSideOfTheReference) {
  SensedAxis axis;
  axis.position.settings.backlash = 50;
  axis.turn(-100);
  axis.slice.is_referenced = true;
  axis.turn(-10);
  EXPECT_EQ(axis.shown(), -110);
  axis.turn(60);
  EXPECT_EQ(axis.shown(), -100);
  EXPECT_EQ(axis.position.backlash_compensation(), -50.0);
}

TEST(Backlash, CountsWithoutAReferenceNothing) {
  SensedAxis axis;
  axis.position.settings.backlash = 50;
  axis.turn(100);
  axis.turn(-30);
  EXPECT_EQ(axis.shown(), 70);
  axis.slice.is_referenced = true;
  axis.turn(20);
  EXPECT_EQ(axis.shown(), 70);
  axis.slice.is_referenced = false;
  axis.stay();
  EXPECT_EQ(axis.shown(), 70) << "no jump";
}

TEST(Backlash, OfTheOtherSignHasTheLoadMoveFirst) {
  SensedAxis axis;
  axis.position.settings.backlash = -50;
  axis.turn(100);
  axis.slice.is_referenced = true;
  axis.stay();
  axis.turn(-60);
  EXPECT_EQ(axis.shown(), -10);
}

}  // namespace
}  // namespace drive
