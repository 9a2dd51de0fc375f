#include "tests/profidrive/if1_unit.hpp"

namespace profidrive {
namespace {

using Pzd = If1Unit;

constexpr double kRuns = 4.0, kNoSetpoints = 1.0;  // r2043

/// p2040 = 500 ms.
struct MonitoredUnit : If1Unit {
  MonitoredUnit() { set(2040, 500.0, 0, kControlUnit); }
};

TEST(If1Monitoring, BeginsWithTheFirstWords) {
  MonitoredUnit unit;
  unit.passes(2s);
  EXPECT_FALSE(unit.has_fault(1910));
  EXPECT_EQ(unit.read(2043), 0.0);
  EXPECT_EQ(unit.read(2054, 0, Pzd::kControlUnit), 1.0);

  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(480ms);
  EXPECT_EQ(unit.read(2043), kRuns);
  EXPECT_EQ(unit.read(2054, 0, Pzd::kControlUnit), 4.0);
  EXPECT_FALSE(unit.has_fault(1910));
  unit.passes(40ms);
  EXPECT_TRUE(unit.has_fault(1910));
  EXPECT_TRUE(unit.has_alarm(1920));
  EXPECT_EQ(unit.read(2043), kNoSetpoints);
  EXPECT_EQ(unit.read(2054, 0, Pzd::kControlUnit), 1.0);
  EXPECT_FALSE(unit.has_fault(1910, Pzd::kSecondAxis));
}

TEST(If1Monitoring, LetsTheUnitRestWhenItIsOver) {
  MonitoredUnit unit;
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(400ms);
  EXPECT_FALSE(unit.runner.is_resting());
  unit.passes(2s);
  EXPECT_TRUE(unit.runner.is_resting());
}

TEST(If1Monitoring, WaitsFurtherByP2047AndP2044) {
  MonitoredUnit unit;
  unit.set(2047, 200.0, 0, Pzd::kControlUnit);
  unit.set(2044, 1.0);
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(680ms);
  EXPECT_FALSE(unit.has_alarm(1920));
  unit.passes(40ms);
  EXPECT_TRUE(unit.has_alarm(1920));
  EXPECT_EQ(unit.read(2043), kNoSetpoints);
  unit.passes(960ms);
  EXPECT_FALSE(unit.has_fault(1910));
  unit.passes(40ms);
  EXPECT_TRUE(unit.has_fault(1910));
}

TEST(If1Monitoring, IsRestartedByALookWhileItRuns) {
  MonitoredUnit unit;
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  for (int i = 0; i < 10; ++i) {
    unit.passes(400ms);
    unit.if1.touch(Pzd::kAxis);
  }
  EXPECT_FALSE(unit.has_fault(1910));
  unit.passes(600ms);
  EXPECT_TRUE(unit.has_fault(1910));
  unit.if1.touch(Pzd::kAxis);
  EXPECT_EQ(unit.read(2043), kNoSetpoints);
}

TEST(If1Monitoring, TakesItsAlarmBackWhenWordsComeAgain) {
  MonitoredUnit unit;
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(600ms);
  ASSERT_TRUE(unit.has_alarm(1920));
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(4ms);
  EXPECT_FALSE(unit.has_alarm(1920));
  EXPECT_TRUE(unit.has_fault(1910));
  EXPECT_EQ(unit.read(2043), kRuns);
}

TEST(If1Monitoring, HasAFaultThatStopsTheAxisAndIsAcknowledgedAtOnce) {
  If1Unit unit;
  unit.set(2040, 100.0, 0, Pzd::kControlUnit);
  unit.set(1135, 1.0);
  unit.set(922, 1.0);
  unit.exchange({0x047E, 0}, 200ms);
  unit.exchange({0x047F, 0x1000}, 12s);
  ASSERT_EQ(unit.sent(1)[0], 0xEF37);
  unit.passes(200ms);
  ASSERT_TRUE(unit.has_fault(1910));
  unit.passes(3s);
  EXPECT_NEAR(unit.read(63), 0.0, 1.0);
  EXPECT_EQ(unit.read(899) == 0.0, false);
  EXPECT_EQ(unit.read(2043), kNoSetpoints);
  EXPECT_TRUE(unit.runner.acknowledge(1, unit.runner.now()));
  EXPECT_FALSE(unit.has_fault(1910));
}

TEST(If1Monitoring, IsOffWithP2040At0) {
  If1Unit unit;
  unit.set(2040, 0.0, 0, Pzd::kControlUnit);
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.passes(10s);
  EXPECT_FALSE(unit.has_alarm(1920));
  EXPECT_EQ(unit.read(2043), kRuns);
}

TEST(If1Monitoring, OfTheControlUnitIsAnAlarm) {
  MonitoredUnit unit;
  unit.if1.receive(Pzd::kControlUnit, Words{0});
  unit.passes(600ms);
  EXPECT_TRUE(unit.has_alarm(1920, Pzd::kControlUnit));
  EXPECT_FALSE(unit.has_fault(1910, Pzd::kControlUnit));
  EXPECT_FALSE(unit.has_fault(1910));
}

TEST(If1Monitoring, TellsOfALostConnectionUntilWordsComeAgain) {
  MonitoredUnit unit;
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  unit.if1.on_connection_lost(Pzd::kAxis);
  EXPECT_TRUE(unit.has_alarm(1925));
  EXPECT_FALSE(unit.has_fault(1910));
  unit.passes(600ms);
  EXPECT_TRUE(unit.has_fault(1910));
  unit.if1.receive(Pzd::kAxis, Words{0x047E});
  EXPECT_FALSE(unit.has_alarm(1925));
}

struct Assigned {
  double if1, if2;
  bool has_if1, has_alarm;
};

/// p8839 acts with the next power-on.
TEST(If1Assignment, ActsWithTheNextStart) {
  for (const Assigned& row :
       {Assigned{99, 99, true, false}, Assigned{1, 2, true, false}, Assigned{0, 2, false, false},
        Assigned{1, 0, true, false}, Assigned{0, 0, false, false}, Assigned{99, 2, false, true},
        Assigned{1, 99, true, true}, Assigned{1, 1, false, true}, Assigned{2, 1, false, true}}) {
    SCOPED_TRACE(testing::Message() << row.if1 << " " << row.if2);
    If1Unit unit;
    unit.set(8839, row.if1, 0, Pzd::kControlUnit);
    unit.set(8839, row.if2, 1, Pzd::kControlUnit);
    EXPECT_TRUE(unit.if1.is_assigned());
    unit.set(977, 1.0, 0, Pzd::kControlUnit);
    unit.runner.restart_unit();
    unit.runner.reload(unit::ParameterGroup::All);
    EXPECT_EQ(unit.if1.has(Pzd::kAxis), row.has_if1);
    EXPECT_EQ(unit.has_alarm(8550, Pzd::kControlUnit), row.has_alarm);
  }
}

TEST(If1Assignment, TakesFourValues) {
  If1Unit unit;
  EXPECT_EQ(unit.refusal(8839, 3.0, 0, Pzd::kControlUnit), drive::RefusalReason::IllegalValue);
  EXPECT_EQ(unit.refusal(8839, 98.0, 1, Pzd::kControlUnit), drive::RefusalReason::IllegalValue);
}

TEST(If1Protocol, IsHeldWhileModbusIsServed) {
  If1Unit unit;
  unit.set(2030, 10.0, 0, Pzd::kControlUnit);
  unit.if1.serve_modbus();
  EXPECT_EQ(unit.read(2030, 0, Pzd::kControlUnit), 13.0);
  EXPECT_EQ(unit.refusal(2030, 7.0, 0, Pzd::kControlUnit), drive::RefusalReason::Locked);
}

}  // namespace
}  // namespace profidrive
