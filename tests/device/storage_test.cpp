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
