#include <gtest/gtest.h>

#include "drive/sequence_control/standstill_monitor.hpp"
#include "drive/speed_messages/target_monitor.hpp"

namespace drive {
namespace {

constexpr double kCycle = 0.004;

template <class Update>
int cycles_until(Update update, int limit = 10000) {
  for (int n = 1; n <= limit; ++n)
    if (update()) return n;
  return limit + 1;
}

TEST(StandstillMonitor, SwitchesOffThePulseSuppressionDelayAfterTheSpeedIsBelowTheThreshold) {
  StandstillMonitor monitor;
  const StandstillMonitor::Limits limits{2.0, 4.0, 0.012};

  EXPECT_FALSE(monitor.update(kCycle, 2.1, 0.0, limits));
  EXPECT_EQ(cycles_until([&] { return monitor.update(kCycle, -1.9, 0.0, limits); }), 3);
}

TEST(StandstillMonitor, SwitchesOffTheMonitoringTimeAfterTheSetpointIsBelowTheThresholdThoughTheMotorTurns) {
  StandstillMonitor monitor;
  const StandstillMonitor::Limits limits{2.0, 4.0, 0.0};
  for (int i = 0; i < 2000; ++i) ASSERT_FALSE(monitor.update(kCycle, 50.0, 40.0, limits));

  EXPECT_EQ(cycles_until([&] { return monitor.update(kCycle, 50.0, 1.0, limits); }), 1000);
}

TEST(TargetMonitor, ComesAtOnceInTheWindowAndGoesOnlyBeyondTheHysteresisAfterTheOffDelay) {
  TargetMonitor monitor;
  const TargetMonitor::Limits limits{9.0, 0.5, 0.2};

  EXPECT_FALSE(monitor.update(kCycle, 9.1, limits));
  EXPECT_TRUE(monitor.update(kCycle, -9.0, limits));
  EXPECT_EQ(cycles_until([&] { return !monitor.update(kCycle, 9.4, limits); }), 10001);
  EXPECT_EQ(cycles_until([&] { return !monitor.update(kCycle, 9.6, limits); }), 50);
  EXPECT_FALSE(monitor.update(kCycle, 9.4, limits));
}

}  // namespace
}  // namespace drive
