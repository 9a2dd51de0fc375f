#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

using canopen::ErrorKeeping;
using canopen::NmtState;

/// A node that wants SYNC every 10 ms once it has come.
class SyncSupervision : public PdoTest {
 protected:
  explicit SyncSupervision(const canopen::Policy& policy = {.error_keeping = ErrorKeeping::Owner,
                                                            .sync_supervision = true})
      : PdoTest{policy} {}
  void SetUp() override {
    start();
    ASSERT_EQ(writes_u32(0x1006, 0, 10'000), 0U);
    application.errors.clear();
  }
  /// The application has stored @p period for after a reset.
  void is_stored(std::int64_t period) {
    application.reaction = [this, period](const std::string& what) {
      if (what == "reset 130") store_value(0x1006, 0, period);
    };
  }
  /// What came and went since the last of these calls.
  Lines errors() { return std::exchange(application.errors, {}); }
};

TEST_F(SyncSupervision, TellsOnceThatSyncIsMissingAndOfItsReturn) {
  operate();
  for (int i = 0; i < 5; ++i) {
    says("080#");
    passes(14ms);
  }
  EXPECT_EQ(errors(), Lines{});
  passes(999us);
  EXPECT_EQ(errors(), Lines{});
  passes(1us);
  EXPECT_EQ(errors(), (Lines{"8700 0"})) << "15 ms after the last one";
  passes(1s);
  EXPECT_EQ(errors(), Lines{});

  says("080#");
  EXPECT_EQ(errors(), (Lines{"8700 0 over"}));
  passes(15ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, BeginsWithTheFirstSyncInOperational) {
  says("080#");
  passes(1s);
  operate();
  passes(1s);
  EXPECT_EQ(errors(), Lines{}) << "that one came before";

  says("080#");
  passes(15ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, RestsOutsideOperational) {
  operate();
  says("080#");
  says("000#8005");
  passes(1s);
  EXPECT_EQ(errors(), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);

  operate();
  says("080#");
  passes(15ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
  says("000#0205");
  says("000#8005");
  EXPECT_EQ(errors(), Lines{}) << "it is still missing";
  says("080#");
  EXPECT_EQ(errors(), (Lines{"8700 0 over"}));
}

TEST_F(SyncSupervision, BeginsAnewWithOperational) {
  says("080#");
  operate();
  passes(20ms);
  EXPECT_EQ(errors(), Lines{}) << "that one came before";

  says("080#");
  says("000#8005");
  operate();
  passes(20ms);
  EXPECT_EQ(errors(), Lines{}) << "so did that one";
}

TEST_F(SyncSupervision, IsOffWithAPeriodOf0) {
  ASSERT_EQ(writes_u32(0x1006, 0, 0), 0U);
  operate();
  says("080#");
  passes(1s);
  EXPECT_EQ(errors(), Lines{});
}

TEST_F(SyncSupervision, FollowsANewPeriod) {
  operate();
  says("080#");
  passes(5ms);
  ASSERT_EQ(writes_u32(0x1006, 0, 1000), 0U);
  passes(1499us);
  EXPECT_EQ(errors(), Lines{}) << "from the write on";
  passes(1us);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));

  ASSERT_EQ(writes_u32(0x1006, 0, 0), 0U);
  EXPECT_EQ(errors(), (Lines{"8700 0 over"}));
  ASSERT_EQ(writes_u32(0x1006, 0, 1000), 0U);
  passes(1s);
  EXPECT_EQ(errors(), Lines{}) << "from a first SYNC on";
}

TEST_F(SyncSupervision, KnowsTheLongestPeriodToo) {
  ASSERT_EQ(writes_u32(0x1006, 0, 0xFFFFFFFF), 0U);
  operate();
  says("080#");
  passes(std::chrono::microseconds{0xFFFFFFFF});
  EXPECT_EQ(errors(), Lines{});
  passes(std::chrono::microseconds{0xFFFFFFFF / 2 + 1});
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, TakesTheStoredPeriodWithAReset) {
  is_stored(2000);
  says("000#8205");
  operate();
  says("080#");
  passes(3ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, EndsWithAReset) {
  is_stored(10'000);
  operate();
  says("080#");
  passes(15ms);
  errors();

  says("000#8205");
  EXPECT_EQ(errors(), (Lines{"8700 0 over"}));
  operate();
  passes(1s);
  EXPECT_EQ(errors(), Lines{});
}

TEST_F(SyncSupervision, GoesOnThroughAReload) {
  operate();
  says("080#");
  passes(10ms);
  node->reload(now);
  sent();
  passes(5ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, CountsOnlyASyncThatIsOne) {
  operate();
  says("080#");
  passes(10ms);
  says("080#0102");
  EXPECT_EQ(errors(), (Lines{"8240 2"}));
  passes(5ms);
  EXPECT_EQ(errors(), (Lines{"8700 0"}));
}

TEST_F(SyncSupervision, LeavesOperationalAlone) {
  operate();
  says("080#");
  passes(15ms);
  EXPECT_EQ(node->state(), NmtState::Operational) << "1029h is for others";
}

class SyncSupervisionKeptByTheLibrary : public SyncSupervision {
 protected:
  SyncSupervisionKeptByTheLibrary() : SyncSupervision{{.sync_supervision = true}} {}
};

TEST_F(SyncSupervisionKeptByTheLibrary, IsSentAsAnEmergency) {
  operate();
  says("080#");
  sent();
  EXPECT_EQ(passes(15ms), (Lines{"15ms 085#0087110000000000"}));
}

class SyncWithoutSupervision : public PdoTest {};

TEST_F(SyncWithoutSupervision, MayBeMissing) {
  start();
  ASSERT_EQ(writes_u32(0x1006, 0, 10'000), 0U);
  operate();
  says("080#");
  passes(1s);
  EXPECT_EQ(application.errors, Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

}  // namespace
