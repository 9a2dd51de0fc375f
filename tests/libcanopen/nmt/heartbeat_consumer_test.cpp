#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::NmtState;

constexpr const char* kNode7Lost = "085#3081110700000000";
constexpr const char* kErrorReset = "085#0000000000000000";

class HeartbeatConsumer : public ServiceTest {
 protected:
  /// Boots the node, which then watches node 7 with 100 ms.
  void start_watching() {
    start();
    ASSERT_EQ(writes_u32(0x1016, 1, 0x00070064), 0U);
    told();
  }
  /// Boots the node and lets node 7 fall silent.
  void start_and_lose() {
    start_watching();
    says("707#05");
    ASSERT_EQ(passes(100ms).size(), 1U);
    told(), errors();
  }
};

TEST_F(HeartbeatConsumer, WaitsForTheFirstHeartbeatAsLongAsItTakes) {
  start_watching();

  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(errors(), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(HeartbeatConsumer, ReportsATimeOutOnceAndItsEndWithTheNextHeartbeat) {
  start_watching();
  says("707#05");

  EXPECT_EQ(passes(99ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"100ms 085#3081110700000000"}));
  EXPECT_EQ(errors(), (Lines{"8130 7"}));
  EXPECT_EQ(passes(1h), Lines{});

  EXPECT_EQ(says("707#05"), Lines{kErrorReset});
  EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
  EXPECT_EQ(passes(100ms).size(), 1U) << "watching goes on";
}

TEST_F(HeartbeatConsumer, IsContentWhileHeartbeatsCome) {
  start_watching();

  for (int i = 0; i < 50; ++i) {
    says("707#05");
    EXPECT_EQ(passes(99ms), Lines{});
  }

  EXPECT_EQ(errors(), Lines{});
}

TEST_F(HeartbeatConsumer, TakesAHeartbeatAtTheVeryMomentOfTheTimeOut) {
  start_watching();
  says("707#05");

  now += 100ms;
  EXPECT_EQ(says("707#05"), Lines{});

  EXPECT_EQ(errors(), Lines{});
}

TEST_F(HeartbeatConsumer, DoesNotMoveItsTimerWithEveryHeartbeat) {
  start_watching();
  says("707#05");
  now += 40ms;
  says("707#05");

  EXPECT_EQ(node->next_deadline(), kStart + 100ms);
  EXPECT_EQ(passes(99ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"140ms 085#3081110700000000"}));
}

TEST_F(HeartbeatConsumer, TellsEveryChangeOfStateAndEveryBootUp) {
  start_watching();

  for (const char* const frame : {"707#7F", "707#7F", "707#05", "707#04", "707#00", "707#00", "707#7F"})
    says(frame);

  EXPECT_EQ(told(), (Lines{"node 7: Pre-operational", "node 7: Operational", "node 7: Stopped",
                           "node 7: Initialising", "node 7: Initialising", "node 7: Pre-operational"}));
}

TEST_F(HeartbeatConsumer, TellsTheStateOfANodeThatComesBack) {
  start_and_lose();

  says("707#05");

  EXPECT_EQ(told(), (Lines{"node 7: Operational"}));
}

TEST_F(HeartbeatConsumer, LooksThroughTheToggleBitOfNodeGuarding) {
  start_watching();

  says("707#85");
  says("707#05");
  says("707#FF");

  EXPECT_EQ(told(), (Lines{"node 7: Operational", "node 7: Pre-operational"}));
}

TEST_F(HeartbeatConsumer, TakesAnUnknownStateForASignOfLifeOnly) {
  start_watching();
  says("707#33");

  EXPECT_EQ(told(), Lines{});
  EXPECT_EQ(passes(100ms), (Lines{"100ms 085#3081110700000000"}));
}

TEST_F(HeartbeatConsumer, BeginsAnewAfterABootUpMessage) {
  start_watching();
  says("707#05");

  EXPECT_EQ(says("707#00"), Lines{});
  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(errors(), Lines{});

  says("707#7F");
  EXPECT_EQ(passes(100ms).size(), 1U);
}

TEST_F(HeartbeatConsumer, TakesNoBootUpMessageForTheEndOfATimeOut) {
  start_and_lose();

  EXPECT_EQ(says("707#00"), Lines{});
  EXPECT_EQ(told(), (Lines{"node 7: Initialising"}));
  EXPECT_EQ(errors(), Lines{});

  EXPECT_EQ(says("707#7F"), Lines{kErrorReset});
}

TEST_F(HeartbeatConsumer, IgnoresFramesThatAreNoHeartbeat) {
  start_watching();

  for (const char* const frame : {"707#", "707#0505", "707#R", "00000707#05", "708#05"}) says(frame);

  EXPECT_EQ(told(), Lines{});
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(HeartbeatConsumer, WatchesEachNodeWithItsOwnTime) {
  start();
  writes_u32(0x1016, 1, 0x00070064);
  writes_u32(0x1016, 3, 0x007F0032);
  says("707#05");
  says("77F#05");

  EXPECT_EQ(passes(1h), (Lines{"50ms 085#3081117F00000000", "100ms 085#3081110700000000"}));
  EXPECT_EQ(says("77F#05"), (Lines{"085#0000110000000000"})) << "node 7 is still silent";
  EXPECT_EQ(says("707#05"), Lines{kErrorReset});
}

TEST_F(HeartbeatConsumer, JudgesItsEntries) {
  struct Row {
    std::uint8_t sub_index;
    std::uint32_t value, abort;
  };
  const Row rows[] = {
      {1, 0x00050064, 0x06090030},                                                            // the node itself
      {1, 0x00050000, 0},                                                                     // but not watched
      {1, 0x01070064, 0x06090030},                                                            // reserved bits
      {1, 0x00000064, 0},                                                                     // no node
      {1, 0x00800064, 0},                                                                     // no node either
      {1, 0x00070064, 0},          {1, 0x00070032, 0},          {2, 0x00070064, 0x06040043},  // twice
      {2, 0x00070000, 0},                                                                     // not used
      {2, 0x00080064, 0},          {2, 0x00070064, 0x06040043}, {1, 0x00000000, 0},          {2, 0x00070064, 0},
  };
  start();

  for (const Row& row : rows) {
    EXPECT_EQ(writes_u32(0x1016, row.sub_index, row.value), row.abort) << std::hex << row.value;
  }
}

TEST_F(HeartbeatConsumer, KeepsWatchingWhatItWatchedWhenAWriteIsRefused) {
  start_watching();
  says("707#05");

  EXPECT_EQ(writes_u32(0x1016, 1, 0x00050064), 0x06090030U);

  EXPECT_EQ(value_of(0x1016, 1), 0x00070064);
  EXPECT_EQ(passes(100ms), (Lines{"100ms 085#3081110700000000"}));
}

TEST_F(HeartbeatConsumer, RefusesANodeWhoseIdentifierAnotherServiceUses) {
  store_value(0x1012, 0, 0x80000707);
  start();

  EXPECT_EQ(writes_u32(0x1016, 1, 0x00070064), 0x06040043U);
}

TEST_F(HeartbeatConsumer, ListensToTheNodesOfItsEntries) {
  start();
  const auto before = subscriptions();
  const int changes = application.subscription_changes;

  writes_u32(0x1016, 2, 0x00070064);
  EXPECT_EQ(application.subscription_changes, changes + 1);
  EXPECT_TRUE(std::ranges::binary_search(subscriptions(), 0x707U));

  writes_u32(0x1016, 2, 0);
  EXPECT_EQ(application.subscription_changes, changes + 2);
  EXPECT_EQ(subscriptions(), before);
}

TEST_F(HeartbeatConsumer, WorksInEveryState) {
  for (const NmtState state : {NmtState::PreOperational, NmtState::Operational, NmtState::Stopped}) {
    SCOPED_TRACE(name_of(state));
    start_watching();
    take_to(state);

    says("707#05");
    EXPECT_EQ(told(), (Lines{"node 7: Operational"}));
    EXPECT_EQ(passes(100ms).size(), state == NmtState::Stopped ? 0U : 1U) << "EMCY does not work in Stopped";
    EXPECT_EQ(errors(), (Lines{"8130 7"}));
    says("707#05");
    EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
    says("000#8205");
  }
}

TEST_F(HeartbeatConsumer, BeginsAnewWithANewTime) {
  start_watching();
  says("707#05");

  EXPECT_EQ(writes_u32(0x1016, 1, 0x0007000A), 0U);
  EXPECT_EQ(passes(1s), Lines{});

  says("707#05");
  EXPECT_EQ(passes(10ms), (Lines{"1010ms 085#3081110700000000"}));
}

TEST_F(HeartbeatConsumer, EndsTheErrorOfANodeThatItNoLongerWatches) {
  start_and_lose();

  EXPECT_EQ(says("605#2316100100000000"), (Lines{kErrorReset, "585#6016100100000000"}));

  EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
  EXPECT_EQ(says("707#05"), Lines{});
}

TEST_F(HeartbeatConsumer, UsesNoStoredEntryThatCouldNotBeWritten) {
  store_value(0x1016, 1, 0x00070064);
  store_value(0x1016, 2, 0x00070032);  // node 7 again
  store_value(0x1016, 3, 0x00050032);  // the node itself
  start();

  says("707#05");
  says("705#05");

  EXPECT_EQ(passes(1h), (Lines{std::string{"100ms "} + kNode7Lost}));
}

TEST_F(HeartbeatConsumer, ForgetsATimeOutWithAReset) {
  start_and_lose();

  EXPECT_EQ(says("000#8205"), (Lines{"705#00"}));

  EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
  EXPECT_EQ(value_of(0x1016, 1), 0);
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(HeartbeatConsumer, BeginsAnewWhenTheNodeIsStartedAgain) {
  start_and_lose();

  EXPECT_EQ(start(), (Lines{"705#00"}));
  EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
  EXPECT_EQ(passes(1h), Lines{});

  says("707#05");
  EXPECT_EQ(passes(100ms).size(), 1U);
}

}  // namespace
