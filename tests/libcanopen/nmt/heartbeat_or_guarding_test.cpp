#include "tests/libcanopen/fixture/guarding_fixture.hpp"

namespace {

using namespace guarding_test;

using HeartbeatThatWins = NodeGuarding;

TEST_F(HeartbeatThatWins, SilencesGuarding) {
  start_guarded();
  says("705#R");

  EXPECT_EQ(writes_u16(0x1017, 0, 1000), 0U);

  EXPECT_EQ(says("705#R"), (Lines{"705#7F"})) << "the first heartbeat, and no answer";
  EXPECT_EQ(says("705#R"), Lines{});
  EXPECT_EQ(passes(1s), (Lines{"1000ms 705#7F"})) << "no life time runs";
}

TEST_F(HeartbeatThatWins, GivesWayWhenItIsSwitchedOff) {
  start_guarded();
  says("705#R");
  writes_u16(0x1017, 0, 1000);
  node->on_time(now);
  sent();

  EXPECT_EQ(writes_u16(0x1017, 0, 0), 0U);
  EXPECT_EQ(passes(1h), Lines{}) << "watching begins with a request";

  EXPECT_EQ(says("705#R"), (Lines{"705#7F"}));
  EXPECT_EQ(says("705#R"), (Lines{"705#FF"}));
  EXPECT_EQ(passes(150ms).size(), 1U);
}

TEST_F(HeartbeatThatWins, LetsTheToggleBitAloneWhileItStaysOff) {
  start();
  says("705#R");

  EXPECT_EQ(writes_u16(0x1017, 0, 0), 0U);

  EXPECT_EQ(says("705#R"), (Lines{"705#FF"}));
}

TEST_F(HeartbeatThatWins, EndsTheErrorOfASilentMaster) {
  start_and_lose();

  writes_u16(0x1017, 0, 1000);

  EXPECT_EQ(errors(), (Lines{"8130 0 over"}));
}

TEST_F(HeartbeatThatWins, LetsGuardingBeConfiguredMeanwhile) {
  start();
  writes_u16(0x1017, 0, 1000);

  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0U);
  EXPECT_EQ(writes_u8(0x100D, 0, 3), 0U);
}

class HeartbeatOrGuarding : public NodeGuarding {
 protected:
  HeartbeatOrGuarding()
      : NodeGuarding{Policy{.error_control_conflict = canopen::ErrorControlConflict::Refuse,
                            .extended_identifiers = false}} {}
};

TEST_F(HeartbeatOrGuarding, RefusesTheHeartbeatWhileLifeGuardingIsOn) {
  start_guarded();
  says("705#R");

  EXPECT_EQ(writes_u16(0x1017, 0, 1000), 0x06090030U);
  EXPECT_EQ(writes_u16(0x1017, 0, 0), 0U);

  EXPECT_EQ(says("705#R"), (Lines{"705#FF"}));
  EXPECT_EQ(passes(1h), (Lines{std::string{"150ms "} + kMasterLost})) << "and no heartbeat";
}

TEST_F(HeartbeatOrGuarding, RefusesLifeGuardingWhileTheHeartbeatIsOn) {
  start();
  EXPECT_EQ(writes_u16(0x1017, 0, 1000), 0U);

  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0U) << "one of them alone switches nothing on";
  EXPECT_EQ(writes_u8(0x100D, 0, 3), 0x06090030U);
  EXPECT_EQ(value_of(0x100D), 0);
  EXPECT_EQ(writes_u16(0x100C, 0, 0), 0U);
  EXPECT_EQ(writes_u8(0x100D, 0, 3), 0U);
  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0x06090030U);
}

TEST_F(HeartbeatOrGuarding, LetsTheOtherOneBeginWhenOneIsSwitchedOff) {
  start_guarded();

  writes_u16(0x100C, 0, 0);
  EXPECT_EQ(writes_u16(0x1017, 0, 1000), 0U);
  EXPECT_EQ(writes_u16(0x1017, 0, 0), 0U);
  EXPECT_EQ(writes_u16(0x100C, 0, 50), 0U);
}

TEST_F(HeartbeatOrGuarding, PrefersTheHeartbeatIfBothWereStored) {
  store_value(0x1017, 0, 1000);
  store_value(0x100C, 0, 50);
  store_value(0x100D, 0, 3);
  start();

  EXPECT_EQ(says("705#R"), Lines{});
  EXPECT_EQ(passes(1s), (Lines{"1000ms 705#7F"}));
}

}  // namespace
