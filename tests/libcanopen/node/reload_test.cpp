#include "tests/libcanopen/fixture/pdo_table.hpp"
#include "tests/libcanopen/fixture/sdo_servers_fixture.hpp"

namespace {

using canopen::NmtState;

/// Node::reload(): the PDOs.
class NodeReload : public PdoTest {
 protected:
  Lines reloads() {
    node->reload(now);
    node->on_time(now);
    return sent();
  }
};

TEST_F(NodeReload, TakesOverTheValuesOfTheDictionaryInTheStateThatThereIs) {
  start_operational();
  store_value(0x1400, 1, 0x211);
  store_value(0x1800, 1, 0x40000191);
  store_value(0x1005, 0, 0x81);

  EXPECT_EQ(reloads(), (Lines{"191#4000"})) << "no boot-up message";

  EXPECT_EQ(application.told, Lines{});
  EXPECT_EQ(node->state(), NmtState::Operational);
  says("211#0F00");
  EXPECT_EQ(value_of(0x6040), 0x0F);
  says("205#0700");
  EXPECT_EQ(value_of(0x6040), 0x0F) << "nobody listens to the old identifier";
  EXPECT_EQ(says("081#").size(), 2U);
  EXPECT_EQ(says("080#"), Lines{});
  const auto wanted = subscriptions();
  EXPECT_EQ(std::ranges::count(wanted, 0x211U), 1);
  EXPECT_EQ(std::ranges::count(wanted, 0x205U), 0);
}

TEST_F(NodeReload, BringsTheInitialValuesIntoForce) {
  start_operational();
  ASSERT_EQ(writes_u32(0x1400, 1, 0x80000205), 0U);
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);

  dictionary.restore(0x1000, 0x1FFF);

  EXPECT_EQ(reloads(), (Lines{"185#4000"}));
  says("205#0F00");
  EXPECT_EQ(value_of(0x6040), 0x0F);
}

TEST_F(NodeReload, LeavesThePdosAloneOutsideOperational) {
  start();
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(node->state(), NmtState::PreOperational);
  EXPECT_EQ(node->valid_pdos(canopen::Direction::Receive), 3U);
  EXPECT_EQ(says("000#0105"), (Lines{"185#4000"}));
}

TEST_F(NodeReload, DoesNothingBeforeTheNodeHasBooted) {
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
  EXPECT_EQ(application.subscription_changes, 0);
  EXPECT_EQ(start(), (Lines{"705#00"}));
}

TEST_F(NodeReload, ShowsPdosThatCannotBeAsInvalid) {
  start_operational();
  store_value(0x1402, 1, 0x205);  // as RPDO 1
  store_value(0x1A00, 1, 0x77770010);
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(value_of(0x1402, 1), 0x80000205);
  EXPECT_EQ(value_of(0x1800, 1), 0xC0000185);
}

TEST_F(NodeReload, BeginsTheCyclesOfSynchronousPdosAnew) {
  start();
  ASSERT_EQ(writes_u8(0x1801, 2, 2), 0U);
  operate();
  says("080#");
  says("405#0F0001000000");
  EXPECT_EQ(reloads(), (Lines{"185#4000"}));

  EXPECT_EQ(says("080#"), (Lines{"385#00000000"})) << "the second SYNC of TPDO 2, and the first of its cycle";
  EXPECT_EQ(value_of(0x60FF), 0) << "RPDO 3 does not wait any more";
  EXPECT_EQ(says("080#"), (Lines{"285#400000000000"}));
}

TEST_F(NodeReload, KeepsInhibitTimesThatRun) {
  start();
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);
  ASSERT_EQ(writes_u16(0x1800, 3, 100), 0U);  // 10 ms
  ASSERT_EQ(writes_u32(0x1800, 1, 0x40000185), 0U);
  operate();
  passes(4ms);
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(passes(10ms), (Lines{"10ms 185#4000"}));

  says("080#");  // TPDO 2 has gone with it
  store_value(0x1801, 2, 255);
  store_value(0x1801, 3, 50);
  EXPECT_EQ(passes(2ms), Lines{});
  EXPECT_EQ(reloads(), Lines{});
  EXPECT_EQ(passes(10ms), (Lines{"19ms 285#400000000000", "20ms 185#4000"}));
}

/// Node::reload(): SDO servers.
class SdoReload : public SdoServers {};

TEST_F(SdoReload, LeavesTransfersToServersThatKeepTheirIdentifiers) {
  says("605#2100200004000000");
  says("680#2100200004000000");
  store_ids(0x127F, 0x680, 0x682);
  node->reload(now);

  EXPECT_EQ(says("605#0778563412000000"), (Lines{"585#2000000000000000"}));
  EXPECT_EQ(value_of(0x2000), 0x12345678);
  EXPECT_EQ(says("680#0778563412000000"), (Lines{"682#8000000001000405"}));
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(SdoReload, MovesIdentifiersFromServerToServer) {
  store_ids(0x1201, 0x680, 0x681);
  store_ids(0x127F, 0x690, 0x691);
  node->reload(now);
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));
  says("680#2100200004000000");

  store_ids(0x1202, 0x690, 0x691);  // now before that of 127Fh
  node->reload(now);
  EXPECT_EQ(value_of(0x127F, 1), 0x80000690);
  EXPECT_EQ(says("680#0778563412000000"), (Lines{"681#2000000000000000"}));
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));

  store_ids(0x1202, 0x80000000, 0x80000000);
  node->reload(now);
  EXPECT_EQ(says("690#4000100000000000"), Lines{});
}

}  // namespace
