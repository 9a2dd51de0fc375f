#include <gtest/gtest.h>

#include "tests/can/hub/time/clock_program.hpp"
#include "tests/can/hub/time/hub_with_turns.hpp"

namespace hub_test {
namespace {

using userbus::kDevice;
using userbus::kNoInstant;
using userbus::kTouched;

TEST(BusTime, GivesTurnsInTheOrderOfJoining) {
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  second.join();
  EXPECT_FALSE(second.has_turn());
  first.wait(0, 1000);
  ASSERT_EQ(second.turn(), 0);
  EXPECT_EQ(second.last().horizon_ns, 1000);

  second.wait(0, 1000);
  ASSERT_EQ(first.turn(), 1000);
  EXPECT_EQ(first.last().horizon_ns, 1000);
  EXPECT_FALSE(second.has_turn());
  first.wait(1000, 5000);
  ASSERT_EQ(second.turn(), 1000);
  EXPECT_EQ(second.last().horizon_ns, 5000);
}

TEST(BusTime, LetsAProgramGoOnByItselfAsFarAsTheOthersWait) {
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  EXPECT_EQ(first.last().horizon_ns, kLast);
  first.wait(7000, 9000);
  ASSERT_EQ(first.turn(), 9000);
  second.join();
  first.wait(9000, 20'000);
  ASSERT_EQ(second.turn(), 9000);
  second.wait(20'000, kNoInstant);
  EXPECT_EQ(first.turn(), 20'000);
}

TEST(BusTime, HasNobodyWaitBeyondItsLastInstant) {
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  second.join();
  first.wait(0, kLast + 1);
  ASSERT_EQ(second.turn(), 0);
  second.wait(kLast + 1, kLast);  // its present is later than it may be
  EXPECT_EQ(second.turn(), kLast);
  second.wait(kLast, kNoInstant);
  EXPECT_FALSE(first.has_turn());
}

TEST(BusTime, PausesWhoTakesTurnAfterTurnAtOneInstant) {
  constexpr int kMostTurns = 200;
  constexpr std::int64_t kOwnTime = 5'000'000, kPause = 10'000'000;
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  second.join();
  for (int turns = 1; turns < kMostTurns; ++turns) {
    first.wait(0, kNoInstant, kTouched);
    ASSERT_EQ(second.turn(), 0);
    second.wait(0, kOwnTime, kTouched);
    ASSERT_EQ(first.turn(), 0);
  }
  first.wait(0, kNoInstant, kTouched);
  ASSERT_EQ(second.turn(), 0);

  second.wait(0, kOwnTime, kTouched);

  EXPECT_EQ(second.turn(), kOwnTime);
  second.wait(kOwnTime, kNoInstant);
  EXPECT_EQ(first.turn(), kPause);
}

TEST(BusTime, StandsWhileOnlyDevicesAreThere) {
  const HubWithTurns hub;
  ClockProgram device{hub.path()}, program{hub.path()};
  device.join(kDevice);
  ASSERT_EQ(device.turn(), 0);
  EXPECT_EQ(device.last().horizon_ns, 0);
  device.wait(0, 4000);
  program.join();
  ASSERT_EQ(program.turn(), 0);
  EXPECT_EQ(program.last().horizon_ns, 4000);
  program.wait(0, kNoInstant);
  EXPECT_EQ(device.turn(), 4000);
}

TEST(BusTime, KeepsWhatIsSaidWithinTheTurn) {
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  second.join();
  first.wait(-500, 1000);
  ASSERT_EQ(second.turn(), 0);
  second.wait(99'000, 100'000);
  ASSERT_EQ(first.turn(), 1000);
  first.wait(0, 0);
  EXPECT_EQ(first.turn(), 1000);
}

TEST(BusTime, HasEverybodyLookOnceWhenSomethingWasTouched) {
  const HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
  first.join();
  ASSERT_EQ(first.turn(), 0);
  second.join();
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 0);
  second.wait(0, 9000, kTouched);
  ASSERT_EQ(first.turn(), 0);
  EXPECT_EQ(first.last().horizon_ns, 9000);
  first.wait(0, kNoInstant);
  EXPECT_EQ(second.turn(), 9000);
}

TEST(BusTime, GivesATurnToWhoWantsOne) {
  const HubWithTurns hub;
  ClockProgram program{hub.path()};
  program.join();
  ASSERT_EQ(program.turn(), 0);
  program.wait(3000, kNoInstant);
  program.want();
  EXPECT_EQ(program.turn(), 3000);
}

}  // namespace
}  // namespace hub_test
