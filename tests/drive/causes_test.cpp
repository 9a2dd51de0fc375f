/// The causes of faults and alarms: thresholds, delays, hystereses and what they report.
#include "drive/causes.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "drive/fault_table.hpp"

namespace drive {
namespace {

constexpr double kCycle = 0.004;  // s

class Causes : public testing::Test {
 protected:
  Observed seen_{.dc_voltage = 540.0, .lowest_dc_voltage = 540.0};
  CauseLimits limits_{.trip_current = 75.0,
                      .overvoltage = 820.0,
                      .undervoltage = 360.0,
                      .temperature_alarm = 120.0,
                      .temperature_fault = 145.0,
                      .overspeed_hysteresis = 10.0,
                      .blocked_delay = 1.0};
  CauseMonitor monitor_;

  Causes() { seen_.overspeed = -100.0; }

  /// What one cycle of @p duration reports.
  std::vector<Verdict> cycle(double duration = kCycle) {
    std::vector<Verdict> told;
    monitor_.update(duration, seen_, limits_, [&](const Verdict& verdict) { told.push_back(verdict); });
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
  for (const CauseRow& row : cause_rows()) EXPECT_NE(find_fault(row.message), nullptr) << row.message;
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
