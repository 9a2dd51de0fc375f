#include "can/hub/loop/clock.hpp"

#include <gtest/gtest.h>

#include "tests/can/hub/time/hub_with_turns.hpp"
#include "tests/can/hub/told.hpp"

namespace hub {
namespace {

using namespace std::chrono_literals;
using userbus::TimeMode;

TEST(HubClock, IsTheMachinesUnlessTheBusHasAnother) {
  const Clock clock;
  EXPECT_EQ(clock.machine_time(told::kStart), told::kStart);
  EXPECT_FALSE(clock.is_told());
}

TEST(HubClock, RunsSoManyTimesAsQuick) {
  for (const double scale : {0.001, 0.5, 4.0, 1000.0}) {
    const Clock clock{{TimeMode::Scaled, scale}};
    const auto passed = clock.machine_time(clock.begin() + 100s) - clock.machine_begin();
    EXPECT_NEAR(static_cast<double>(passed.count()), 100e9 / scale, 2.0) << scale;
    EXPECT_GE(clock.now(), clock.begin());
    EXPECT_EQ(clock.machine_time(canopen::kNever), canopen::kNever);
  }
}

TEST(HubClock, StandsUntilItIsToldToGoOn) {
  Clock clock{{TimeMode::Virtual, 1}};
  const canopen::TimePoint first{canopen::Duration{userbus::kFirstInstant}};
  EXPECT_TRUE(clock.is_told());
  EXPECT_EQ(clock.now(), first);
  EXPECT_EQ(clock.wall(), userbus::kFirstWallTime);
  clock.set(first + 3s);
  EXPECT_EQ(clock.now(), first + 3s);
  EXPECT_EQ(clock.wall(), userbus::kFirstWallTime + 3'000'000'000);
}

TEST(HubClock, StampsFramesOfAScaledBus) {
  const hub_test::RunningHub hub{Server::Settings{.bit_rate = 1000, .time = {TimeMode::Scaled, 1000}}};
  hub_test::BusClient sender{hub.path()}, receiver{hub.path()};
  sender.send("100#");
  sender.send("200#");
  EXPECT_EQ(receiver.wait_frame(), "100#");
  EXPECT_EQ(receiver.wait_frame(), "200#");
}

}  // namespace
}  // namespace hub
