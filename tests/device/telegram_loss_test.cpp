#include "tests/device/communication_fixture.hpp"

namespace device {
namespace {

const Lines kAlarm{"085#1081112F22010000"};
const Lines kNothingLeft{"085#0000000000000000"};

TEST(TelegramLoss, IsAnRpdoThatIsOverwrittenBeforeTheCycle) {
  ControlUnit unit{2};
  unit.says("000#0105");

  EXPECT_EQ(from("085#", unit.says("205#0600")), Lines{});
  EXPECT_EQ(from("085#", unit.says("205#0600")), kAlarm);

  EXPECT_EQ(unit.device.lost_telegrams(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 1).number(), 0x00018110U);
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x80, 0x80) << "on every drive object";
}

TEST(TelegramLoss, IsNoneOfRpdosThatComeInDifferentCycles) {
  ControlUnit unit;
  unit.says("000#0105");

  for (int i = 0; i < 100; ++i) {
    unit.says("205#0600");
    unit.says("305#060000000000");  // another RPDO
    EXPECT_EQ(from("085#", unit.passes(Device::kCycle)), Lines{});
  }
  EXPECT_EQ(unit.device.lost_telegrams(), 0U);
}

TEST(TelegramLoss, IsToldOnceAndEndsFiveSecondsAfterTheLastOne) {
  ControlUnit unit;
  unit.says("000#0105");
  unit.passes(10ms);
  Lines emcy;
  for (int i = 0; i < 100; ++i) {
    for (const std::string& line : from("085#", unit.says("205#0600"))) emcy.push_back(line);
    for (const std::string& line : from("085#", unit.passes(1ms))) emcy.push_back(line);
  }
  EXPECT_EQ(emcy, kAlarm);

  EXPECT_EQ(from("085#", unit.passes(4990ms)), Lines{});
  EXPECT_EQ(from("085#", unit.passes(20ms)), kNothingLeft);
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x80, 0);

  unit.says("205#0600");
  EXPECT_EQ(from("085#", unit.says("205#0600")), kAlarm) << "once per occurrence";
}

TEST(TelegramLoss, IsNoneOfSynchronousRpdos) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1400, 2, 1, 1), 0U);
  unit.says("000#0105");

  for (int i = 0; i < 3; ++i) {
    unit.says("205#0600");
    unit.says("205#0700");
    EXPECT_EQ(from("085#", unit.says("080#")), Lines{});
  }
  EXPECT_EQ(unit.device.lost_telegrams(), 0U);
}

TEST(TelegramLoss, IsNoneOfFramesThatALateUnitReadsAtOnce) {
  TestUnit unit;
  unit.enable();

  unit.now += 50ms;
  for (int i = 0; i < 10; ++i) unit.device.on_frame(fakes::frame_of("205#0F00"), unit.now);
  unit.device.on_time(unit.now);

  EXPECT_EQ(from("085#", unit.passes(1s)), Lines{});
}

TEST(TelegramLoss, IsNoneOfFramesOfAnRpdoThatMissedCyclesTakeOneByOne) {
  for (const canopen::Duration stall : {20ms, 50ms, 90ms, 300ms}) {
    TestUnit unit;
    unit.start_operational();
    unit.passes(1s);
    // At rest, so that nothing but the age of the first frame tells how long the program was kept from running.
    unit.now += stall;
    unit.listener.waited = stall;
    for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"})
      unit.device.on_frame(fakes::frame_of(controlword), unit.now);
    EXPECT_EQ(unit.passes(0ms), at_rest(0x1637)) << "what the last cycle has led to, once";

    EXPECT_EQ(from("085#", unit.passes(1s)), Lines{});
    EXPECT_EQ(unit.device.lost_telegrams(), 0U);
    EXPECT_EQ(unit.device.skipped_cycles(), stall > 100ms ? 50U : 0U);
  }
}

TEST(TelegramLoss, IsNoneWhileTheMotorTurnsEither) {
  TestUnit unit;
  unit.turn_at(300.0, 1s);
  unit.passes(8ms);

  unit.now += 50ms;
  for (const char* const frame : {"205#0E00", "205#0700", "205#0F00"})  // OFF1, and on again
    unit.device.on_frame(fakes::frame_of(frame), unit.now);
  unit.device.on_time(unit.now);

  EXPECT_EQ(from("085#", unit.passes(1s)), Lines{});
  EXPECT_EQ(unit.device.lost_telegrams(), 0U);
}

TEST(TelegramLoss, LeavesTogetherWhatOneSyncHasBrought) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1400, 2, 1, 1), 0U);
  unit.start_operational();
  unit.passes(1s);

  unit.now += 50ms;
  unit.listener.waited = 50ms;
  for (const char* const frame : {"205#0600", "080#", "205#0700", "080#", "205#0F00", "080#"})
    unit.device.on_frame(fakes::frame_of(frame), unit.now);
  unit.device.on_time(unit.now);

  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
}

TEST(TelegramLoss, GivesACycleWhatCameBeforeOperationalWasLeft) {
  TestUnit unit;
  unit.start_operational();
  for (const char* const controlword : {"205#0600", "205#0700"}) unit.cycles_with(controlword);

  unit.now += 50ms;
  unit.listener.waited = 50ms;
  for (const char* const frame : {"205#0F00", "000#8005"}) unit.device.on_frame(fakes::frame_of(frame), unit.now);

  EXPECT_EQ(unit.device.axis().actual().state, drive::State::FaultReactionActive) << "it was enabled";
}

TEST(TelegramLoss, CanBeMuted) {
  ControlUnit unit;
  unit.open(1);
  ASSERT_EQ(unit.download(0x2000 + 2118, 0, 8751, 2), 0U);
  ASSERT_EQ(unit.download(0x2000 + 2119, 0, 3, 2), 0U);
  unit.open(2);
  ASSERT_EQ(unit.download(0x2000 + 2118, 0, 8751, 2), 0U);
  ASSERT_EQ(unit.download(0x2000 + 2119, 0, 3, 2), 0U);
  unit.says("000#0105");

  unit.says("205#0600");
  EXPECT_EQ(from("085#", unit.says("205#0600")), Lines{});

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.device.lost_telegrams(), 1U);
}

TEST(TelegramLoss, EndsWithAReset) {
  ControlUnit unit;
  unit.says("000#0105");
  unit.says("205#0600");
  unit.says("205#0600");

  unit.says("000#8105");

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.passes(10s), Lines{});
  unit.says("000#0105");
  unit.says("205#0600");
  EXPECT_EQ(from("085#", unit.says("205#0600")), kAlarm);
}

TEST(TelegramLoss, IsWhatFramesAreThatTheSocketHasDropped) {
  ControlUnit unit;

  unit.device.on_frames_lost(unit.now);
  EXPECT_EQ(from("085#", unit.passes(0ms)), kAlarm);
  unit.device.on_frames_lost(unit.now);
  EXPECT_EQ(from("085#", unit.passes(4999ms)), Lines{});
  EXPECT_EQ(from("085#", unit.passes(1ms)), kNothingLeft);
}

TEST(ShortRpdo, IsIgnoredAndCountedWithoutAWord) {
  ControlUnit unit;
  unit.says("000#0105");
  unit.passes(100ms);

  EXPECT_EQ(unit.says("205#06"), Lines{});
  EXPECT_EQ(unit.passes(1s), Lines{});
  EXPECT_EQ(unit.device.node().short_rpdos(), 1U);
  EXPECT_EQ(unit.upload(0x6040).number(), 0U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

TEST(LongRpdo, CountsAsFarAsItIsMapped) {
  ControlUnit unit;
  unit.says("000#0105");
  unit.passes(100ms);

  EXPECT_EQ(unit.cycles_with("205#0600112233445566"), at_rest(0x1631));
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

}  // namespace
}  // namespace device
