#include "can/hub/loop/bus_clock.hpp"

#include <gtest/gtest.h>

#include "tests/can/hub/time/hub_with_turns.hpp"
#include "tests/can/hub/told.hpp"

namespace hub {
namespace {

using namespace std::chrono_literals;
using userbus::TimeMode;

TEST(BusClock, IsTheMachinesUnlessTheBusHasAnother) {
  const BusClock clock;
  EXPECT_EQ(clock.at(told::kStart), told::kStart);
  EXPECT_EQ(clock.on_machine(told::kStart), told::kStart);
  EXPECT_FALSE(clock.has_turns());
  EXPECT_LT(clock.descriptor(), 0);
}

TEST(BusClock, RunsSoManyTimesAsQuick) {
  for (const double scale : {0.001, 0.5, 4.0, 1000.0}) {
    const BusClock clock{{TimeMode::Scaled, scale}};
    const canopen::TimePoint machine = monotonic_now();
    const auto passed = clock.at(machine + 100s) - clock.at(machine);
    EXPECT_NEAR(static_cast<double>(passed.count()), scale * 100e9, 2.0) << scale;

    const canopen::TimePoint deadline = clock.at(machine) + 7ms;
    EXPECT_GE(clock.at(clock.on_machine(deadline)), deadline) << scale;
    EXPECT_LE(clock.at(clock.on_machine(deadline) - 10us), deadline) << scale;
    EXPECT_EQ(clock.on_machine(canopen::kNever), canopen::kNever);
  }
}

TEST(BusClock, StandsUntilItIsToldToGoOn) {
  BusClock clock{{TimeMode::Virtual, 1}};
  const canopen::TimePoint first{canopen::Duration{userbus::kFirstInstant}};
  EXPECT_EQ(clock.now(), first);
  EXPECT_EQ(clock.wall_now(), userbus::kFirstWallTime);
  clock.go_to(first + 3s);
  clock.go_to(first + 2s);
  EXPECT_EQ(clock.now(), first + 3s);
  EXPECT_EQ(clock.on_machine(first), canopen::kNever);
}

TEST(BusClock, IsSeenByMembers) {
  const hub_test::RunningHub hub{Server::Settings{.time = {TimeMode::Scaled, 250}}};
  const hub_test::BusClient client{hub.path()};
  const userbus::TimePage* const page = userbus::map_time(client.descriptor());
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page->mode, TimeMode::Scaled);
  EXPECT_EQ(page->scale, 250);
  userbus::unmap_time(page);
}

TEST(BusClock, StampsFramesOfAScaledBus) {
  const hub_test::RunningHub hub{Server::Settings{.bit_rate = 1000, .time = {TimeMode::Scaled, 1000}}};
  hub_test::BusClient sender{hub.path()}, receiver{hub.path()};
  sender.send("100#");
  sender.send("200#");
  EXPECT_EQ(receiver.wait_frame(), "100#");
  EXPECT_EQ(receiver.wait_frame(), "200#");
}

}  // namespace
}  // namespace hub
