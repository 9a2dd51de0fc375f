#include "tests/device/test_unit.hpp"

namespace device {
namespace {

bool rests(const TestUnit& unit) {
  return unit.device.next_deadline() == canopen::kNever;
}

TEST(Cycle, DoesNotRunWhileThePulsesAreOffAndTheShaftStandsStill) {
  TestUnit unit;
  unit.start();
  unit.passes(8ms);

  EXPECT_TRUE(rests(unit));
  unit.says("000#0105");
  unit.passes(8ms);
  EXPECT_TRUE(rests(unit));
}

TEST(Cycle, WakesOnAnRpdoAndRestsAgain) {
  TestUnit unit;
  unit.start_operational();
  unit.passes(100ms);
  ASSERT_TRUE(rests(unit));

  unit.says("205#0600");
  EXPECT_EQ(unit.device.next_deadline(), unit.now + Device::kCycle);
  EXPECT_EQ(unit.passes(Device::kCycle), at_rest(0x1631));

  EXPECT_EQ(unit.passes(Device::kCycle), Lines{});
  EXPECT_TRUE(rests(unit));
}

TEST(Cycle, KnowsHowLongTheRestWasThatAnRpdoEnds) {
  constexpr std::uint16_t kWindingTemperature = 35;
  TestUnit unit;
  unit.start_operational();
  for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"}) {
    unit.says(controlword);
    unit.passes(20ms);
  }
  unit.device.set_load_torque(1, 8.0, unit.now);
  unit.passes(400s);
  const double hot = unit.device.axis().read(kWindingTemperature).value();
  ASSERT_GT(hot, 30.0);
  unit.device.set_load_torque(1, 0.0, unit.now);
  unit.says("205#0000");
  unit.passes(30s);
  ASSERT_TRUE(rests(unit));

  unit.passes(10h);
  unit.says("205#0600");
  unit.passes(20ms);
  EXPECT_NEAR(unit.device.axis().read(kWindingTemperature).value(), 20.0, 1.0) << "it was " << hot;
}

TEST(Cycle, WakesOnAnSdoWriteOfTheControlword) {
  TestUnit unit;
  unit.start();
  unit.passes(1s);

  ASSERT_EQ(unit.download(0x6040, 0, 6, 2), 0U);
  EXPECT_EQ(unit.device.next_deadline(), unit.now + Device::kCycle);
  unit.passes(Device::kCycle);

  EXPECT_EQ(unit.statusword(), 0x1631);
}

TEST(Cycle, SleepsThroughSdoReads) {
  TestUnit unit;
  unit.start();
  unit.passes(1s);

  unit.upload(0x6041);
  unit.upload(0x6083);

  EXPECT_TRUE(rests(unit));
}

TEST(Cycle, LiesOnAGridOf4msWheneverItIsWoken) {
  TestUnit unit;
  unit.start_operational();
  unit.passes(101'234us);
  ASSERT_TRUE(rests(unit));

  unit.says("205#0600");

  EXPECT_EQ(unit.device.next_deadline(), TestUnit::kStart + 204ms);
}

TEST(Cycle, RunsEvery4msWithThePulsesOn) {
  TestUnit unit;
  unit.enable();

  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(unit.device.next_deadline(), unit.now + Device::kCycle);
    unit.passes(Device::kCycle);
  }
}

TEST(Cycle, RunsUntilACoastingShaftStandsStill) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(300, 1s);

  unit.cycles_with("205#0000");
  EXPECT_FALSE(rests(unit));
  unit.passes(2s);

  EXPECT_EQ(unit.velocity(), 0);
  EXPECT_TRUE(rests(unit));
}

TEST(Cycle, WakesWhenALoadTurnsTheShaft) {
  TestUnit unit;
  unit.start_operational();
  unit.passes(1s);

  unit.device.set_load_torque(1, -0.2, unit.now);
  unit.passes(100ms);

  EXPECT_GT(unit.velocity(), 0);
  EXPECT_FALSE(rests(unit));
}

TEST(Cycle, TakesTheLastOfTheRpdosThatCameSinceTheOneBefore) {
  TestUnit unit;
  unit.start_operational();

  EXPECT_EQ(unit.says("205#0600"), Lines{});
  EXPECT_EQ(unit.says("205#0700"), Lines{"085#1081112F22010000"}) << "A08751: the one before was never taken";
  EXPECT_EQ(unit.says("205#0600"), Lines{});

  EXPECT_EQ(unit.passes(8ms), at_rest(0x16B1));
}

TEST(LateWakeUp, RunsAtMost25CyclesAndCountsTheRest) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);
  const std::uint64_t before = unit.upload(0x6063).number();

  unit.now += 1s;
  unit.device.on_time(unit.now);

  EXPECT_EQ(unit.device.skipped_cycles(), 225U);
  const auto moved = static_cast<std::int32_t>(static_cast<std::uint32_t>(unit.upload(0x6063).number() - before));
  EXPECT_NEAR(moved, 5.0 * kRevolution, 0.005 * kRevolution);  // 100 ms at 3000 rpm
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
}

TEST(LateWakeUp, SendsEveryTpdoOnce) {
  TestUnit unit{unit_with({{1120, 10.0}})};
  unit.enable();
  unit.says("305#0F000000800C");
  unit.passes(1s);

  unit.now += 1s;
  unit.device.on_time(unit.now);
  const Lines lines = unit.passes(0ms);

  EXPECT_EQ(lines.size(), 3U);  // the statusword alone has not changed
  for (const char* const tpdo : {"285#", "385#", "485#"}) EXPECT_EQ(from(tpdo, lines).size(), 1U) << tpdo;
}

TEST(LateWakeUp, GoesOnOnTheGrid) {
  TestUnit unit;
  unit.enable();
  const canopen::TimePoint grid = unit.now;

  unit.now += 1001ms;
  unit.device.on_time(unit.now);

  EXPECT_EQ(unit.device.next_deadline(), grid + 1004ms);
}

TEST(LateWakeUp, OfUpTo100msLosesNothing) {
  TestUnit late{unit_with({{1120, 0.5}})};
  TestUnit punctual{unit_with({{1120, 0.5}})};
  for (TestUnit* const unit : {&late, &punctual}) {
    unit->enable();
    unit->says("305#0F000000800C");
  }

  late.now += 100ms;
  late.device.on_time(late.now);
  punctual.passes(100ms);

  EXPECT_EQ(late.device.skipped_cycles(), 0U);
  EXPECT_EQ(late.velocity(), punctual.velocity());
  EXPECT_EQ(late.upload(0x6063).number(), punctual.upload(0x6063).number());
}

TEST(LateWakeUp, AfterARestSkipsNothing) {
  TestUnit unit;
  unit.start_operational();
  unit.passes(1h);

  EXPECT_EQ(unit.cycles_with("205#0600"), at_rest(0x1631));
  EXPECT_EQ(unit.device.skipped_cycles(), 0U);
}

TEST(Restart, OfTheBusSendsTheBootUpMessageAgain) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1017, 0, 1000, 2), 0U);
  unit.passes(1h);

  EXPECT_EQ(unit.start(), Lines{"705#00"});

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.device.skipped_cycles(), 0U);
}

TEST(Restart, OfTheBusInOperationalIsALeavingOfIt) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);

  EXPECT_EQ(unit.start(), (Lines{"705#00", "085#011011FD21020000"}));

  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x0F);
  EXPECT_TRUE(unit.reaches(0x4F, 0x08, 1s));
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
}

TEST(Restart, OfTheBusKeepsTheFaultsThatStood) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(1s);

  EXPECT_EQ(unit.start(), Lines{"705#00"});

  EXPECT_EQ(unit.upload(0x1001).number(), 0x81U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
}

}  // namespace
}  // namespace device
