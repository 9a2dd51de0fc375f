#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/fixture/sdo_client.hpp"

namespace {

using canopen::AbortCode;
using canopen::Direction;
using canopen::NmtState;

/// What the owner of a node does to its dictionary by itself, and hears of what a master does to it.
class OwnerOfANode : public NodeTest {
 protected:
  explicit OwnerOfANode(const canopen::Policy& policy = {.extended_identifiers = false}) : NodeTest{policy} {
    start_operational();
  }
  /// Writes as a master would, without one; 0 or the abort code.
  std::uint32_t owner_writes(std::uint16_t index, std::uint8_t sub_index, std::int64_t value) {
    const auto written = dictionary.write(*dictionary.find(index, sub_index).value(), value);
    node->on_time(now);
    return written ? 0U : static_cast<std::uint32_t>(written.error());
  }
};

TEST_F(OwnerOfANode, ChangesAPdoThroughTheDictionaryAtOnce) {
  EXPECT_EQ(owner_writes(0x1400, 1, 0x211), 0x08000022U) << "valid under another identifier";
  EXPECT_EQ(owner_writes(0x1400, 1, 0x80000205), 0U);
  EXPECT_EQ(owner_writes(0x1400, 1, 0x185), 0x06040043U) << "that of TPDO 1";
  application.subscription_changes = 0;

  EXPECT_EQ(owner_writes(0x1400, 1, 0x211), 0U);

  EXPECT_EQ(application.subscription_changes, 1);
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x211, 0x305, 0x405, 0x585, 0x605, 0x705}));
  says("211#0F00");
  EXPECT_EQ(value_of(0x6040), 0x0F);
  EXPECT_EQ(value_of(0x1400, 1), 0x211);

  EXPECT_EQ(owner_writes(0x1800, 1, 0xC0000185), 0U);
  EXPECT_EQ(owner_writes(0x1800, 1, 0x40000191), 0U);
  EXPECT_EQ(sent(), (Lines{"191#4000"}));
}

TEST_F(OwnerOfANode, IsNotToldOfItsOwnRefusedWrites) {
  EXPECT_EQ(owner_writes(0x1400, 1, 0x211), 0x08000022U);
  EXPECT_EQ(application.refused, Lines{});
}

TEST_F(OwnerOfANode, HearsOfWritesThatServicesRefuse) {
  EXPECT_EQ(writes_u32(0x1400, 1, 0x211), 0x08000022U);
  EXPECT_EQ(writes_u8(0x1400, 2, 250), 0x06090030U);
  EXPECT_EQ(application.refused, (Lines{"1400:01 = 211: 08000022", "1400:02 = FA: 06090030"}));
}

TEST_F(OwnerOfANode, HearsOfThemHoweverTheyCome) {
  SdoClient client{*node, bus};
  const SdoClient::Outcome refused = AbortCode::DeviceState;
  EXPECT_EQ(client.download({0x1400, 1}, {0x11, 0x02, 0, 0}), refused);
  EXPECT_EQ(client.block_download({0x1400, 1}, {0x11, 0x02, 0, 0}), refused);
  EXPECT_EQ(application.refused, (Lines{"1400:01 = 211: 08000022", "1400:01 = 211: 08000022"}));
}

TEST_F(OwnerOfANode, HearsNothingOfWritesThatNobodyElseRefuses) {
  EXPECT_EQ(writes_u8(0x1400, 1, 1), 0x06070010U);
  EXPECT_EQ(writes_u32(0x1018, 1, 1), 0x06010002U);
  EXPECT_EQ(writes_u8(0x1600, 0, 5), 0x06090031U);
  EXPECT_EQ(writes_u32(0x1404, 1, 1), 0x06020000U);
  EXPECT_EQ(writes_u32(0x1400, 9, 1), 0x06090011U);
  EXPECT_EQ(writes_u32(0x1400, 1, 0x205), 0U);
  EXPECT_EQ(application.refused, Lines{});
}

TEST_F(OwnerOfANode, HearsOfEveryEntryThatAClientHasWritten) {
  SdoClient client{*node, bus};
  writes_u16(0x2014, 0, 7);           // a plain number
  writes_u32(0x1400, 1, 0x80000205);  // that of a service
  writes_u8(0x2001, 0, 20);           // with limits
  client.download({0x2023, 0}, {'n', 'e', 'w'});
  client.download({0x201E, 0}, {1, 2, 3, 4, 5, 6, 7, 8});
  client.block_download({0x2023, 0}, {'n', 'e', 'w', 'e', 'r'});
  EXPECT_EQ(application.written, (Lines{"2014:00", "1400:01", "2001:00", "2023:00", "201E:00", "2023:00"}));
}

TEST_F(OwnerOfANode, HearsOfItWhenTheValueIsThereAndBeforeTheAnswer) {
  application.reaction = [this](const std::string& what) {
    if (what != "2014:00") return;
    EXPECT_EQ(value_of(0x2014), 7);
    EXPECT_TRUE(bus.sent.empty());
    store_value(0x2014, 0, 8);
  };
  EXPECT_EQ(writes_u16(0x2014, 0, 7), 0U);
  EXPECT_EQ(value_of(0x2014), 8);
}

TEST_F(OwnerOfANode, HearsOfNoWriteThatIsRefusedOrItsOwn) {
  SdoClient client{*node, bus};
  writes_u32(0x1400, 1, 0x211);
  writes_u32(0x1018, 1, 1);
  writes_u8(0x1600, 0, 5);
  writes_u8(0x2014, 0, 5);
  client.block_download({0x1400, 1}, {0x11, 0x02, 0, 0});
  client.download({0x2023, 0}, SdoClient::Bytes(21));
  owner_writes(0x2014, 0, 1);
  says("205#0F00");
  EXPECT_EQ(application.written, Lines{});
}

TEST_F(OwnerOfANode, CountsThePdosWhoseCobIdIsValid) {
  EXPECT_EQ(node->valid_pdos(Direction::Receive), 3U);
  EXPECT_EQ(node->valid_pdos(Direction::Transmit), 3U);
  writes_u32(0x1402, 1, 0x80000405);
  EXPECT_EQ(node->valid_pdos(Direction::Receive), 2U);
  EXPECT_EQ(node->valid_pdos(Direction::Transmit), 3U);

  ASSERT_EQ(node->receive_pdos().size(), 4U);
  EXPECT_EQ(node->receive_pdos()[1].identifier, 0x305U);
  EXPECT_EQ(node->receive_pdos()[2].identifier, 0U);
  ASSERT_EQ(node->transmit_pdos().size(), 4U);
  EXPECT_EQ(node->transmit_pdos()[2].number, 2);
  EXPECT_EQ(node->transmit_pdos()[2].identifier, 0x385U);
}

TEST_F(OwnerOfANode, ChoosesTheStateAfterTheNextBootUp) {
  for (const NmtState state : {NmtState::Operational, NmtState::Stopped, NmtState::PreOperational}) {
    node->set_start_state(state);
    says("000#8205");
    EXPECT_EQ(node->state(), state);
    node->start(now);
    EXPECT_EQ(node->state(), state);
  }
}

TEST_F(OwnerOfANode, MayChooseItWhileTheNodeIsReset) {
  application.reaction = [this](const std::string& what) {
    if (what == "reset 129") node->set_start_state(NmtState::Operational);
  };
  EXPECT_EQ(says("000#8105"), (Lines{"705#00", "185#4000"}));
  EXPECT_EQ(node->state(), NmtState::Operational);
}

class OwnerOfALockedNode : public OwnerOfANode {
 protected:
  OwnerOfALockedNode() : OwnerOfANode{{.extended_identifiers = false, .pdo_changes_in_operational = false}} {}
};

TEST_F(OwnerOfALockedNode, IsRefusedWhatAMasterIsRefused) {
  EXPECT_EQ(owner_writes(0x1400, 1, 0x80000205), 0x08000022U);
  EXPECT_EQ(value_of(0x1400, 1), 0x205);
  says("000#8005");
  EXPECT_EQ(owner_writes(0x1400, 1, 0x80000205), 0U);
  EXPECT_EQ(owner_writes(0x1400, 1, 0x211), 0U);
  says("000#0105");
  says("211#0F00");
  EXPECT_EQ(value_of(0x6040), 0x0F);
}

}  // namespace
