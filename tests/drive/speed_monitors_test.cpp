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
  const TargetMonitor::Limits limits{9.0, 0.5, 0.2, 0.0};

  EXPECT_FALSE(monitor.update(kCycle, 9.1, limits));
  EXPECT_TRUE(monitor.update(kCycle, -9.0, limits));
  EXPECT_EQ(cycles_until([&] { return !monitor.update(kCycle, 9.4, limits); }), 10001);
  EXPECT_EQ(cycles_until([&] { return !monitor.update(kCycle, 9.6, limits); }), 50);
  EXPECT_FALSE(monitor.update(kCycle, 9.4, limits));
}

TEST(TargetMonitor, IsKeptAfterTheOnDelayAndFallsAtOnceBeyondTheHysteresis) {
  TargetMonitor monitor;
  const TargetMonitor::Limits limits{9.0, 0.5, 0.0, 0.1};
  const auto kept = [&](double deviation) {
    monitor.update(kCycle, deviation, limits);
    return monitor.is_kept();
  };

  EXPECT_TRUE(kept(0.0)) << "a motor that has never turned";
  EXPECT_TRUE(kept(9.4));
  EXPECT_FALSE(kept(-9.6));
  EXPECT_FALSE(monitor.awaits());
  EXPECT_FALSE(kept(9.4)) << "within the hysteresis, but it has not been in the window";
  EXPECT_FALSE(monitor.awaits());
  EXPECT_EQ(cycles_until([&] { return kept(8.9); }), 25);
  EXPECT_FALSE(kept(9.6));
  EXPECT_EQ(cycles_until([&] { return kept(9.0); }, 10), 11);
  EXPECT_TRUE(monitor.awaits());
  EXPECT_FALSE(kept(9.6)) << "the delay begins anew";
  EXPECT_EQ(cycles_until([&] { return kept(9.0); }), 25);
}

}  // namespace
}  // namespace drive
