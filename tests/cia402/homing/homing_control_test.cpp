// Start, interruption, halt and what 6041h shows of them.
#include <string>

#include <gtest/gtest.h>

#include "tests/cia402/homing/homing_axis.hpp"

namespace cia402 {
namespace {

constexpr int kToEdge = 24;  // to the left edge of H, upwards

/// H from 2 to 4 load revolutions; homing starts at 0.
struct HomingControl : testing::Test {
  static TravelSwitches switches() {
    TravelSwitches fitted;
    fitted.set(Signal::Home, {.from = 2.0, .to = 4.0});
    return fitted;
  }

  HomingAxis axis{switches()};

  /// In the search, at full speed.
  void search() {
    axis.start(kToEdge);
    axis.cycles(120);
    ASSERT_EQ(axis.bits(), "000");
    ASSERT_EQ(axis.speed(), 20.0);
  }
  /// A halt from outside, until rest.
  void halt() {
    axis.write(kHaltedStart);
    for (int i = 0; i < 1000 && axis.demand().velocity > 0.0; ++i) {
      EXPECT_EQ(axis.bits(true), "000");
      axis.brake_outside(100.0 * kTurn);
    }
  }
};

TEST_F(HomingControl, ShowsNotHomedOnEntry) {
  EXPECT_EQ(axis.bits(), "001");
  axis.cycles(100);
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_EQ(axis.counts(), 0);
  EXPECT_FALSE(axis.homing.is_homed());
}

TEST_F(HomingControl, ShowsOnEntryThatThereIsAHome) {
  axis.start(kToEdge);
  EXPECT_EQ(axis.run(), "000 010 011");
  axis.homing.leave(HomingExit::OtherMode);
  axis.homing.enter(axis.demand());
  EXPECT_EQ(axis.bits(), "011");

  HomingAxis absolute{switches()};
  absolute.homing.set_homed(true);
  EXPECT_EQ(absolute.bits(), "011");
}

TEST_F(HomingControl, StartsInTheUpdateOfTheEdge) {
  axis.settings.method = kToEdge;
  axis.write(kStart);
  EXPECT_EQ(axis.bits(), "000");
  EXPECT_EQ(axis.run(), "000 010 011");
  axis.write(kEnabled);
  EXPECT_EQ(axis.bits(), "011");
  axis.write(kStart);
  EXPECT_EQ(axis.bits(), "000");
}

TEST_F(HomingControl, DoesNotStartByABitThatWasThereOnEntry) {
  axis.settings.method = kToEdge;
  axis.homing.controlword(kStart, kStart, axis.settings);
  axis.cycles(100);
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_EQ(axis.counts(), 0);
}

TEST_F(HomingControl, TakesItsSettingsAtTheStart) {
  axis.start(kToEdge);
  axis.settings = {};
  EXPECT_EQ(axis.run(), "000 010 011");
  ASSERT_TRUE(axis.home());
  EXPECT_NEAR(*axis.home(), 2.0 * kTurn, 1e-6);
}

TEST_F(HomingControl, NeverShowsTargetReachedWhileItTurnsRound) {
  axis.settings.method = 25;  // beyond H and back
  axis.write(kStart);
  EXPECT_EQ(axis.run(), "000 010 011");
  EXPECT_EQ(axis.reversals(), 1);
}

TEST_F(HomingControl, IsInterruptedByBit4) {
  search();
  axis.write(kEnabled);
  EXPECT_EQ(axis.bits(), "000");
  const std::int64_t at = axis.counts();
  EXPECT_EQ(axis.run(), "000 001");
  EXPECT_NEAR(static_cast<double>(axis.counts() - at) / kTurn, 20.0 * 20.0 / 2.0 / 200.0, 0.05) << "by 609Ah";
  axis.cycles(500);
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_FALSE(axis.home());
  EXPECT_FALSE(axis.homing.is_homed());
}

TEST_F(HomingControl, StartsAgainWhileItStillBrakes) {
  search();
  axis.write(kEnabled);
  axis.cycles(50);
  axis.write(kStart);
  EXPECT_EQ(axis.run(), "000 010 011");
  ASSERT_TRUE(axis.home());
  EXPECT_NEAR(*axis.home(), 2.0 * kTurn, 1e-6);
}

TEST_F(HomingControl, KeepsItsBitsWhenBit4FallsAfterTheEvent) {
  axis.start(kToEdge);
  while (axis.bits() == "000") axis.cycle();
  ASSERT_EQ(axis.bits(), "010");
  axis.write(kEnabled);
  EXPECT_EQ(axis.run(), "010 011");
}

TEST_F(HomingControl, IsInterruptedByHalt) {
  search();
  halt();
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_FALSE(axis.homing.is_running());
}

TEST_F(HomingControl, StartsAnewWhenHaltIsReleased) {
  search();
  halt();
  axis.write(kStart);
  axis.homing.resume(axis.demand());
  EXPECT_EQ(axis.run(), "000 010 011");
  ASSERT_TRUE(axis.home());
  EXPECT_NEAR(*axis.home(), 2.0 * kTurn, 1e-6);
}

TEST_F(HomingControl, StartsAnewInWhateverOrderItIsTold) {
  search();
  halt();
  axis.homing.resume(axis.demand());
  axis.write(kStart);
  EXPECT_EQ(axis.run(), "000 010 011");
}

TEST_F(HomingControl, StaysWhereItIsWhenHaltIsReleasedWithoutBit4) {
  search();
  halt();
  axis.write(kEnabled);
  axis.homing.resume(axis.demand());
  const std::int64_t at = axis.counts();
  axis.cycles(500);
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_NEAR(static_cast<double>(axis.counts() - at), 0.0, 1000.0);
}

TEST_F(HomingControl, DoesNotStartWithHaltAndStartsWithItsRelease) {
  axis.settings.method = kToEdge;
  axis.write(kHalted);
  axis.write(kHaltedStart);
  EXPECT_EQ(axis.bits(), "001");
  EXPECT_FALSE(axis.homing.is_running());
  axis.write(kStart);
  axis.homing.resume(axis.demand());
  EXPECT_EQ(axis.run(), "000 010 011");
}

TEST_F(HomingControl, StartsByOneWordThatReleasesHaltAndSetsBit4) {
  axis.settings.method = kToEdge;
  axis.write(kHalted);
  axis.homing.resume(axis.demand());
  axis.write(kStart);
  EXPECT_EQ(axis.run(), "000 010 011");
}

TEST_F(HomingControl, StaysHomedWhenHaltBrakesItAfterTheEvent) {
  axis.start(kToEdge);
  while (axis.bits() == "000") axis.cycle();
  axis.write(kHaltedStart);
  EXPECT_EQ(axis.bits(true), "010");
  EXPECT_EQ(axis.bits(false), "011");
}

TEST_F(HomingControl, IsInterruptedByAStopThatItIsNotToldOf) {
  search();
  const Motion present{.position = axis.demand().position, .velocity = 0.0};
  axis.homing.resume(present);
  EXPECT_EQ(axis.bits(), "001");
}

TEST_F(HomingControl, IsInterruptedByDisabling) {
  search();
  axis.homing.leave(HomingExit::Disabled);
  EXPECT_EQ(axis.bits(), "001");
  axis.homing.enter({.position = axis.demand().position});
  EXPECT_EQ(axis.bits(), "001");
}

TEST_F(HomingControl, KeepsAnOldHomeThroughAnInterruption) {
  axis.start(37);
  axis.cycle();
  search();
  axis.write(kEnabled);
  EXPECT_EQ(axis.run(), "000 001");
  EXPECT_TRUE(axis.homing.is_homed());
  axis.homing.leave(HomingExit::OtherMode);
  axis.homing.enter(axis.demand());
  EXPECT_EQ(axis.bits(), "011");
}

TEST_F(HomingControl, KeepsItsEndThroughDisablingAndEnabling) {
  axis.start(kToEdge);
  while (axis.bits() == "000") axis.cycle();
  axis.homing.leave(HomingExit::Disabled);
  EXPECT_EQ(axis.bits(), "011");
  axis.homing.enter({.position = axis.demand().position});
  EXPECT_EQ(axis.bits(), "011");
}

}  // namespace
}  // namespace cia402
