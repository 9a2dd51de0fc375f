#include "libcanopen/sdo/command.hpp"
#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

/// Segmented transfers (CiA 301, 7.2.4.3.3 and 7.2.4.3.6).
class SdoTransfer : public NodeTest {
 protected:
  void SetUp() override { start(); }
  std::string text_of(std::uint16_t index) const {
    const auto bytes = dictionary.text(*dictionary.find(index, 0).value());
    return {bytes.begin(), bytes.end()};
  }
};

TEST_F(SdoTransfer, UploadsALongTextInSegments) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},  // "Slave of the tests"
      {"605#6000000000000000", "585#00536C617665206F"},
      {"605#7000000000000000", "585#1066207468652074"},
      {"605#6000000000000000", "585#0765737473000000"},
      {"605#7000000000000000", "585#8000000001000405"},  // the transfer is over
  });
}

TEST_F(SdoTransfer, UploadsAShortAndAnEmptyTextInOneSegment) {
  expect_dialogue({
      {"605#400A100000000000", "585#410A100003000000"},
      {"605#6000000000000000", "585#09312E3000000000"},
      {"605#4024200000000000", "585#4124200000000000"},
      {"605#6000000000000000", "585#0F00000000000000"},
  });
}

TEST_F(SdoTransfer, UploadsSevenBytesInExactlyOneSegment) {
  store_value(0x201C, 0, 0x07060504030201);  // UNSIGNED56
  expect_dialogue({
      {"605#401C200000000000", "585#411C200007000000"},
      {"605#6000000000000000", "585#0101020304050607"},
  });
}

TEST_F(SdoTransfer, UploadsWideNumbers) {
  store_value(0x201A, 0, -2);                  // INTEGER40
  store_value(0x201D, 0, 0x0807060504030201);  // INTEGER64
  expect_dialogue({
      {"605#401A200000000000", "585#411A200005000000"},
      {"605#6000000000000000", "585#05FEFFFFFFFF0000"},
      {"605#401D200000000000", "585#411D200008000000"},
      {"605#6000000000000000", "585#0001020304050607"},
      {"605#7000000000000000", "585#1D08000000000000"},
  });
}

TEST_F(SdoTransfer, UploadsAValueAsItWasWhenTheTransferBegan) {
  store_value(0x201D, 0, 0x0807060504030201);
  says("605#401D200000000000");
  says("605#6000000000000000");

  store_value(0x201D, 0, -1);

  EXPECT_EQ(says("605#7000000000000000"), (Lines{"585#1D08000000000000"}));
}

TEST_F(SdoTransfer, DownloadsAText) {
  expect_dialogue({
      {"605#2123200009000000", "585#6023200000000000"},
      {"605#0048656C6C6F2C20", "585#2000000000000000"},
      {"605#1B796F0000000000", "585#3000000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "Hello, yo");
}

TEST_F(SdoTransfer, DownloadsWithoutAnnouncedSize) {
  expect_dialogue({
      {"605#2023200000000000", "585#6023200000000000"},
      {"605#0B58590000000000", "585#2000000000000000"},
      {"605#201D200000000000", "585#601D200000000000"},
      {"605#0001020304050607", "585#2000000000000000"},
      {"605#1D08000000000000", "585#3000000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "XY");
  EXPECT_EQ(value_of(0x201D), 0x0807060504030201);
}

TEST_F(SdoTransfer, DownloadsAShortNumberInSegmentsToo) {
  expect_dialogue({
      {"605#2113200002000000", "585#6013200000000000"},
      {"605#0B34120000000000", "585#2000000000000000"},
  });
  EXPECT_EQ(value_of(0x2013), 0x1234);
}

TEST_F(SdoTransfer, DownloadsTextsInOneFrameToo) {
  expect_dialogue({
      {"605#2B23200041420000", "585#6023200000000000"},
      {"605#2324200041424344", "585#8024200010000706"},  // longer than its capacity of 3
  });
  EXPECT_EQ(text_of(0x2023), "AB");
  EXPECT_EQ(text_of(0x2024), "");
}

TEST_F(SdoTransfer, DownloadsAnEmptyText) {
  expect_dialogue({
      {"605#2123200000000000", "585#6023200000000000"},
      {"605#0F00000000000000", "585#2000000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "");
}

TEST_F(SdoTransfer, RefusesASizeThatDoesNotFitTheObject) {
  expect_dialogue({
      {"605#211D200007000000", "585#801D200010000706"},
      {"605#211D200009000000", "585#801D200010000706"},
      {"605#2113200004000000", "585#8013200010000706"},
      {"605#2113200000000000", "585#8013200010000706"},
      {"605#2123200015000000", "585#8023200010000706"},  // 21 of at most 20 bytes
      {"605#21232000FFFFFFFF", "585#8023200010000706"},
      {"605#2313200000000000", "585#8013200010000706"},
      {"605#231D200000000000", "585#801D200010000706"},  // four bytes to an INTEGER64
      {"605#221D200000000000", "585#801D200010000706"},
  });
}

TEST_F(SdoTransfer, RefusesEveryWrongUnannouncedLengthOfEveryNumericType) {
  for (std::uint16_t index = 0x2010; index < 0x2020; ++index) {
    const unsigned expected = (*dictionary.find(index, 0))->size;
    for (unsigned size = 0; size <= 7; ++size) {
      const auto low = static_cast<std::uint8_t>(index);
      canopen::Frame initiate = canopen::sdo::response(0x605, 0x20, {index, 0}, 0);
      canopen::Frame segment{.id = 0x605, .length = 8, .data = {static_cast<std::uint8_t>((7 - size) << 1 | 1)}};
      node->on_frame(initiate, now);
      bus.take();
      node->on_frame(segment, now);
      char abort[32];
      std::snprintf(abort, sizeof abort, "585#80%02X200010000706", low);
      EXPECT_EQ(sent(), (Lines{size == expected ? "585#2000000000000000" : abort}))
          << std::hex << index << ' ' << size;
    }
  }
}

TEST_F(SdoTransfer, RefusesMoreBytesThanTheLongestObjectHolds) {
  expect_dialogue({
      {"605#2023200000000000", "585#6023200000000000"},
      {"605#0041414141414141", "585#2000000000000000"},
      {"605#1041414141414141", "585#3000000000000000"},
      {"605#0041414141414141", "585#8023200010000706"},
      {"605#1141414141414141", "585#8000000001000405"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoTransfer, RefusesMoreOrFewerBytesThanAnnounced) {
  expect_dialogue({
      {"605#2123200003000000", "585#6023200000000000"},
      {"605#0741424344000000", "585#8023200012000706"},
      {"605#2123200003000000", "585#6023200000000000"},
      {"605#0B41420000000000", "585#8023200013000706"},
      {"605#211D200008000000", "585#601D200000000000"},
      {"605#0101020304050607", "585#801D200013000706"},
      {"605#211D200008000000", "585#601D200000000000"},
      {"605#0001020304050607", "585#2000000000000000"},
      {"605#1B08090000000000", "585#801D200012000706"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
  EXPECT_EQ(value_of(0x201D), 0);
}

TEST_F(SdoTransfer, ChecksTheLimitsOfWideNumbersAtTheEnd) {
  expect_dialogue({
      {"605#2106200008000000", "585#6006200000000000"},
      {"605#0001000000000100", "585#2000000000000000"},
      {"605#1D00000000000000", "585#8006200031000906"},  // 2^40 + 1
      {"605#2106200008000000", "585#6006200000000000"},
      {"605#00FFFFFFFFFFFEFF", "585#2000000000000000"},
      {"605#1DFF000000000000", "585#8006200032000906"},  // -2^40 - 1
      {"605#2107200008000000", "585#6007200000000000"},
      {"605#00F0FFFFFFFFFFFF", "585#2000000000000000"},
      {"605#1DFF000000000000", "585#8007200031000906"},
      {"605#2107200008000000", "585#6007200000000000"},
      {"605#00EFFFFFFFFFFFFF", "585#2000000000000000"},
      {"605#1DFF000000000000", "585#3000000000000000"},
  });
  EXPECT_EQ(value_of(0x2006), -(1LL << 40) + 1);
  EXPECT_EQ(value_of(0x2007), -17);
}

TEST_F(SdoTransfer, AbortsWhenTheToggleBitDoesNotAlternate) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#7000000000000000", "585#8008100000000305"},
      {"605#6000000000000000", "585#8000000001000405"},  // and the transfer is gone
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#6000000000000000", "585#00536C617665206F"},
      {"605#6000000000000000", "585#8008100000000305"},
      {"605#2123200009000000", "585#6023200000000000"},
      {"605#1048656C6C6F2C20", "585#8023200000000305"},
      {"605#2123200009000000", "585#6023200000000000"},
      {"605#0048656C6C6F2C20", "585#2000000000000000"},
      {"605#0048656C6C6F2C20", "585#8023200000000305"},
  });
}

TEST_F(SdoTransfer, AbortsOnASegmentOfTheOtherDirection) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#0041414141414141", "585#8008100001000405"},
      {"605#6000000000000000", "585#8000000001000405"},
      {"605#2123200009000000", "585#6023200000000000"},
      {"605#6000000000000000", "585#8023200001000405"},
  });
}

TEST_F(SdoTransfer, EndsSilentlyWhenTheClientAborts) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#8008100000000405", ""},
      {"605#6000000000000000", "585#8000000001000405"},
  });
  EXPECT_EQ(passes(1min), Lines{});
}

TEST_F(SdoTransfer, RestartsOnANewInitiateRequestWithoutAnAbort) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#6000000000000000", "585#00536C617665206F"},
      {"605#400A100000000000", "585#410A100003000000"},
      {"605#6000000000000000", "585#09312E3000000000"},
      {"605#2123200009000000", "585#6023200000000000"},
      {"605#0048656C6C6F2C20", "585#2000000000000000"},
      {"605#4000100000000000", "585#4300100092010200"},
      {"605#1B796F0000000000", "585#8000000001000405"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoTransfer, GoesOnDespiteFramesThatAreNoRequest) {
  expect_dialogue({
      {"605#4008100000000000", "585#4108100012000000"},
      {"605#60000000000000", ""},
      {"605#R8", ""},
      {"605#6000000000000000", "585#00536C617665206F"},
  });
}

TEST_F(SdoTransfer, TimesOutTenSecondsAfterTheLastRequest) {
  says("605#4008100000000000");
  EXPECT_EQ(passes(9s), Lines{});
  says("605#6000000000000000");

  EXPECT_EQ(passes(9999ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"19000ms 585#8008100000000405"}));

  EXPECT_EQ(passes(1h), Lines{});
  EXPECT_EQ(says("605#7000000000000000"), (Lines{"585#8000000001000405"}));
}

TEST_F(SdoTransfer, LeavesNoDeadlineBehindWhenItIsFinished) {
  expect_dialogue({
      {"605#400A100000000000", "585#410A100003000000"},
      {"605#6000000000000000", "585#09312E3000000000"},
  });

  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

}  // namespace
