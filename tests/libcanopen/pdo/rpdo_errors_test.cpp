#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

class RpdoErrors : public PdoTest {
 protected:
  using PdoTest::PdoTest;
  void SetUp() override {
    start_operational();
    application.errors.clear();
  }
};

TEST_F(RpdoErrors, TellOfFramesThatAreTooShortOnceUntilAGoodOne) {
  says("305#0F00");
  says("305#0F00");
  says("305#");
  EXPECT_EQ(application.errors, (Lines{"8210 2"}));
  EXPECT_EQ(value_of(0x6040), 1);

  says("305#0F0003");
  says("305#0F0003");
  EXPECT_EQ(application.errors, (Lines{"8210 2", "8210 2 over"}));
  EXPECT_EQ(value_of(0x6040), 0x0F);

  says("305#0F00");
  EXPECT_EQ(application.errors, (Lines{"8210 2", "8210 2 over", "8210 2"}));
  EXPECT_EQ(node->short_rpdos(), 4U);
}

TEST_F(RpdoErrors, TellOfFramesThatAreTooLongOnceAndUseThem) {
  says("205#0F00FF");
  says("205#1F00FF");
  EXPECT_EQ(application.errors, (Lines{"8220 1"}));
  EXPECT_EQ(value_of(0x6040), 0x1F);

  says("205#2F00");
  EXPECT_EQ(application.errors, (Lines{"8220 1", "8220 1 over"}));
  EXPECT_EQ(value_of(0x6040), 0x2F);
}

TEST_F(RpdoErrors, EndOneMisfitWhenTheOtherBegins) {
  says("205#0F00FF");
  says("205#0F");

  EXPECT_EQ(application.errors, (Lines{"8220 1", "8220 1 over", "8210 1"}));
}

TEST_F(RpdoErrors, ConcernSynchronousRpdosToo) {
  says("405#0F00");
  says("405#0F0078563412FF");
  says("080#");

  EXPECT_EQ(application.errors, (Lines{"8210 3", "8210 3 over", "8220 3"}));
  EXPECT_EQ(value_of(0x60FF), 0x12345678);
}

TEST_F(RpdoErrors, EndWithTheRpdo) {
  says("205#0F");
  ASSERT_EQ(writes_u32(0x1400, 1, 0x80000205), 0U);

  EXPECT_EQ(application.errors, (Lines{"8210 1", "8210 1 over"}));
}

TEST_F(RpdoErrors, DoNotComeFromAnRpdoWithoutMapping) {
  map(0x1404, 0x00000505, 255, {});
  application.told.clear();

  says("505#12");
  says("505#");

  EXPECT_EQ(application.errors, Lines{});
  EXPECT_EQ(application.told, Lines{});
}

TEST_F(RpdoErrors, TellOnceOfAMissedDeadline) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  passes(1s);
  EXPECT_EQ(application.errors, Lines{}) << "nobody has sent it yet";

  says("205#0F00");
  passes(15ms);
  says("205#0F00");
  passes(15ms);
  says("205#0F00");
  passes(19ms);
  EXPECT_EQ(application.errors, Lines{});
  passes(1ms);
  EXPECT_EQ(application.errors, (Lines{"8250 1"}));
  passes(1s);
  EXPECT_EQ(application.errors, (Lines{"8250 1"}));

  says("205#0F00");
  EXPECT_EQ(application.errors, (Lines{"8250 1", "8250 1 over"}));
  passes(20ms);
  EXPECT_EQ(application.errors, (Lines{"8250 1", "8250 1 over", "8250 1"}));
}

TEST_F(RpdoErrors, WatchSynchronousRpdosByTheirFrames) {
  ASSERT_EQ(writes_u16(0x1402, 5, 10), 0U);
  says("405#0F0078563412");
  for (int round = 0; round < 3; ++round) {
    passes(8ms);
    says("405#0F0078563412");
  }
  EXPECT_EQ(application.errors, Lines{});

  for (int round = 0; round < 3; ++round) {
    passes(8ms);
    says("080#");
  }
  EXPECT_EQ(application.errors, (Lines{"8250 3"}));
}

TEST_F(RpdoErrors, TakeNoShortFrameForASignOfLife) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  says("205#0F00");
  passes(15ms);
  says("205#0F");
  passes(5ms);

  EXPECT_EQ(application.errors, (Lines{"8210 1", "8250 1"}));
}

TEST_F(RpdoErrors, WatchNoDeadlineOutsideOperational) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  says("205#0F00");

  says("000#8005");

  EXPECT_EQ(node->next_deadline(), canopen::kNever);
  operate();
  passes(1s);
  EXPECT_EQ(application.errors, Lines{}) << "armed by the first frame";
}

TEST_F(RpdoErrors, FollowANewDeadline) {
  ASSERT_EQ(writes_u16(0x1400, 5, 100), 0U);
  says("205#0F00");
  ASSERT_EQ(writes_u16(0x1400, 5, 10), 0U);
  passes(10ms);
  EXPECT_EQ(application.errors, (Lines{"8250 1"}));

  ASSERT_EQ(writes_u16(0x1400, 5, 0), 0U);
  EXPECT_EQ(application.errors, (Lines{"8250 1", "8250 1 over"}));
  says("205#1F00");
  EXPECT_EQ(value_of(0x6040), 0x1F);
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(RpdoErrors, EndWithAReset) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  says("205#0F00");
  says("305#0F");
  passes(20ms);
  application.errors.clear();

  says("000#8205");

  EXPECT_EQ(application.errors, (Lines{"8250 1 over", "8210 2 over"}));
}

TEST_F(RpdoErrors, DropSynchronousRpdosAfterTheWindow) {
  ASSERT_EQ(writes_u32(0x1007, 0, 5000), 0U);
  says("405#0F0000000000");
  says("080#");
  EXPECT_EQ(value_of(0x6040), 0x0F) << "before the first SYNC there is no window";

  now += 5ms;
  says("405#1F0000000000");
  now += 1us;
  says("405#2F0000000000");
  EXPECT_EQ(node->late_rpdos(), 1U);
  says("080#");
  EXPECT_EQ(value_of(0x6040), 0x1F);

  says("405#3F0000000000");
  says("080#");
  EXPECT_EQ(value_of(0x6040), 0x3F) << "the window is open again";
}

TEST_F(RpdoErrors, LetEventDrivenRpdosPassAfterTheWindow) {
  ASSERT_EQ(writes_u32(0x1007, 0, 5000), 0U);
  says("080#");
  now += 1s;

  says("205#0F00");

  EXPECT_EQ(value_of(0x6040), 0x0F);
  EXPECT_EQ(node->late_rpdos(), 0U);
}

TEST_F(RpdoErrors, KnowNoWindowOfLengthZero) {
  ASSERT_EQ(writes_u32(0x1007, 0, 5000), 0U);
  says("080#");
  ASSERT_EQ(writes_u32(0x1007, 0, 0), 0U);
  says("080#");
  now += 1h;

  says("405#0F0000000000");
  says("080#");

  EXPECT_EQ(value_of(0x6040), 0x0F);
}

class RpdoErrorsKeptByTheLibrary : public RpdoErrors {
 protected:
  RpdoErrorsKeptByTheLibrary() : RpdoErrors{canopen::Policy{}} {}
};

TEST_F(RpdoErrorsKeptByTheLibrary, AreSentAsEmergencies) {
  EXPECT_EQ(says("305#0F00"), (Lines{"085#1082110200000000"}));
  EXPECT_EQ(says("305#0F00"), Lines{});
}

TEST_F(RpdoErrorsKeptByTheLibrary, AreSentWhenADeadlineIsMissed) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  says("205#0F00");
  EXPECT_EQ(passes(30ms), (Lines{"20ms 085#5082110100000000"}));
  EXPECT_EQ(says("205#0F00"), (Lines{"085#0000000000000000"}));
}

}  // namespace
