#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::kNoNodeId;
using canopen::NmtCommand;
using canopen::NmtState;

/// Node 5, whose node-ID may be another after a reset, or none.
class NodeId : public NodeTest {
 protected:
  /// Resets the communication from within and returns what the node sent.
  Lines resets(NmtCommand command = NmtCommand::ResetCommunication) {
    node->command(command, now);
    node->on_time(now);
    return sent();
  }
};

TEST_F(NodeId, ChangesWithAResetOfTheCommunicationAndNotBefore) {
  start();
  node->set_node_id(9);

  EXPECT_EQ(node->node_id(), 5);
  EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"}));
  EXPECT_EQ(says("000#8205"), (Lines{"709#00"}));

  EXPECT_EQ(node->node_id(), 9);
  EXPECT_EQ(says("605#4000100000000000"), Lines{});
  EXPECT_EQ(says("609#4000100000000000"), (Lines{"589#4300100092010200"}));
  EXPECT_EQ(says("000#0105"), Lines{});
  EXPECT_EQ(node->state(), NmtState::PreOperational);
}

TEST_F(NodeId, ChangesWithAResetOfTheNodeToo) {
  start();
  node->set_node_id(9);

  EXPECT_EQ(says("000#8105"), (Lines{"709#00"}));
  EXPECT_EQ(says("000#0109"), (Lines{"189#4000"}));
}

TEST_F(NodeId, TakesTheValuesThatAreRelativeToItWithIt) {
  start();
  node->set_node_id(9);
  says("000#8200");

  EXPECT_EQ(value_of(0x1014), 0x89);
  EXPECT_EQ(value_of(0x1200, 1), 0x609);
  EXPECT_EQ(value_of(0x1200, 2), 0x589);
  EXPECT_EQ(value_of(0x1400, 1), 0x209);
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x209, 0x309, 0x409, 0x589, 0x609, 0x709}));
  node->send_emcy(0x1000, 1, {});
  EXPECT_EQ(sent(), (Lines{"089#0010010000000000"}));
}

TEST_F(NodeId, MayBeSaidBeforeTheFirstStart) {
  node->set_node_id(127);

  EXPECT_EQ(start(), (Lines{"77F#00"}));
  EXPECT_EQ(application.told, (Lines{"reset 130", "Initialising -> Pre-operational"}));
}

TEST_F(NodeId, MayBeSaidByTheApplicationDuringTheVeryReset) {
  start();
  application.reaction = [this](const std::string& what) {
    if (what == "Pre-operational -> Initialising") node->set_node_id(7);
  };

  EXPECT_EQ(says("000#8105"), (Lines{"707#00"}));
}

TEST_F(NodeId, IsKeptByAStartThatBringsNoOther) {
  start();
  store_value(0x1017, 0, 20);

  EXPECT_EQ(start(), (Lines{"705#00"}));
  EXPECT_EQ(value_of(0x1017), 20) << "the dictionary keeps its values";
}

/// The node has never had a node-ID.
class NodeWithoutNodeId : public NodeId {
 protected:
  NodeWithoutNodeId() { node->set_node_id(kNoNodeId); }
};

TEST_F(NodeWithoutNodeId, IsSilent) {
  EXPECT_EQ(start(), Lines{});

  EXPECT_EQ(node->state(), NmtState::Unconfigured);
  EXPECT_EQ(node->node_id(), kNoNodeId);
  EXPECT_EQ(application.told, (Lines{"reset 130", "Initialising -> Unconfigured"}));
  EXPECT_TRUE(node->subscriptions().empty());
  node->send_emcy(0x1000, 1, {});
  node->raise_error(0x2310, 0, 2);
  node->report(canopen::CommunicationError::CanOverrun, now);
  EXPECT_EQ(sets(0x6041, 0x1234), Lines{});
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(NodeWithoutNodeId, HearsNothing) {
  start();
  application.told.clear();

  for (const char* const frame : {"000#0100", "000#8100", "605#4000100000000000", "6FF#4000100000000000", "080#",
                                  "205#0F00", "705#R", "7FF#05"})
    EXPECT_EQ(says(frame), Lines{}) << frame;
  EXPECT_EQ(application.told, Lines{});
  EXPECT_TRUE(application.foreign.empty());
}

TEST_F(NodeWithoutNodeId, IsLeftByAResetOnly) {
  start();

  node->set_node_id(5);
  for (const NmtCommand command : {NmtCommand::Start, NmtCommand::Stop, NmtCommand::EnterPreOperational}) {
    node->command(command, now);
    EXPECT_EQ(node->state(), NmtState::Unconfigured);
  }
  node->apply_error_behaviour(1);
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
  application.told.clear();

  EXPECT_EQ(resets(), (Lines{"705#00"}));
  EXPECT_EQ(application.told,
            (Lines{"Unconfigured -> Initialising", "reset 130", "Initialising -> Pre-operational"}));
  EXPECT_EQ(says("000#0105"), (Lines{"185#4000"}));
}

TEST_F(NodeWithoutNodeId, StaysWithoutOneAfterAResetThatBringsNone) {
  start();

  EXPECT_EQ(resets(NmtCommand::ResetNode), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
}

TEST_F(NodeId, MayBeLost) {
  start();
  writes_u16(0x1017, 0, 20);
  says("000#0105");
  ASSERT_EQ(node->state(), NmtState::Operational);
  node->set_node_id(kNoNodeId);

  EXPECT_EQ(says("000#8205"), Lines{});

  EXPECT_EQ(node->state(), NmtState::Unconfigured);
  EXPECT_TRUE(node->subscriptions().empty());
  EXPECT_EQ(passes(1s), Lines{});
  EXPECT_EQ(sets(0x6041, 0x1234), Lines{});
  node->set_node_id(6);
  EXPECT_EQ(resets(), (Lines{"706#00"}));
}

}  // namespace
