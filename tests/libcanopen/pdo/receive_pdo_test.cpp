#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

class ReceivePdos : public NodeTest {
 protected:
  void SetUp() override { start_operational(); }
};

TEST_F(ReceivePdos, StoreTheirValuesAtOnceAndTellTheApplication) {
  says("305#0F00FD");

  EXPECT_EQ(value_of(0x6040), 0x000F);
  EXPECT_EQ(value_of(0x6060), -3);
  EXPECT_EQ(application.told, (Lines{"RPDO 1"}));
}

TEST_F(ReceivePdos, IgnoreAndCountFramesShorterThanTheirMapping) {
  says("305#0F00");
  says("205#0F");
  says("205#");

  EXPECT_EQ(value_of(0x6040), 1);
  EXPECT_EQ(application.told, Lines{});
  EXPECT_EQ(node->short_rpdos(), 3U);
}

TEST_F(ReceivePdos, UseTheMappedPartOfLongerFrames) {
  says("205#0F00FFFFFFFFFFFF");

  EXPECT_EQ(value_of(0x6040), 0x000F);
  EXPECT_EQ(value_of(0x6060), 0);
  EXPECT_EQ(node->short_rpdos(), 0U);
}

TEST_F(ReceivePdos, IgnoreRemoteAndExtendedFrames) {
  says("205#R2");
  says("00000205#0F00");

  EXPECT_EQ(value_of(0x6040), 1);
  EXPECT_EQ(node->short_rpdos(), 0U);
}

TEST_F(ReceivePdos, OfSynchronousTypeTakeEffectWithTheNextSync) {
  says("405#0F0078563412");
  says("405#1F0021436587");
  EXPECT_EQ(value_of(0x6040), 1);

  says("080#");

  EXPECT_EQ(value_of(0x6040), 0x001F);
  EXPECT_EQ(value_of(0x60FF), static_cast<std::int32_t>(0x87654321));
  EXPECT_EQ(application.told, (Lines{"RPDO 2"}));

  says("080#");
  EXPECT_EQ(application.told, (Lines{"RPDO 2"}));
}

TEST_F(ReceivePdos, AreSynchronousFromType0To240) {
  for (const std::uint32_t type : {0U, 1U, 2U, 240U}) {
    ASSERT_EQ(writes_u8(0x1400, 2, type), 0U);
    store_value(0x6040, 0, 0);
    says("205#3412");
    EXPECT_EQ(value_of(0x6040), 0) << type;
    says("080#");
    EXPECT_EQ(value_of(0x6040), 0x1234) << type;
  }
  for (const std::uint32_t type : {254U, 255U}) {
    ASSERT_EQ(writes_u8(0x1400, 2, type), 0U);
    store_value(0x6040, 0, 0);
    says("205#3412");
    EXPECT_EQ(value_of(0x6040), 0x1234) << type;
  }
}

TEST_F(ReceivePdos, ForgetWhatWaitsForSyncWhenOperationalIsLeft) {
  says("405#0F0078563412");

  says("000#8005");
  says("000#0105");
  says("080#");

  EXPECT_EQ(value_of(0x6040), 1);
}

TEST_F(ReceivePdos, ForgetWhatWaitsForSyncWhenTheyBecomeInvalid) {
  says("405#0F0078563412");

  ASSERT_EQ(writes_u32(0x1402, 1, 0x80000405), 0U);
  says("080#");

  EXPECT_EQ(value_of(0x6040), 1);
}

TEST_F(ReceivePdos, UseTheMappingThatWasInForceWhenTheFrameCame) {
  ASSERT_EQ(writes_u32(0x1402, 1, 0x80000405), 0U);
  ASSERT_EQ(writes_u8(0x1602, 0, 0), 0U);
  ASSERT_EQ(writes_u32(0x1602, 1, 0x20140010), 0U);
  ASSERT_EQ(writes_u32(0x1602, 2, 0x20160018), 0U);
  ASSERT_EQ(writes_u32(0x1602, 3, 0x20200010), 0U);
  ASSERT_EQ(writes_u8(0x1602, 0, 3), 0U);
  ASSERT_EQ(writes_u32(0x1402, 1, 0x00000406), 0U);

  says("405#01000000000000");
  EXPECT_TRUE(application.told.empty());
  says("406#0100AABBCC3412");
  says("080#");

  EXPECT_EQ(value_of(0x2014), 1);
  EXPECT_EQ(value_of(0x2016), 0xCCBBAA);
  EXPECT_EQ(value_of(0x2020), 0x1234);
  EXPECT_EQ(value_of(0x2017), 0) << "the neighbour of a three-byte value";
}

TEST_F(ReceivePdos, CarryValuesOfOddSizes) {
  ASSERT_EQ(writes_u32(0x1603, 1, 0x20160018), 0U);  // UNSIGNED24
  ASSERT_EQ(writes_u32(0x1603, 2, 0x201A0028), 0U);  // INTEGER40
  ASSERT_EQ(writes_u8(0x1603, 0, 2), 0U);
  ASSERT_EQ(writes_u32(0x1403, 1, 0x00000505), 0U);

  says("505#AABBCC01000000FF");

  EXPECT_EQ(value_of(0x2016), 0xCCBBAA);
  EXPECT_EQ(value_of(0x201A), -(1LL << 32) + 1);
}

}  // namespace
