#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

class SdoServer : public NodeTest {
 protected:
  void SetUp() override { start(); }
};

TEST_F(SdoServer, UploadsNumbersOfUpToFourBytesInOneFrame) {
  store_value(0x2010, 0, 1);
  store_value(0x2011, 0, -2);
  store_value(0x2013, 0, -3);
  store_value(0x2015, 0, -4);
  store_value(0x2016, 0, 0xABCDEF);
  store_value(0x2018, 0, 0x89ABCDEF);
  store_value(0x2019, 0, 0x3F800000);
  expect_dialogue({
      {"605#4000100000000000", "585#4300100092010200"},  // UNSIGNED32
      {"605#4018100000000000", "585#4F18100004000000"},  // UNSIGNED8
      {"605#4021200000000000", "585#4B21200034120000"},  // UNSIGNED16
      {"605#4010200000000000", "585#4F10200001000000"},  // BOOLEAN
      {"605#4011200000000000", "585#4F112000FE000000"},  // INTEGER8: no sign in the unused bytes
      {"605#4013200000000000", "585#4B132000FDFF0000"},  // INTEGER16
      {"605#4015200000000000", "585#47152000FCFFFF00"},  // INTEGER24
      {"605#4016200000000000", "585#47162000EFCDAB00"},  // UNSIGNED24
      {"605#4018200000000000", "585#43182000EFCDAB89"},  // UNSIGNED32
      {"605#4019200000000000", "585#431920000000803F"},  // REAL32
      {"605#4025200200000000", "585#4B25200202000000"},  // beside a gap
  });
}

TEST_F(SdoServer, DownloadsNumbersOfUpToFourBytesInOneFrame) {
  expect_dialogue({
      {"605#2F10200001000000", "585#6010200000000000"},
      {"605#2F112000FE000000", "585#6011200000000000"},
      {"605#2B132000FDFF0000", "585#6013200000000000"},
      {"605#27152000FCFFFF00", "585#6015200000000000"},
      {"605#23182000EFCDAB89", "585#6018200000000000"},
      {"605#231920000000803F", "585#6019200000000000"},
      {"605#2B20200001000000", "585#6020200000000000"},  // wo
  });
  EXPECT_EQ(value_of(0x2010), 1);
  EXPECT_EQ(value_of(0x2011), -2);
  EXPECT_EQ(value_of(0x2013), -3);
  EXPECT_EQ(value_of(0x2015), -4);
  EXPECT_EQ(value_of(0x2018), 0x89ABCDEF);
  EXPECT_EQ(value_of(0x2019), 0x3F800000);
  EXPECT_EQ(value_of(0x2020), 1);
}

TEST_F(SdoServer, TakesTheSizeOfTheObjectWhenNoneIsIndicated) {
  expect_dialogue({
      {"605#22112000FEFFFFFF", "585#6011200000000000"},
      {"605#2213200034127777", "585#6013200000000000"},
      {"605#2216200056341277", "585#6016200000000000"},
      {"605#2218200078563412", "585#6018200000000000"},
      {"605#2E18200078563412", "585#6018200000000000"},  // the size bits have no meaning then
  });
  EXPECT_EQ(value_of(0x2011), -2);
  EXPECT_EQ(value_of(0x2013), 0x1234);
  EXPECT_EQ(value_of(0x2016), 0x123456);
  EXPECT_EQ(value_of(0x2018), 0x12345678);
}

TEST_F(SdoServer, RefusesWhatIsNotThere) {
  expect_dialogue({
      {"605#4001100000000000", "585#8001100000000206"},
      {"605#40FFFFFF00000000", "585#80FFFFFF00000206"},
      {"605#4000100100000000", "585#8000100111000906"},
      {"605#4018100500000000", "585#8018100511000906"},
      {"605#4025200100000000", "585#8025200111000906"},
      {"605#2F01100000000000", "585#8001100000000206"},
      {"605#2F00100100000000", "585#8000100111000906"},
      {"605#2101100004000000", "585#8001100000000206"},
  });
}

TEST_F(SdoServer, RefusesWhatTheAccessForbids) {
  expect_dialogue({
      {"605#4020200000000000", "585#8020200001000106"},  // reading wo
      {"605#2B21200000000000", "585#8021200002000106"},  // writing ro
      {"605#2322200000000000", "585#8022200002000106"},  // writing const
      {"605#2F08100041000000", "585#8008100002000106"},  // writing const text
      {"605#2108100003000000", "585#8008100002000106"},
      {"605#2F21200000000000", "585#8021200002000106"},  // before the length is looked at
  });
}

TEST_F(SdoServer, RefusesEveryWrongLengthOfEveryNumericType) {
  for (std::uint16_t index = 0x2010; index < 0x2020; ++index) {
    const unsigned expected = (*dictionary.find(index, 0))->size;
    for (unsigned size = 1; size <= 4; ++size) {
      EXPECT_EQ(writes(index, 0, 0, size), size == expected ? 0U : 0x06070010U)
          << std::hex << index << ' ' << size;
    }
  }
}

TEST_F(SdoServer, RefusesValuesOutsideTheLimits) {
  struct Row {
    std::uint16_t index;
    std::uint32_t value;
    unsigned size;
    std::uint32_t abort;
  };
  const Row rows[] = {
      {0x2000, 0xF6, 1, 0},
      {0x2000, 0xF5, 1, 0x06090032},
      {0x2000, 11, 1, 0x06090031},
      {0x2001, 200, 1, 0},
      {0x2001, 201, 1, 0x06090031},
      {0x2001, 4, 1, 0x06090032},
      {0x2002, 0xFC18, 2, 0},
      {0x2002, 0xFC17, 2, 0x06090032},
      {0x2002, 1001, 2, 0x06090031},
      {0x2003, 0xFFF0, 2, 0},
      {0x2003, 0xFFF1, 2, 0x06090031},
      {0x2003, 0, 2, 0x06090032},
      {0x2004, 0xFEEE90, 3, 0},
      {0x2004, 0xFEEE8F, 3, 0x06090032},
      {0x2004, 70001, 3, 0x06090031},
      {0x2005, 0xFFFFFFF0, 4, 0},
      {0x2005, 0xFFFFFFF1, 4, 0x06090031},
      {0x2005, 0, 4, 0x06090032},
      {0x2008, 0xBF000000, 4, 0},           // -0.5
      {0x2008, 0xBFC00000, 4, 0x06090032},  // -1.5
      {0x2008, 0x3FC00000, 4, 0x06090031},  // 1.5
  };
  for (const Row& row : rows) {
    EXPECT_EQ(writes(row.index, 0, row.value, row.size), row.abort) << std::hex << row.index << ' ' << row.value;
  }
}

TEST_F(SdoServer, RefusesUnknownCommands) {
  expect_dialogue({
      {"605#E000100000000000", "585#8000100001000405"},
      {"605#FF00100000000000", "585#8000100001000405"},
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#E000100000000000", "585#8008100001000405"},  // that of the transfer, which is gone
      {"605#6000000000000000", "585#8000000001000405"},
  });
}

class SdoServerWithoutBlock : public NodeTest {
 protected:
  SdoServerWithoutBlock() : NodeTest{{.extended_identifiers = false, .sdo_block = false}} {}
  void SetUp() override { start(); }
};

TEST_F(SdoServerWithoutBlock, RefusesBlockTransfer) {
  expect_dialogue({
      {"605#A400100000000000", "585#8000100001000405"},  // block upload
      {"605#A000100000000000", "585#8000100001000405"},
      {"605#C600200001000000", "585#8000200001000405"},  // block download
      {"605#C400200001000000", "585#8000200001000405"},
      {"605#A300000000000000", "585#8000000001000405"},
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#A400100000000000", "585#8008100001000405"},
      {"605#6000000000000000", "585#8000000001000405"},
  });
}

TEST_F(SdoServer, RefusesSegmentsWithoutATransfer) {
  expect_dialogue({
      {"605#6000000000000000", "585#8000000001000405"},
      {"605#7000000000000000", "585#8000000001000405"},
      {"605#0000000000000000", "585#8000000001000405"},
      {"605#0141424300000000", "585#8000000001000405"},
  });
}

TEST_F(SdoServer, IsSilentToAbortsAndToFramesThatAreNoRequest) {
  expect_dialogue({
      {"605#8000100000000405", ""},
      {"605#R8", ""},
      {"605#R", ""},
      {"605#40001000000000", ""},
      {"605#", ""},
      {"606#4000100000000000", ""},
      {"585#4000100000000000", ""},
      {"00000605#4000100000000000", ""},
  });
}

TEST_F(SdoServer, AnswersUnderDeliveryInOrder) {
  node->on_frame(fakes::frame_of("605#4000100000000000"), now);

  ASSERT_EQ(bus.deliveries.size(), 1U);
  EXPECT_EQ(bus.deliveries.front(), canopen::Delivery::Ordered);
}

TEST_F(SdoServer, GivesTheOwnersRefusalAsItsAbortCode) {
  class Refusing final : public canopen::EntryOwner {
   public:
    canopen::Result<std::int64_t> read(const canopen::Entry&, std::int64_t) override {
      return canopen::refuse(canopen::AbortCode::NoData);
    }
    canopen::Result<void> write(const canopen::Entry&, std::int64_t) override {
      return canopen::refuse(canopen::AbortCode::LocalControl);
    }
  } owner;
  dictionary.own_read(0x2018, 0, owner);
  dictionary.own_write(0x2018, 0, owner);

  expect_dialogue({
      {"605#4018200000000000", "585#8018200024000008"},
      {"605#2318200001000000", "585#8018200021000008"},
  });
  EXPECT_EQ(value_of(0x2018), 0);
}

}  // namespace
