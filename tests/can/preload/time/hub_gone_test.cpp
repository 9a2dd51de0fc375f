#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

/// Ends the hub of this process's bus without a chance to say so.
void kill_hub() {
  pid_t hub = 0;
  std::ifstream{std::getenv("CAN_BUS") + std::string{".lock"}} >> hub;
  ASSERT_GT(hub, 0);
  kill(hub, SIGKILL);
}

TEST(BusClock, GoesOnByTheMachineWhenTheHubHasGone) {
  sleep_for(seconds{5});
  const Stopwatch time;
  std::thread sleeper{[&time] {
    sleep_for(milliseconds{20});
    EXPECT_GE(time.passed(), milliseconds{20});
  }};
  kill_hub();
  sleep_for(milliseconds{10});

  EXPECT_GE(time.passed(), milliseconds{10});
  sleeper.join();
  const nanoseconds before = time.passed();
  while (time.passed() == before) continue;
  EXPECT_LT(time.passed(), seconds{10});
}

}  // namespace
}  // namespace preload_test
