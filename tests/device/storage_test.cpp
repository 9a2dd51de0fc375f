#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint32_t kCannotTransfer = 0x08000020;
constexpr std::uint32_t kDeviceState = 0x08000022;
constexpr std::uint32_t kHardwareError = 0x06060000;

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

/// A unit whose keeper takes its time.
struct SlowStore : TestUnit {
  SlowStore() {
    start_operational();
    listener.is_slow = true;
  }
  Lines ends(bool kept) {
    device.on_stored(kept, now);
    return passes(0ms);
  }
};
constexpr const char* kSaveRequest = "605#2310100173617665";
const Lines kSaved{"585#6010100100000000"};

TEST(SlowStore, AnswersWhenTheParametersAreKeptAndRunsCyclesMeanwhile) {
  SlowStore unit;
  EXPECT_EQ(unit.says(kSaveRequest), Lines{});

  for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"}) unit.cycles_with(controlword);
  EXPECT_EQ(unit.device.axis().actual().state, drive::State::OperationEnabled);

  EXPECT_EQ(from("585#", unit.ends(true)), kSaved);
  EXPECT_EQ(unit.ends(true), Lines{}) << "once";
}

TEST(SlowStore, AnswersWithTheFailureAndKeepsTheFormerSet) {
  SlowStore unit;
  unit.listener.is_slow = false;
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  unit.listener.is_slow = true;
  ASSERT_EQ(unit.download(kHaltOption, 0, 2, 2), 0U);
  EXPECT_EQ(unit.says(kSaveRequest), Lines{});

  EXPECT_EQ(unit.ends(false), Lines{"585#8010100100000606"});

  unit.says("000#8105");
  EXPECT_EQ(unit.upload(kHaltOption).number(), 0xFFFFU);
}

TEST(SlowStore, AnswersTheClientOfAParameterToo) {
  Window unit{1};
  unit.listener.is_slow = true;

  EXPECT_EQ(unit.says("605#2BD1230001000000"), Lines{}) << "p0977 = 1";
  unit.device.on_stored(true, unit.now);
  EXPECT_EQ(from("585#", unit.passes(0ms)), Lines{"585#60D1230000000000"});
  EXPECT_EQ(unit.read(977), 0U);
}

TEST(SlowStore, LocksParametersMeanwhile) {
  SlowStore unit;
  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);
  EXPECT_EQ(unit.says(kSaveRequest), Lines{});

  EXPECT_EQ(unit.download(0x2000 + 1120, 0, 0x40000000, 4), kDeviceState) << "p1120";
  EXPECT_EQ(unit.download(kStore, 1, kSave, 4), kDeviceState);
  EXPECT_EQ(unit.download(kRestore, 1, kLoad, 4), kDeviceState);
  EXPECT_EQ(unit.download(0x60FF, 0, 0, 4), 0U) << "no parameter";
  EXPECT_EQ(unit.ends(true), Lines{}) << "its client has gone on";

  EXPECT_EQ(unit.download(0x2000 + 1120, 0, 0x40000000, 4), 0U);
  EXPECT_EQ(unit.listener.stores, 1);
}

TEST(SlowStore, TakesARepeatedRequestForTheSameOne) {
  SlowStore unit;
  for (int i = 0; i < 300; ++i) EXPECT_EQ(unit.says(kSaveRequest), Lines{});

  EXPECT_EQ(unit.ends(true), kSaved);
  EXPECT_EQ(unit.listener.stores, 1);
}

TEST(SlowStore, ForgetsItsClientWithAReset) {
  SlowStore unit;
  unit.says(kSaveRequest);
  unit.says("000#8205");

  EXPECT_EQ(from("585#", unit.ends(true)), Lines{});
  unit.listener.is_slow = false;
  EXPECT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
}

TEST(Store, IsRefusedWhereTheFormerSetMustStay) {
  TestUnit unit;
  unit.start();
  unit.listener.is_kept = true;

  EXPECT_EQ(unit.download(kStore, 1, kSave, 4), kDeviceState);
  EXPECT_EQ(unit.download(kRestore, 2, kLoad, 4), 0U);
  EXPECT_EQ(unit.listener.restores, 0);
  EXPECT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);
  EXPECT_EQ(unit.listener.restores, 1);
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

TEST(StoredCommunication, IsInForceAfterAPowerCut) {
  const Configuration quiet{.node_id = 5, .fault_on_leaving_operational = false};
  TestUnit unit{quiet};
  unit.start();
  change_pdos(unit);

  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit, quiet};
  EXPECT_TRUE(has_changed_pdos(next.unit));
  for (const char* const reset : {"000#8205", "000#8105"}) {
    next.unit.says(reset);
    next.unit.passes(100ms);
    EXPECT_TRUE(has_changed_pdos(next.unit)) << reset;
  }
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

}  // namespace
}  // namespace device
