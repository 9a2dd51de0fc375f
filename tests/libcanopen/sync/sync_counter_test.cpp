#include <cstdio>

#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030;
constexpr std::uint32_t kDeviceState = 0x08000022;

class SyncCounter : public PdoTest {
 protected:
  void SetUp() override {
    start();
    ASSERT_EQ(writes_u32(0x1801, 1, 0xC0000285), 0U);  // only TPDO 5 goes with SYNC
    ASSERT_EQ(writes_u32(0x1802, 1, 0xC0000385), 0U);
  }
  /// TPDO 5 sends the statusword with every @p type-th SYNC from the one with @p first_sync on.
  void map_cyclic(std::uint8_t type, std::uint32_t first_sync) {
    ASSERT_EQ(writes_u32(0x1804, 1, 0x80000000), 0U);
    ASSERT_EQ(writes_u8(0x1804, 6, first_sync), 0U);
    map(0x1804, 0x40000455, type, {0x60410010});
  }
  /// The counters of the SYNCs out of @p count, the first with @p first, that the TPDO goes with.
  std::vector<unsigned> answered(unsigned first, unsigned count, unsigned overflow) {
    std::vector<unsigned> counters;
    for (unsigned n = 0; n < count; ++n) {
      const unsigned counter = (first - 1 + n) % overflow + 1;
      char frame[8];
      std::snprintf(frame, sizeof frame, "080#%02X", counter);
      if (!says(frame).empty()) counters.push_back(counter);
    }
    return counters;
  }
  using Counters = std::vector<unsigned>;
};

TEST_F(SyncCounter, IsOffUnlessItsOverflowIsSet) {
  map_cyclic(1, 0);
  operate();

  EXPECT_EQ(says("080#"), (Lines{"455#4000"}));
  EXPECT_EQ(says("080#01"), Lines{});
  EXPECT_EQ(application.errors, (Lines{"8240 1"}));
  EXPECT_EQ(says("080#"), (Lines{"455#4000"}));
  EXPECT_EQ(application.errors, (Lines{"8240 1", "8240 1 over"}));
}

TEST_F(SyncCounter, MustBeThereIfItsOverflowIsSet) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  map_cyclic(1, 0);
  operate();

  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(says("080#0000"), Lines{});
  EXPECT_EQ(application.errors, (Lines{"8240 0"})) << "once";
  EXPECT_EQ(says("080#01"), (Lines{"455#4000"}));
  EXPECT_EQ(application.errors, (Lines{"8240 0", "8240 0 over"}));
}

TEST_F(SyncCounter, JudgesItsOverflow) {
  for (const std::uint32_t value : {1U, 241U, 255U})
    EXPECT_EQ(writes_u8(0x1019, 0, value), kInvalidValue) << value;
  for (const std::uint32_t value : {2U, 240U, 0U}) EXPECT_EQ(writes_u8(0x1019, 0, value), 0U) << value;
}

TEST_F(SyncCounter, KeepsItsOverflowWhileACyclePeriodIsSet) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  ASSERT_EQ(writes_u32(0x1006, 0, 1000), 0U);
  EXPECT_EQ(writes_u8(0x1019, 0, 20), kDeviceState);
  EXPECT_EQ(writes_u8(0x1019, 0, 0), kDeviceState);
  EXPECT_EQ(writes_u8(0x1019, 0, 1), kInvalidValue);
  EXPECT_EQ(writes_u8(0x1019, 0, 10), 0U) << "no change";
  ASSERT_EQ(writes_u32(0x1006, 0, 0), 0U);
  EXPECT_EQ(writes_u8(0x1019, 0, 20), 0U);
}

TEST_F(SyncCounter, BeginsTheCycleOfATpdoAtItsStartValue) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  map_cyclic(1, 4);
  operate();

  EXPECT_EQ(answered(1, 8, 10), (Counters{4, 5, 6, 7, 8}));
}

TEST_F(SyncCounter, CountsTheSyncOfTheStartValueAsTheFirst) {
  ASSERT_EQ(writes_u8(0x1019, 0, 12), 0U);
  map_cyclic(3, 4);
  operate();

  EXPECT_EQ(answered(2, 22, 12), (Counters{6, 9, 12, 3, 6, 9}));
}

TEST_F(SyncCounter, ShiftsTpdosAgainstEachOther) {
  ASSERT_EQ(writes_u8(0x1019, 0, 4), 0U);
  map_cyclic(2, 2);
  ASSERT_EQ(writes_u8(0x1803, 6, 1), 0U);
  map(0x1803, 0x40000505, 2, {0x60410010});
  operate();

  EXPECT_EQ(says("080#01"), Lines{});
  EXPECT_EQ(says("080#02"), (Lines{"505#4000"}));
  EXPECT_EQ(says("080#03"), (Lines{"455#4000"}));
  EXPECT_EQ(says("080#04"), (Lines{"505#4000"}));
  EXPECT_EQ(says("080#01"), (Lines{"455#4000"}));
}

TEST_F(SyncCounter, BeginsAnewWhenOperationalIsEntered) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  map_cyclic(1, 4);
  operate();
  EXPECT_EQ(answered(3, 3, 10), (Counters{4, 5}));

  says("000#8005");
  operate();

  EXPECT_EQ(answered(6, 10, 10), (Counters{4, 5}));
}

TEST_F(SyncCounter, HoldsBackTpdosThatWaitForAChangeToo) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  map_cyclic(0, 3);
  operate();

  EXPECT_EQ(answered(1, 5, 10), (Counters{3}));
}

TEST_F(SyncCounter, IsNotAwaitedWhereSyncCarriesNone) {
  map_cyclic(2, 4);
  operate();

  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(says("080#"), (Lines{"455#4000"}));
}

TEST_F(SyncCounter, KeepsTheStartValueOfAValidTpdo) {
  map_cyclic(1, 4);
  EXPECT_EQ(writes_u8(0x1804, 6, 5), kDeviceState);
  ASSERT_EQ(writes_u32(0x1804, 1, 0xC0000405), 0U);
  EXPECT_EQ(writes_u8(0x1804, 6, 5), 0U);
  EXPECT_EQ(writes_u8(0x1804, 6, 241), kInvalidValue);
  EXPECT_EQ(writes_u8(0x1804, 6, 240), 0U);
}

TEST_F(SyncCounter, ComesUnderAnIdentifierOf29BitsToo) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  ASSERT_EQ(writes_u32(0x1005, 0, 0x20000080), 0U);
  map_cyclic(1, 0);
  operate();

  EXPECT_EQ(says("080#01"), Lines{});
  EXPECT_EQ(says("00000080#01"), (Lines{"455#4000"}));
}

TEST_F(SyncCounter, TakesItsStoredOverflowWithAReset) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  says("000#8205");
  operate();

  EXPECT_EQ(says("080#01"), Lines{});
  EXPECT_EQ(application.errors, (Lines{"8240 1"})) << "the initial value is 0 again";
}

TEST_F(SyncCounter, TellsThatItsErrorEndsWithAReset) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  says("080#");

  says("000#8205");

  EXPECT_EQ(application.errors, (Lines{"8240 0", "8240 0 over"}));
}

}  // namespace
