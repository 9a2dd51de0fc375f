#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

using canopen::ErrorKeeping;
using canopen::NmtState;
using canopen::SyncOrder;

/// RPDO 3 (6040h, 60FFh) and RPDO 5 (6060h) go with SYNC, and so do TPDO 2 (6041h, 606Ch) and TPDO 5 (2014h); RPDO
/// 4 (2014h) does too.
class SyncOrderTest : public PdoTest {
 protected:
  explicit SyncOrderTest(SyncOrder order) : PdoTest{{.error_keeping = ErrorKeeping::Owner, .sync_order = order}} {}
  void SetUp() override {
    start();
    ASSERT_EQ(writes_u32(0x1802, 1, 0xC0000385), 0U);
    map(0x1403, 0x00000505, 1, {0x20140010});
    map(0x1404, 0x00000506, 1, {0x60600008});
    map(0x1804, 0x40000455, 1, {0x20140010});
    operate();
    application.told.clear();
  }
  /// All three RPDOs come.
  void all_come() {
    says("405#0F0078563412");
    says("505#3412");
    says("506#07");
  }
};

class SyncThatReceivesFirst : public SyncOrderTest {
 protected:
  SyncThatReceivesFirst() : SyncOrderTest{SyncOrder::ReceiveFirst} {}
};

TEST_F(SyncThatReceivesFirst, SendsWhatHasJustBeenReceived) {
  says("505#3412");
  EXPECT_EQ(says("080#"), (Lines{"285#400000000000", "455#3412"}));
}

TEST_F(SyncThatReceivesFirst, StoresAllRpdosBeforeTheApplicationLearnsOfAny) {
  Lines seen;
  application.reaction = [&](const std::string& what) {
    seen.push_back(what + ": " + std::to_string(value_of(0x6040)) + ' ' + std::to_string(value_of(0x2014)) + ' ' +
                   std::to_string(value_of(0x6060)));
  };
  all_come();
  EXPECT_EQ(seen, Lines{});
  says("080#");

  EXPECT_EQ(seen, (Lines{"RPDO 2: 15 4660 7", "RPDO 3: 15 4660 7", "RPDO 4: 15 4660 7",
                         "synchronous RPDOs: 15 4660 7", "SYNC: 15 4660 7"}));
}

TEST_F(SyncThatReceivesFirst, SendsWhatTheApplicationMakesOfItInTheSameSync) {
  application.reaction = [&](const std::string& what) {
    if (what == "synchronous RPDOs") store_value(0x6041, 0, value_of(0x6040) + 0x1200);
  };
  all_come();
  EXPECT_EQ(says("080#"), (Lines{"285#0F1200000000", "455#3412"}));
}

TEST_F(SyncThatReceivesFirst, TellsTheApplicationOfASyncWithoutRpdosToo) {
  application.reaction = [&](const std::string& what) {
    if (what == "synchronous RPDOs") store_value(0x606C, 0, 7);
  };
  EXPECT_EQ(says("080#"), (Lines{"285#400007000000", "455#0000"}));
  EXPECT_EQ(application.told, (Lines{"synchronous RPDOs"}));
}

TEST_F(SyncThatReceivesFirst, AppliesAnRpdoOnce) {
  all_come();
  says("080#");
  application.told.clear();
  says("080#");
  EXPECT_EQ(application.told, (Lines{"synchronous RPDOs"}));
}

TEST_F(SyncThatReceivesFirst, TakesTheLatestFrameOfAnRpdo) {
  says("505#3412");
  says("505#7856");
  says("080#");
  EXPECT_EQ(value_of(0x2014), 0x5678);
  EXPECT_EQ(application.told, (Lines{"RPDO 3", "synchronous RPDOs"}));
}

TEST_F(SyncThatReceivesFirst, LeavesEventDrivenRpdosWhereTheyAre) {
  says("205#1F00");
  EXPECT_EQ(value_of(0x6040), 0x1F);
  EXPECT_EQ(application.told, (Lines{"RPDO 0"}));
}

TEST_F(SyncThatReceivesFirst, EndsWhereTheApplicationLeavesOperational) {
  application.reaction = [&](const std::string& what) {
    if (what == "RPDO 2") node->apply_error_behaviour(1);
  };
  all_come();
  EXPECT_EQ(says("080#"), Lines{}) << "no TPDO outside Operational";
  EXPECT_EQ(node->state(), NmtState::PreOperational);
  EXPECT_EQ(application.told, (Lines{"RPDO 2", "Operational -> Pre-operational"}));
  EXPECT_EQ(value_of(0x6060), 7) << "all had been stored";
}

TEST_F(SyncThatReceivesFirst, TellsNothingOutsideOperational) {
  says("000#8005");
  application.told.clear();
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(application.told, Lines{});
}

TEST_F(SyncThatReceivesFirst, DropsWhatComesAfterTheWindow) {
  ASSERT_EQ(writes_u32(0x1007, 0, 1000), 0U);
  says("080#");
  now += 1001us;
  says("505#3412");
  EXPECT_EQ(says("080#").back(), "455#0000");
  EXPECT_EQ(node->late_rpdos(), 1U);
}

TEST_F(SyncThatReceivesFirst, CountsItsTpdosFromTheirStartValue) {
  says("000#8005");
  ASSERT_EQ(writes_u32(0x1801, 1, 0xC0000285), 0U);
  ASSERT_EQ(writes_u8(0x1019, 0, 6), 0U);
  ASSERT_EQ(writes_u32(0x1804, 1, 0xC0000455), 0U);
  ASSERT_EQ(writes_u8(0x1804, 2, 2), 0U);
  ASSERT_EQ(writes_u8(0x1804, 6, 3), 0U);
  ASSERT_EQ(writes_u32(0x1804, 1, 0x40000455), 0U);
  operate();
  Lines answered;
  for (const char* const sync : {"080#01", "080#02", "080#03", "080#04", "080#05", "080#06", "080#01"})
    if (!says(sync).empty()) answered.emplace_back(sync);
  EXPECT_EQ(answered, (Lines{"080#04", "080#06"}));
}

class SyncThatTransmitsFirst : public SyncOrderTest {
 protected:
  SyncThatTransmitsFirst() : SyncOrderTest{canopen::Policy{}.sync_order} {}
};

TEST_F(SyncThatTransmitsFirst, IsTheDefault) {
  Lines seen;
  application.reaction = [&](const std::string& what) {
    seen.push_back(what + ": " + std::to_string(value_of(0x6040)) + ' ' + std::to_string(value_of(0x2014)) + ' ' +
                   std::to_string(value_of(0x6060)));
  };
  all_come();
  EXPECT_EQ(says("080#"), (Lines{"285#400000000000", "455#0000"}));
  EXPECT_EQ(seen, (Lines{"RPDO 2: 15 0 0", "RPDO 3: 15 4660 0", "RPDO 4: 15 4660 7", "SYNC: 15 4660 7"}));
}

/// A SYNC of a wrong length is a SYNC all the same.
class SyncOfAnyLength : public PdoTest {
 protected:
  SyncOfAnyLength() : PdoTest{{.error_keeping = ErrorKeeping::Owner, .sync_of_any_length = true}} {}
  void SetUp() override {
    start();
    ASSERT_EQ(writes_u32(0x1802, 1, 0xC0000385), 0U);
  }
};

TEST_F(SyncOfAnyLength, CountsAndIsReportedAllTheSame) {
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  operate();
  EXPECT_EQ(says("080#"), (Lines{"285#400000000000"}));
  EXPECT_EQ(says("080#0102"), (Lines{"285#400000000000"}));
  EXPECT_EQ(application.errors, (Lines{"8240 0"})) << "once";
  EXPECT_EQ(says("080#03"), (Lines{"285#400000000000"}));
  EXPECT_EQ(application.errors, (Lines{"8240 0", "8240 0 over"}));
}

TEST_F(SyncOfAnyLength, HasACounterWhereOneBelongs) {
  operate();
  says("080#07");
  EXPECT_EQ(application.syncs.back(), "SYNC") << "1019h is 0";
  says("000#8005");
  ASSERT_EQ(writes_u8(0x1019, 0, 10), 0U);
  operate();
  says("080#08");
  EXPECT_EQ(application.syncs.back(), "SYNC 8");
  says("080#0908");
  EXPECT_EQ(application.syncs.back(), "SYNC 9");
  says("080#");
  EXPECT_EQ(application.syncs.back(), "SYNC");
}

}  // namespace
