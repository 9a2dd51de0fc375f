#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::NmtState;

class TimeConsumer : public ServiceTest {
 protected:
  /// Boots the node, which then consumes TIME.
  void start_consuming() {
    start();
    ASSERT_EQ(writes_u32(0x1012, 0, 0x80000100), 0U);
    told();
  }
};

constexpr const char* kNoon = "100#002E930239300000";

TEST_F(TimeConsumer, TellsTheApplicationTheTime) {
  start_consuming();

  says("100#002E93023930");

  EXPECT_EQ(told(), (Lines{"day 12345, 43200000 ms"}));
}

TEST_F(TimeConsumer, LooksThroughTheVoidBits) {
  start_consuming();

  says("100#002E93F23930");

  EXPECT_EQ(told(), (Lines{"day 12345, 43200000 ms"}));
}

TEST_F(TimeConsumer, IgnoresFramesThatAreNoTimeStamp) {
  start_consuming();

  for (const char* const frame :
       {kNoon, "100#", "100#002E930239", "100#002E9302393000", "100#R6", "00000100#002E93023930"})
    says(frame);

  EXPECT_EQ(told(), Lines{});
}

TEST_F(TimeConsumer, IsOffUnlessBit31IsSet) {
  start();
  told();
  EXPECT_FALSE(std::ranges::binary_search(subscriptions(), 0x100U));
  says("100#002E93023930");
  EXPECT_EQ(told(), Lines{});

  EXPECT_EQ(writes_u32(0x1012, 0, 0x80000100), 0U);
  EXPECT_TRUE(std::ranges::binary_search(subscriptions(), 0x100U));
  EXPECT_EQ(writes_u32(0x1012, 0, 0x00000100), 0U);

  says("100#002E93023930");
  EXPECT_EQ(told(), Lines{});
}

TEST_F(TimeConsumer, WorksInPreOperationalAndOperationalOnly) {
  start_consuming();

  for (const NmtState state : {NmtState::PreOperational, NmtState::Operational, NmtState::Stopped}) {
    take_to(state);
    says("100#002E93023930");
    EXPECT_EQ(told().size(), state == NmtState::Stopped ? 0U : 1U) << name_of(state);
  }
}

TEST_F(TimeConsumer, JudgesItsCobId) {
  struct Row {
    std::uint32_t cob_id, abort;
  };
  const Row rows[] = {
      {0x40000100, 0x06090030},  // would produce
      {0xC0000100, 0x06090030},  // would do both
      {0xA0000100, 0x06090030},  // 29 bits
      {0x80000900, 0x06090030},  // stray bits
      {0x80000000, 0x06090030}, {0x80000101, 0x06090030}, {0x80000705, 0x06090030},
      {0x80000085, 0x06040043},  // EMCY
      {0x00000085, 0},           // but not used
      {0x00000100, 0},          {0x80000100, 0},          {0x80000100, 0},
      {0x80000200, 0x08000022},  // only while it is off
      {0x00000200, 0x08000022}, {0x00000100, 0},          {0x80000200, 0},
  };
  start();

  for (const Row& row : rows) EXPECT_EQ(writes_u32(0x1012, 0, row.cob_id), row.abort) << std::hex << row.cob_id;
}

TEST_F(TimeConsumer, ListensToItsNewIdentifier) {
  start();
  const int changes = application.subscription_changes;

  EXPECT_EQ(writes_u32(0x1012, 0, 0x80000200), 0U);

  EXPECT_EQ(application.subscription_changes, changes + 1);
  told();
  says("100#002E93023930");
  EXPECT_EQ(told(), Lines{});
  says("200#000000000000");
  EXPECT_EQ(told(), (Lines{"day 0, 0 ms"}));
}

TEST_F(TimeConsumer, ReturnsToItsInitialCobIdAfterResetCommunication) {
  start_consuming();

  says("000#8205");
  told();

  says("100#002E93023930");
  EXPECT_EQ(told(), Lines{});
}

TEST_F(TimeConsumer, ConsumesWhatWasStored) {
  store_value(0x1012, 0, 0x80000100);
  start();
  told();

  says("100#002E93023930");

  EXPECT_EQ(told().size(), 1U);
}

class TimeOfAnyIdentifier : public ServiceTest {
 protected:
  TimeOfAnyIdentifier() : ServiceTest{canopen::Policy{}} {}
};

TEST_F(TimeOfAnyIdentifier, ComesUnderAnIdentifierOf29BitsToo) {
  start();
  EXPECT_EQ(writes_u32(0x1012, 0, 0xA0000100), 0U);
  told();

  says("00000100#002E93023930");

  EXPECT_EQ(told(), (Lines{"day 12345, 43200000 ms"}));
}

using NodeWithoutTime = NodeTest;

TEST_F(NodeWithoutTime, IgnoresTimeStamps) {
  start();
  application.told.clear();

  says("100#002E93023930");

  EXPECT_TRUE(application.told.empty());
}

}  // namespace
