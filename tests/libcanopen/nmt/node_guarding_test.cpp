#include "tests/libcanopen/fixture/guarding_fixture.hpp"

namespace {

using namespace guarding_test;

TEST_F(NodeGuarding, AnswersWithItsStateAndAnAlternatingToggleBit) {
  start();

  expect_dialogue({
      {"705#R", "705#7F"},
      {"705#R", "705#FF"},
      {"000#0105", ""},
      {"705#R", "705#05"},
      {"705#R", "705#85"},
      {"000#0205", ""},
      {"705#R", "705#04"},
      {"705#R", "705#84"},
      {"000#8005", ""},
      {"705#R", "705#7F"},
  });
}

TEST_F(NodeGuarding, StartsWithToggleBit0AfterAReset) {
  start();
  says("705#R");

  expect_dialogue({
      {"000#8205", "705#00"},
      {"705#R", "705#7F"},
      {"000#8105", "705#00"},
      {"705#R", "705#7F"},
      {"705#R", "705#FF"},
  });
}

TEST_F(NodeGuarding, AnswersRequestsOfAnyLengthToItselfOnly) {
  EXPECT_EQ(says("705#R"), Lines{}) << "before start()";
  start();

  expect_dialogue({
      {"705#R1", "705#7F"},
      {"705#R8", "705#FF"},
      {"706#R", ""},
      {"00000705#R", ""},
      {"705#R", "705#7F"},
  });
}

TEST_F(NodeGuarding, AsksForTheRemoteFramesOfItsIdentifier) {
  start();

  const auto wanted = node->subscriptions();
  EXPECT_EQ(std::ranges::count(wanted, canopen::Subscription{0x705, true}), 1);
}

TEST_F(NodeGuarding, WatchesTheMasterFromItsFirstRequestOn) {
  start_guarded();
  EXPECT_EQ(passes(1h), Lines{});

  says("705#R");
  EXPECT_EQ(passes(149ms), Lines{});
  EXPECT_EQ(errors(), Lines{});
  EXPECT_EQ(passes(1ms).size(), 1U);
  EXPECT_EQ(errors(), (Lines{"8130 0"}));
}

TEST_F(NodeGuarding, ReportsASilentMasterOnceAndItsReturn) {
  start_and_lose();
  EXPECT_EQ(passes(1h), Lines{});

  EXPECT_EQ(says("705#R"), (Lines{"705#FF", kErrorReset}));
  EXPECT_EQ(errors(), (Lines{"8130 0 over"}));
  EXPECT_EQ(passes(150ms).size(), 1U) << "watching goes on";
}

TEST_F(NodeGuarding, IsContentWhileRequestsCome) {
  start_guarded();

  for (int i = 0; i < 50; ++i) {
    says("705#R");
    EXPECT_EQ(passes(149ms), Lines{});
  }

  EXPECT_EQ(errors(), Lines{});
}

TEST_F(NodeGuarding, TakesARequestAtTheVeryEndOfTheLifeTime) {
  start_guarded();
  says("705#R");

  now += 150ms;
  says("705#R");

  EXPECT_EQ(errors(), Lines{});
}

TEST_F(NodeGuarding, WatchesNoMasterWhileEitherObjectIsZero) {
  start();
  writes_u16(0x100C, 0, 50);
  EXPECT_EQ(says("705#R"), (Lines{"705#7F"}));
  EXPECT_EQ(passes(1h), Lines{});

  writes_u16(0x100C, 0, 0);
  writes_u8(0x100D, 0, 3);
  EXPECT_EQ(says("705#R"), (Lines{"705#FF"}));
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(NodeGuarding, CountsANewLifeTimeFromItsWrite) {
  start_guarded();
  says("705#R");
  passes(100ms);

  EXPECT_EQ(writes_u8(0x100D, 0, 2), 0U);

  EXPECT_EQ(passes(1h), (Lines{std::string{"200ms "} + kMasterLost}));
}

TEST_F(NodeGuarding, EndsTheErrorWhenItIsSwitchedOff) {
  start_and_lose();

  EXPECT_EQ(says("605#2F0D100000000000"), (Lines{kErrorReset, "585#600D100000000000"}));

  EXPECT_EQ(errors(), (Lines{"8130 0 over"}));
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(NodeGuarding, FollowsTheErrorBehaviour) {
  start_guarded();
  writes_u8(0x1029, 1, 2);
  take_to(NmtState::Operational);
  says("705#R");

  passes(150ms);
  EXPECT_EQ(node->state(), NmtState::Stopped);

  EXPECT_EQ(says("705#R"), (Lines{"705#84"})) << "without EMCY in Stopped";
  EXPECT_EQ(errors(), (Lines{"8130 0", "8130 0 over"}));
}

TEST_F(NodeGuarding, ForgetsASilentMasterWithAReset) {
  start_and_lose();

  EXPECT_EQ(says("000#8205"), (Lines{"705#00"}));

  EXPECT_EQ(errors(), (Lines{"8130 0 over"}));
  EXPECT_EQ(passes(1h), Lines{});
}

using NodeWithoutGuarding = NodeTest;

TEST_F(NodeWithoutGuarding, LeavesRequestsUnanswered) {
  start();

  EXPECT_EQ(says("705#R"), Lines{});
  const auto wanted = node->subscriptions();
  EXPECT_EQ(std::ranges::count(wanted, canopen::Subscription{0x705, true}), 0);
}

// A bus that carries no remote frames.

class GuardingWithoutRemoteFrames : public NodeGuarding {
 protected:
  GuardingWithoutRemoteFrames() : NodeGuarding{Policy{.remote_frames = false, .extended_identifiers = false}} {}
};

TEST_F(GuardingWithoutRemoteFrames, RefusesToSwitchOnLifeGuarding) {
  start();
  told();

  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0U);
  EXPECT_EQ(writes_u8(0x100D, 0, 3), 0x08000022U);
  EXPECT_EQ(told(), (Lines{"life guarding withheld"}));
  EXPECT_EQ(writes_u16(0x100C, 0, 0), 0U);
  EXPECT_EQ(writes_u8(0x100D, 0, 3), 0U);
  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0x08000022U);
}

TEST_F(GuardingWithoutRemoteFrames, LeavesStoredValuesWithoutEffect) {
  store_value(0x100C, 0, 50);
  store_value(0x100D, 0, 3);
  start();

  const Lines lines = told();
  EXPECT_EQ(std::ranges::count(lines, "life guarding withheld"), 1);
  says("705#R");
  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(errors(), Lines{});
}

TEST_F(GuardingWithoutRemoteFrames, LeavesTheHeartbeatAlone) {
  start();

  EXPECT_EQ(writes_u16(0x1017, 0, 1000), 0U);
  EXPECT_EQ(passes(1s).size(), 2U);
}

}  // namespace
