/// The causes of faults and alarms: thresholds, delays, hystereses and what they report.
#include <vector>

#include <gtest/gtest.h>

#include "drive/axis/axis.hpp"
#include "drive/messages/cause_monitor.hpp"
#include "drive/messages/fault_table.hpp"

namespace drive {
namespace {

constexpr double kCycle = 0.004;  // s

/// What the causes are judged by.
struct Observed {
  bool pulses_enabled = false;
  double dc_voltage = 540.0;         // highest of the cycle (V)
  double lowest_dc_voltage = 540.0;  // (V)
  double overload = 0.0;
  double motor_temperature = 0.0;  // (°C)
  double stuck = 0.0;
};

class Causes : public testing::Test {
 protected:
  Observed seen_;
  AxisBlocks blocks_ = Axis{AxisConfiguration{}}.blocks();
  CauseMonitor<AxisBlocks> monitor_;

  Causes() {
    std::get<MotorMonitoring>(blocks_).settings = {.alarm_temperature = 120.0, .fault_temperature = 145.0};
    SpeedMessages& messages = std::get<SpeedMessages>(blocks_);
    messages.settings.overspeed_hysteresis = 10.0;
    messages.settings.blocked_delay = 1.0;
    messages.settings.blocked_speed_threshold = 1.0;
  }

  /// What one cycle of @p duration reports.
  std::vector<Verdict> cycle(double duration = kCycle) {
    motor::Signals signals{};
    signals.overload = seen_.overload;
    signals.winding_temperature = seen_.motor_temperature;
    PowerUnit& power_unit = std::get<PowerUnit>(blocks_);
    power_unit.rest(seen_.lowest_dc_voltage);
    power_unit.begin_cycle();
    const double link = seen_.dc_voltage;
    power_unit.watch(
        {.periods = 1, .lowest_dc_voltage = link, .highest_dc_voltage = link, .last_dc_voltage = link}, {},
        signals, {});
    power_unit.observe(signals);
    std::get<MotorMonitoring>(blocks_).observe(signals);
    std::get<SpeedMessages>(blocks_).run({.duration = duration,
                                          .forward_limit = 100.0,
                                          .backward_limit = -100.0,
                                          .at_torque_limit = seen_.stuck > 0.0});
    std::vector<Verdict> told;
    monitor_.update(duration, blocks_, seen_.pulses_enabled,
                    [&](const Verdict& verdict) { told.push_back(verdict); });
    return told;
  }
  /// The messages that have a cause now.
  std::vector<std::uint16_t> present(double duration = kCycle) {
    std::vector<std::uint16_t> messages;
    for (const Verdict& verdict : cycle(duration))
      if (verdict.present) messages.push_back(verdict.message);
    return messages;
  }
};

using Messages = std::vector<std::uint16_t>;

TEST_F(Causes, NameMessagesThatExist) {
  for (std::size_t i = 0; i < CauseMonitor<AxisBlocks>::kCount; ++i) {
    const std::uint16_t message = CauseMonitor<AxisBlocks>::message(i);
    EXPECT_NE(find_fault(message), nullptr) << message;
  }
}

TEST_F(Causes, AreNoneInAHealthyAxis) {
  EXPECT_EQ(cycle().size(), 0U);
  EXPECT_FALSE(monitor_.any_present());
}

TEST_F(Causes, HoldForTheirDelayWithoutInterruption) {
  seen_.pulses_enabled = true;
  seen_.stuck = 1.0;
  for (int i = 0; i < 249; ++i) ASSERT_EQ(present(), Messages{});
  seen_.stuck = 0.0;
  ASSERT_EQ(present(), Messages{});
  seen_.stuck = 1.0;
  for (int i = 0; i < 249; ++i) ASSERT_EQ(present(), Messages{});
  EXPECT_EQ(present(), Messages{7900});
}

TEST_F(Causes, EndOnceAfterTheirHysteresis) {
  seen_.motor_temperature = 121.0;
  EXPECT_EQ(present(), Messages{7910});
  seen_.motor_temperature = 118.5;
  EXPECT_EQ(present(), Messages{7910});
  seen_.motor_temperature = 117.5;
  const auto told = cycle();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message, 7910);
  EXPECT_FALSE(told[0].present);
  EXPECT_TRUE(cycle().empty());
}

TEST_F(Causes, OfOneMessageCanBeSeveral) {
  seen_.motor_temperature = 130.0;
  EXPECT_EQ(present(239.0), Messages{7910});
  EXPECT_EQ(present(1.0), (Messages{7011, 7910}));  // p0606 after the alarm
  seen_.motor_temperature = 100.0;
  EXPECT_EQ(present(), Messages{});
  seen_.motor_temperature = 146.0;
  EXPECT_EQ(present(), (Messages{7011, 7910}));  // at once
}

TEST_F(Causes, DependOnThePulses) {
  seen_.lowest_dc_voltage = 300.0;
  EXPECT_EQ(present(), Messages{30016});
  seen_.pulses_enabled = true;
  EXPECT_EQ(present(), Messages{30003});
  seen_.lowest_dc_voltage = 540.0;
  seen_.dc_voltage = 830.0;
  EXPECT_EQ(present(), Messages{30002});
  seen_.pulses_enabled = false;
  EXPECT_EQ(present(), Messages{30502});
}

TEST_F(Causes, TellTheirValues) {
  seen_.pulses_enabled = true;
  seen_.dc_voltage = 833.33;
  EXPECT_EQ(cycle().at(0).value, 8333U);
  seen_.dc_voltage = 540.0;
  static_cast<void>(cycle());
  seen_.overload = 1.0001;
  const auto told = cycle();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].message, 7805);
  EXPECT_EQ(told[1].message, 30005);
  EXPECT_EQ(told[1].value, 16386U);
}

}  // namespace
}  // namespace drive
