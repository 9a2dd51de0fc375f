#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::NmtState;

/// Node::reload(): error control, EMCY and the errors that there are.
class ServiceReload : public ServiceTest {
 protected:
  ServiceReload() { start(); }
  Lines reloads() {
    node->reload(now);
    node->on_time(now);
    return sent();
  }
  static constexpr std::uint32_t kNode7 = 7 << 16 | 100;  ///< watched for 100 ms
};

TEST_F(ServiceReload, DoesNotDisturbAHeartbeatWhoseTimeStays) {
  writes_u16(0x1017, 0, 100);
  EXPECT_EQ(passes(60ms), (Lines{"0ms 705#7F"}));
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(passes(50ms), (Lines{"100ms 705#7F"}));
}

TEST_F(ServiceReload, BeginsAnotherHeartbeatAtOnce) {
  store_value(0x1017, 0, 100);
  EXPECT_EQ(reloads(), (Lines{"705#7F"}));
  EXPECT_EQ(passes(100ms), (Lines{"100ms 705#7F"}));
  store_value(0x1017, 0, 0);
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(passes(1s), Lines{});
}

TEST_F(ServiceReload, KeepsTheToggleBitAndTheLifeTimeThatRuns) {
  writes_u16(0x100C, 0, 100);
  writes_u8(0x100D, 0, 2);
  EXPECT_EQ(says("705#R"), (Lines{"705#7F"}));
  passes(150ms);
  reloads();
  EXPECT_EQ(says("705#R"), (Lines{"705#FF"}));

  store_value(0x100D, 0, 3);
  passes(100ms);
  reloads();
  passes(299ms);
  EXPECT_EQ(errors(), Lines{});
  passes(1ms);
  EXPECT_EQ(errors(), (Lines{"8130 0"}));

  store_value(0x100D, 0, 0);
  reloads();
  EXPECT_EQ(errors(), (Lines{"8130 0 over"}));
}

TEST_F(ServiceReload, WatchesOnWhatItHasWatched) {
  writes_u32(0x1016, 1, kNode7);
  says("707#05");
  passes(60ms);
  reloads();
  passes(60ms);
  EXPECT_EQ(errors(), (Lines{"8130 7"}));
  reloads();
  EXPECT_EQ(errors(), Lines{}) << "still silent";

  store_value(0x1016, 1, 0);
  reloads();
  EXPECT_EQ(errors(), (Lines{"8130 7 over"}));
}

TEST_F(ServiceReload, WatchesWhatIsNew) {
  store_value(0x1016, 2, kNode7);
  store_value(0x1016, 3, kNode7);  // twice: not used
  reloads();
  application.told.clear();
  says("707#05");
  EXPECT_EQ(told(), (Lines{"node 7: Operational"}));
  passes(100ms);
  EXPECT_EQ(errors(), (Lines{"8130 7"}));
}

TEST_F(ServiceReload, SendsEmergenciesThatWaitUnderTheNewIdentifier) {
  writes_u16(0x1015, 0, 100);  // 10 ms
  node->send_emcy(0x1000, 1, {});
  node->send_emcy(0x2000, 1, {});
  sent();
  store_value(0x1014, 0, 0x91);
  store_value(0x1015, 0, 50);
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(passes(20ms), (Lines{"5ms 091#0020010000000000"}));

  node->send_emcy(0x1000, 1, {});
  node->send_emcy(0x2000, 1, {});
  sent();
  store_value(0x1014, 0, 0x80000091);
  reloads();
  EXPECT_EQ(passes(20ms), Lines{}) << "without an identifier nothing waits";
}

TEST_F(ServiceReload, ShowsTheErrorsThatThereAreInTheRestoredRegister) {
  node->raise_error(0x4210, 0, 0x08);
  sent();
  dictionary.restore(0x1000, 0x1FFF);
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(value_of(0x1001), 0x09);
  node->clear_error(0x4210, 0);
  EXPECT_EQ(sent(), (Lines{"085#0000000000000000"}));
}

TEST_F(ServiceReload, TakesOverTheTimeIdentifier) {
  store_value(0x1012, 0, 0x80000101 & ~1U);
  reloads();
  says("100#000000000100");
  EXPECT_EQ(told().back(), "day 1, 0 ms");
}

TEST_F(ServiceReload, FollowsAnApplicationThatLeavesOperationalMeanwhile) {
  writes_u32(0x1016, 1, kNode7);
  writes_u8(0x1029, 1, 1);  // stays in its state
  ASSERT_EQ(writes_u32(0x1800, 1, 0x40000185), 0U);
  take_to(NmtState::Operational);
  says("707#05");
  passes(100ms);
  application.reaction = [this](const std::string& what) {
    if (what == "8130 7 over") node->apply_error_behaviour(2);
  };
  store_value(0x1016, 1, 0);
  sent();

  EXPECT_EQ(reloads(), (Lines{"085#0000000000000000"})) << "and no TPDO";
  EXPECT_EQ(node->state(), NmtState::PreOperational);
}

}  // namespace
