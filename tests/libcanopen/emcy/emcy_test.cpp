#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

class EmcyProducer : public NodeTest {
 protected:
  Lines raises() {
    node->send_emcy(0x8130, 0x11, {1, 2, 3, 4, 5});
    return sent();
  }
  const Lines kEmcy{"085#3081110102030405"};
};

TEST_F(EmcyProducer, SendsInPreOperationalAndOperationalOnly) {
  EXPECT_EQ(raises(), Lines{}) << "before start()";
  start();
  EXPECT_EQ(raises(), kEmcy);
  says("000#0105");
  EXPECT_EQ(raises(), kEmcy);
  says("000#0205");
  EXPECT_EQ(raises(), Lines{});
  says("000#8005");
  EXPECT_EQ(raises(), kEmcy);
}

TEST_F(EmcyProducer, MustNotBeReplacedByALaterOne) {
  start();

  node->send_emcy(0, 0, {});

  ASSERT_EQ(bus.deliveries.size(), 1U);
  EXPECT_EQ(bus.deliveries.front(), canopen::Delivery::Ordered);
}

TEST_F(EmcyProducer, IsSilencedByBit31OfItsCobId) {
  start();

  EXPECT_EQ(writes_u32(0x1014, 0, 0x80000085), 0U);
  EXPECT_EQ(raises(), Lines{});
  EXPECT_EQ(writes_u32(0x1014, 0, 0x00000095), 0U);
  EXPECT_EQ(raises(), (Lines{"095#3081110102030405"}));
}

TEST_F(EmcyProducer, JudgesItsCobId) {
  struct Row {
    std::uint32_t cob_id, abort;
  };
  const Row while_valid[] = {
      {0x00000085, 0},           // as it is
      {0x00000086, 0x08000022},  // only through an invalid one
      {0x00000000, 0x06090030}, {0x00000605, 0x06090030}, {0x00000101, 0x06090030}, {0x20000085, 0x06090030},
      {0x40000085, 0x06090030}, {0x00000885, 0x06090030}, {0xFFFFFFFF, 0},  // invalid, whatever else is set
  };
  const Row while_invalid[] = {
      {0x00000701, 0x06090030}, {0x00000080, 0x06040043},  // SYNC
      {0x00000205, 0x06040043},                            // RPDO 1
      {0x00000185, 0x06040043},                            // TPDO 1
      {0x00000123, 0x06090030}, {0x000006DF, 0},
  };
  start();

  for (const Row& row : while_valid)
    EXPECT_EQ(writes_u32(0x1014, 0, row.cob_id), row.abort) << std::hex << row.cob_id;
  for (const Row& row : while_invalid) {
    EXPECT_EQ(writes_u32(0x1014, 0, row.cob_id), row.abort) << std::hex << row.cob_id;
  }
}

TEST_F(EmcyProducer, ReturnsToItsInitialCobIdAfterResetCommunication) {
  start();
  writes_u32(0x1014, 0, 0x80000000);

  says("000#8205");

  EXPECT_EQ(raises(), kEmcy);
}

}  // namespace
