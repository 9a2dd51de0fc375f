#include <vector>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint32_t kSave = 0x65766173;
constexpr std::uint32_t kLoad = 0x64616F6C;
constexpr std::uint32_t kCannotTransfer = 0x08000020;
constexpr std::uint32_t kDeviceState = 0x08000022;
constexpr std::uint32_t kHardwareError = 0x06060000;

constexpr std::uint16_t kStore = 0x1010;
constexpr std::uint16_t kRestore = 0x1011;
constexpr std::uint16_t kHaltOption = 0x605D;
constexpr std::uint16_t kAbortOption = 0x6007;

/// The unit after a power cut: a new device that is given what the former one had stored.
struct NextLife {
  explicit NextLife(const TestUnit& former, const Configuration& configuration = unit_with({}))
      : unit{configuration} {
    EXPECT_TRUE(unit.device.load_parameters(former.listener.image));
    unit.start();
  }
  TestUnit unit;
};

TEST(Store, KeepsParametersThroughAPowerCut) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(kAbortOption, 0, 1, 2), 0U);

  EXPECT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit};
  EXPECT_EQ(next.unit.upload(kHaltOption).number(), 2U);
  EXPECT_EQ(next.unit.upload(kAbortOption).number(), 1U);
}

TEST(Store, ReadsOneForEveryGroup) {
  TestUnit unit;
  unit.start();

  for (std::uint8_t sub_index = 1; sub_index <= 3; ++sub_index) {
    EXPECT_EQ(unit.upload(kStore, sub_index).number(), 1U);
    EXPECT_EQ(unit.upload(kRestore, sub_index).number(), 1U);
  }
}

TEST(Store, WantsItsSignature) {
  TestUnit unit;
  unit.start();

  for (std::uint8_t sub_index = 1; sub_index <= 3; ++sub_index) {
    EXPECT_EQ(unit.download(kStore, sub_index, kLoad, 4), kCannotTransfer);
    EXPECT_EQ(unit.download(kRestore, sub_index, kSave, 4), kCannotTransfer);
  }
  EXPECT_EQ(unit.listener.stores, 0);
}

TEST(Store, RefusesAPartBeforeAllWasStoredOnce) {
  TestUnit unit;
  unit.start();
  EXPECT_EQ(unit.download(kStore, 2, kSave, 4), kDeviceState);
  EXPECT_EQ(unit.download(kStore, 3, kSave, 4), kDeviceState);

  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  EXPECT_EQ(unit.download(kStore, 2, kSave, 4), 0U);
  EXPECT_EQ(unit.download(kStore, 3, kSave, 4), 0U);
  EXPECT_EQ(unit.listener.stores, 3);
}

TEST(Store, OfTheApplicationStoresWhatProfileObjectsShow) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);

  ASSERT_EQ(unit.download(kStore, 2, kSave, 4), 0U);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 0xFFFFU);
  ASSERT_EQ(unit.download(kStore, 3, kSave, 4), 0U);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 2U);
}

TEST(Store, ThatFailsIsAHardwareErrorAndChangesNothing) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  unit.listener.is_full = true;

  EXPECT_EQ(unit.download(kStore, 1, kSave, 4), kHardwareError);

  unit.says("000#8105");
  EXPECT_EQ(unit.upload(kHaltOption).number(), 0xFFFFU);
}

TEST(ResetNode, ReturnsToTheStoredParameters) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  ASSERT_EQ(unit.download(kHaltOption, 0, 3, 2), 0U);
  ASSERT_EQ(unit.download(kAbortOption, 0, 1, 2), 0U);

  unit.says("000#8205");
  EXPECT_EQ(unit.upload(kHaltOption).number(), 3U);
  unit.says("000#8105");

  EXPECT_EQ(unit.upload(kHaltOption).number(), 2U);
  EXPECT_EQ(unit.upload(kAbortOption).number(), 3U);
}

TEST(Presets, LieOverStoredAndRestoredParameters) {
  const Configuration preset = unit_with({{8791, 3.0}});
  TestUnit unit{preset};
  unit.start();
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit, preset};
  EXPECT_EQ(next.unit.upload(kHaltOption).number(), 3U);
  ASSERT_EQ(next.unit.download(kHaltOption, 0, 1, 2), 0U);
  next.unit.says("000#8205");
  EXPECT_EQ(next.unit.upload(kHaltOption).number(), 1U);
  ASSERT_EQ(next.unit.download(kRestore, 2, kLoad, 4), 0U);
  EXPECT_EQ(next.unit.upload(kHaltOption).number(), 1U);
  ASSERT_EQ(next.unit.download(kRestore, 3, kLoad, 4), 0U);

  EXPECT_EQ(next.unit.upload(kHaltOption).number(), 3U);
}

/// Gives RPDO 1 the identifier 215h and TPDO 1 the event timer 100 ms.
void change_pdos(TestUnit& unit) {
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(unit.download(0x1400, 1, 0x00000215, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 5, 100, 2), 0U);
}

/// Whether the unit takes RPDO 1 under 215h and not under 205h, and sends TPDO 1 every 100 ms.
bool has_changed_pdos(TestUnit& unit) {
  unit.says("000#0105");
  unit.passes(50ms);
  const bool sends = from("185#", unit.passes(200ms)).size() == 2;
  unit.says("215#0600");
  unit.says("205#0000");
  EXPECT_EQ(unit.upload(0x6040).number(), sends ? 6U : 0U);
  unit.says("000#8005");
  return sends;
}

TEST(StoredCommunication, IsInForceAfterAPowerCut) {
  const Configuration quiet{.node_id = 5, .fault_on_leaving_operational = false};
  TestUnit unit{quiet};
  unit.start();
  change_pdos(unit);

  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit, quiet};
  EXPECT_TRUE(has_changed_pdos(next.unit));
}

TEST(StoredCommunication, IsWhatAResetOfTheCommunicationReturnsTo) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  change_pdos(unit);
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(kStore, 2, kSave, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 5, 7, 2), 0U);
  ASSERT_EQ(unit.download(0x1017, 0, 500, 2), 0U);

  EXPECT_EQ(unit.says("000#8205"), Lines{"705#00"});

  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x215U);
  EXPECT_EQ(unit.upload(0x1800, 5).number(), 100U);
  EXPECT_EQ(unit.upload(0x1017).number(), 0U);
  EXPECT_EQ(NextLife{unit}.unit.upload(kHaltOption).number(), 0xFFFFU);
}

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

/// A unit whose window 2000h to 470Fh shows drive object @p object.
struct Window : TestUnit {
  explicit Window(std::uint16_t object) {
    start();
    show(object);
  }
  void show(std::uint16_t object) { ASSERT_EQ(download(0x41B6, 0, object, 2), 0U); }
  std::uint32_t write(std::uint16_t parameter, std::uint32_t value) {
    return download(static_cast<std::uint16_t>(0x2000 + parameter), 0, value, 2);
  }
  std::uint64_t read(std::uint16_t parameter) {
    return upload(static_cast<std::uint16_t>(0x2000 + parameter)).number();
  }
};

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

TEST(Retained, BringsFaultBuffersEnergiesAndRuntimeBack) {
  TestUnit unit;
  unit.turn_at(600, 8s);
  unit.passes(1s);
  ASSERT_TRUE(unit.device.raise(1, 7860, 42, unit.now));
  const double drawn = unit.device.axis().read(39, 1).value();
  ASSERT_GT(drawn, 0.0);
  const auto kept = unit.device.retained(unit.now);

  TestUnit next;
  ASSERT_TRUE(next.device.load_retained(kept));
  next.start();

  EXPECT_EQ(next.device.axis().read(945, 8).value(), 7860.0);
  EXPECT_EQ(next.device.axis().read(949, 8).value(), 42.0);
  EXPECT_EQ(next.device.axis().read(39, 1).value(), drawn);
  EXPECT_EQ(next.device.unit().runtime(), unit.device.unit().runtime());
  EXPECT_EQ(next.upload(0x1001).number(), 0U);
  EXPECT_EQ(next.statusword() & 0x4F, 0x40);
}

TEST(Retained, TellsWhenThereIsSomethingToKeep) {
  TestUnit unit;
  unit.start();
  unit.passes(1s);
  const std::uint32_t before = unit.device.message_changes();
  EXPECT_FALSE(unit.device.is_moving());
  unit.passes(60s);
  EXPECT_EQ(unit.device.message_changes(), before);

  ASSERT_TRUE(unit.device.raise(1, 7860, 42, unit.now));
  const std::uint32_t raised = unit.device.message_changes();
  EXPECT_NE(raised, before);
  unit.device.acknowledge(1, unit.now);

  EXPECT_NE(unit.device.message_changes(), raised);
}

TEST(Retained, TellsWhenAnAxisMoves) {
  TestUnit unit;
  unit.turn_at(600, 8s);
  EXPECT_TRUE(unit.device.is_moving());

  unit.says("205#0000");
  unit.passes(100ms);
  EXPECT_TRUE(unit.device.is_moving()) << "it coasts";
  unit.passes(10min);

  EXPECT_FALSE(unit.device.is_moving());
}

TEST(Retained, CountsNoTimeBeforeTheStart) {
  TestUnit unit;

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.device.retained(unit.now);

  EXPECT_EQ(unit.device.unit().runtime(), 0U);
}

}  // namespace
}  // namespace device
