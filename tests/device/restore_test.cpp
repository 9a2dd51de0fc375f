#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint32_t kDeviceState = 0x08000022;
constexpr std::uint32_t kHardwareError = 0x06060000;

TEST(Restore, OfTheCommunicationIsInForceAtOnceWithoutABootUp) {
  TestUnit unit{{.node_id = 5, .fault_on_leaving_operational = false}};
  unit.start();
  change_pdos(unit);
  ASSERT_TRUE(has_changed_pdos(unit));
  unit.passes(10ms);
  const int changes = unit.listener.subscription_changes;

  EXPECT_EQ(unit.says("605#231110026C6F6164"), Lines{"585#6011100200000000"});

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_GT(unit.listener.subscription_changes, changes);
  EXPECT_FALSE(has_changed_pdos(unit));
}

TEST(StorageParameters, SaveAndReadZero) {
  Window unit{1};
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);

  EXPECT_EQ(unit.write(977, 1), 0U);
  EXPECT_EQ(unit.read(977), 0U);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 2U);

  unit.show(2);
  ASSERT_EQ(unit.download(kHaltOption, 0, 1, 2), 0U);
  EXPECT_EQ(unit.write(971, 1), 0U);
  EXPECT_EQ(unit.read(971), 0U);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 1U);
}

TEST(StorageParameters, SayWhatIsWrong) {
  Window unit{1};

  EXPECT_EQ(unit.write(977, 10), 0x06090030U);
  EXPECT_EQ(unit.write(977, 1014), 0x06090031U);
  EXPECT_EQ(unit.write(976, 1), kDeviceState) << "p0009 is not 30";
  unit.listener.is_full = true;
  EXPECT_EQ(unit.write(977, 1), kHardwareError);
  EXPECT_EQ(unit.write(971, 1), kHardwareError);
}

TEST(StorageParameters, RestoreTheStateOfANewUnit) {
  Window unit{1};
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.write(8622, 3), 0U);
  ASSERT_EQ(unit.write(9, 30), 0U);

  EXPECT_EQ(unit.write(976, 1), 0U);

  EXPECT_EQ(unit.upload(kHaltOption).number(), 0xFFFFU);
  ASSERT_EQ(unit.upload(0x41B6).number(), 0U) << "p8630 is reset too";
  unit.show(1);
  EXPECT_EQ(unit.read(9), 0U);
  EXPECT_EQ(unit.read(976), 0U);
  EXPECT_EQ(unit.read(8622), 3U);
  EXPECT_EQ(unit.read(8620), 5U);
}

TEST(StorageParameters, RestartTheUnitAfterTheAnswer) {
  Window unit{1};
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.write(977, 1), 0U);
  ASSERT_EQ(unit.download(kHaltOption, 0, 1, 2), 0U);

  EXPECT_EQ(unit.says("605#2BCC230001000000"), (Lines{"585#60CC230000000000", "705#00"}));
  EXPECT_EQ(unit.upload(kHaltOption).number(), 2U);

  unit.show(1);
  ASSERT_EQ(unit.write(9, 30), 0U);
  EXPECT_EQ(unit.says("605#2BD0230002000000"), (Lines{"585#60D0230000000000", "705#00"}));
}

TEST(StorageParameters, RestartTheUnitWhenOperationalIsLeft) {
  Window unit{1};
  unit.says("000#0105");
  unit.passes(10ms);
  ASSERT_EQ(unit.write(972, 3), 0U);
  EXPECT_EQ(unit.read(972), 3U);
  unit.passes(100ms);

  EXPECT_EQ(from("705#", unit.says("000#8005")), Lines{"705#00"});
}

TEST(Restore, ActsAtOnceAndLeavesWhatIsStored) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);

  ASSERT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);

  EXPECT_EQ(unit.upload(kHaltOption).number(), 0xFFFFU);
  EXPECT_EQ(unit.upload(0x6060).number(), 3U);
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.listener.stores, 1);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 2U);
}

TEST(Restore, OfTheCommunicationLeavesTheApplicationAlone) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(0x1800, 5, 77, 2), 0U);
  ASSERT_EQ(unit.download(0x100C, 0, 100, 2), 0U);

  ASSERT_EQ(unit.download(kRestore, 2, kLoad, 4), 0U);

  EXPECT_EQ(unit.upload(kHaltOption).number(), 2U);
  EXPECT_EQ(unit.upload(0x1800, 5).number(), 0U);
  EXPECT_EQ(unit.upload(0x100C).number(), 0U);
}

TEST(Restore, OfTheApplicationLeavesTheCommunicationAlone) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(0x1800, 5, 77, 2), 0U);

  ASSERT_EQ(unit.download(kRestore, 3, kLoad, 4), 0U);

  EXPECT_EQ(unit.upload(kHaltOption).number(), 0xFFFFU);
  EXPECT_EQ(unit.upload(0x1800, 5).number(), 77U);
}

TEST(Restore, IsRefusedWhilePulsesAreEnabled) {
  TestUnit unit;
  unit.enable();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);

  for (std::uint8_t sub_index = 1; sub_index <= 3; ++sub_index)
    EXPECT_EQ(unit.download(kRestore, sub_index, kLoad, 4), kDeviceState);

  EXPECT_EQ(unit.upload(kHaltOption).number(), 2U);
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
}

TEST(Restore, LeavesAUnitThatTurns) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x6083, 0, 1000000, 4), 0U);
  ASSERT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);

  unit.says("000#0105");
  for (const char* const frame : {"205#0600", "205#0700", "205#0F00", "305#0F000000800C"}) unit.cycles_with(frame);
  unit.passes(12s);

  EXPECT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(3));
}

TEST(Restore, GoesOnShowingTheFaultsThatStand) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  const std::uint64_t newest = unit.upload(0x1003, 1).number();
  ASSERT_NE(newest, 0U);
  unit.passes(100ms);

  ASSERT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);

  EXPECT_EQ(unit.upload(0x1003, 1).number(), newest);
  EXPECT_EQ(unit.upload(0x1001).number(), 0x81U);
  EXPECT_EQ(from("085#", unit.passes(100ms)), Lines{});
}

}  // namespace
}  // namespace device
