#include "tests/libcanopen/fixture/lss_fixture.hpp"

namespace {

using canopen::kNoNodeId;
using canopen::LssState;
using canopen::NmtState;

/// A node that has no node-ID at power-on.
class LssUnconfigured : public LssTest {
 protected:
  LssUnconfigured() { node->set_node_id(kNoNodeId); }
  void SetUp() override {
    EXPECT_EQ(start(), Lines{}) << "no boot-up message";
    ASSERT_EQ(node->state(), NmtState::Unconfigured);
  }
};

TEST_F(LssUnconfigured, HearsNothingButLss) {
  application.told.clear();
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0x7E5}));
  for (const char* const state : {"0400", "0401"}) {
    asks(state);
    for (const char* const frame : {"000#0100",
                                    "000#0200",
                                    "000#8000",
                                    "000#8100",
                                    "000#8200",
                                    "000#01FF",
                                    "000#82FF",
                                    "605#4000100000000000",
                                    "600#4000100000000000",
                                    "6FF#4000100000000000",
                                    "080#",
                                    "080#01",
                                    "100#000000000000",
                                    "205#0F00",
                                    "2FF#0F00",
                                    "705#R",
                                    "7FF#R",
                                    "705#05",
                                    "7FF#05",
                                    "185#R",
                                    "585#4300100092010200"})
      EXPECT_EQ(says(frame), Lines{}) << frame;
  }
  EXPECT_EQ(application.told, Lines{});
  EXPECT_EQ(application.errors, Lines{});
  EXPECT_TRUE(application.foreign.empty());
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(LssUnconfigured, SendsNothingByItself) {
  store_value(0x1017, 0, 10);
  node->reload(now);
  node->send_emcy(0x1000, 1, {});
  node->raise_error(0x2310, 0, 2);
  node->report(canopen::CommunicationError::BusOffRecovered, now);
  EXPECT_EQ(sets(0x6041, 0x1234), Lines{});
  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(LssUnconfigured, SaysThatItHasNoNodeId) {
  EXPECT_EQ(asks("4C"), answer("50"));
  asks("0401");
  EXPECT_EQ(asks("4C"), answer("50")) << "in both states";
  EXPECT_EQ(asks("5E"), answer("5EFF"));
}

TEST_F(LssUnconfigured, IsSelectedByItsIdentityLikeAnyOther) {
  select();
  EXPECT_EQ(asks("5D"), answer("5D78563412"));
}

TEST_F(LssUnconfigured, BootsWhenItGoesBackToWaitingWithANodeId) {
  select();
  EXPECT_EQ(asks("1107"), answer("11"));
  EXPECT_EQ(asks("5E"), answer("5EFF")) << "not in force yet";
  EXPECT_EQ(asks("4C"), Lines{}) << "but nobody looks for it any longer";
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
  application.told.clear();

  EXPECT_EQ(asks("0400"), (Lines{"707#00"}));
  EXPECT_EQ(application.told,
            (Lines{"Unconfigured -> Initialising", "reset 130", "Initialising -> Pre-operational"}));
  EXPECT_EQ(says("607#4000100000000000"), (Lines{"587#4300100092010200"}));
  EXPECT_EQ(says("000#0107"), (Lines{"187#4000"}));
  EXPECT_EQ(asks("4C"), Lines{});
  EXPECT_FALSE(is_selected());
}

TEST_F(LssUnconfigured, StaysWithoutANodeIdIfItGetsNone) {
  select();
  asks("1107");
  asks("11FF");
  EXPECT_EQ(asks("0400"), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);

  asks("0401");
  EXPECT_EQ(asks("1100"), answer("1101"));
  EXPECT_EQ(asks("1180"), answer("1101"));
  EXPECT_EQ(asks("0400"), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(LssUnconfigured, DoesNotBootOnAModeThatDoesNotExist) {
  select();
  asks("1107");
  EXPECT_EQ(asks("0402"), Lines{});
  EXPECT_EQ(asks("0401"), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(LssUnconfigured, DoesNotBootWhenItHasBeenWaitingAllTheTime) {
  node->set_node_id(7);
  EXPECT_EQ(asks("0400"), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(LssUnconfigured, MayBeConfiguredAgainAndAgain) {
  for (const char* const id : {"01", "7F", "10"}) {
    select();
    EXPECT_EQ(asks(std::string{"11"} + id), answer("11"));
    EXPECT_EQ(asks("0400"), (Lines{(id == std::string{"7F"} ? "77F#00" : std::string{"7"} + id + "#00")}));
    select();
    EXPECT_EQ(asks("11FF"), answer("11"));
    EXPECT_EQ(asks("0400"), Lines{});
    EXPECT_EQ(says("000#8200"), Lines{});
    EXPECT_EQ(node->state(), NmtState::Unconfigured);
  }
}

TEST_F(LssUnconfigured, EntersTheStateThatAStartLeadsTo) {
  node->set_start_state(NmtState::Operational);
  select();
  asks("1107");
  EXPECT_EQ(asks("0400"), (Lines{"707#00", "187#4000"}));
}

TEST_F(LssUnconfigured, WaitsAfterAStart) {
  select();
  EXPECT_EQ(start(), Lines{});
  EXPECT_EQ(lss.state(), LssState::Waiting);
  EXPECT_EQ(asks("4C"), answer("50"));
}

using LssConfigured = LssTest;

TEST_F(LssConfigured, LosesItsHeartbeatWithItsNodeId) {
  start();
  ASSERT_EQ(writes_u16(0x1017, 0, 20), 0U);
  passes(0ms);
  select();
  asks("11FF");
  says("000#8205");
  EXPECT_EQ(passes(1s), Lines{});
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0x7E5}));
  EXPECT_EQ(says("000#8105"), Lines{});
  EXPECT_EQ(asks("4C"), answer("50"));
}

}  // namespace
