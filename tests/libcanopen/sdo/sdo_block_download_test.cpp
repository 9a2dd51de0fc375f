#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

/// Block download (CiA 301, 7.2.4.3.8 to 7.2.4.3.11).
class SdoBlockDownload : public NodeTest {
 protected:
  void SetUp() override { start(); }
  std::string text_of(std::uint16_t index) const {
    const auto bytes = dictionary.text(*dictionary.find(index, 0).value());
    return {bytes.begin(), bytes.end()};
  }
};

TEST_F(SdoBlockDownload, TakesATextWithItsCrc) {
  expect_dialogue({
      {"605#C623200009000000", "585#A42320007F000000"},
      {"605#0148656C6C6F2C20", ""},
      {"605#82796F0000000000", "585#A2027F0000000000"},
      {"605#D5BDAB0000000000", "585#A100000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "Hello, yo");
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(SdoBlockDownload, TakesATextWithoutCrcOrSize) {
  expect_dialogue({
      {"605#C023200000000000", "585#A42320007F000000"},
      {"605#0148656C6C6F2C20", ""},
      {"605#82796F0000000000", "585#A2027F0000000000"},
      {"605#D512340000000000", "585#A100000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "Hello, yo");
}

TEST_F(SdoBlockDownload, TakesNumbersAndTheEmptyText) {
  expect_dialogue({
      {"605#C21A200005000000", "585#A41A20007F000000"},
      {"605#81FEFFFFFFFF0000", "585#A2017F0000000000"},
      {"605#C900000000000000", "585#A100000000000000"},
      {"605#C623200000000000", "585#A42320007F000000"},
      {"605#8100000000000000", "585#A2017F0000000000"},
      {"605#DD00000000000000", "585#A100000000000000"},
      {"605#C218200004000000", "585#A41820007F000000"},
      {"605#8178563412000000", "585#A2017F0000000000"},
      {"605#CD00000000000000", "585#A100000000000000"},
  });
  EXPECT_EQ(value_of(0x201A), -2);
  EXPECT_EQ(value_of(0x2018), 0x12345678);
  EXPECT_EQ(text_of(0x2023), "");
}

TEST_F(SdoBlockDownload, LetsNothingBeSeenBeforeTheEnd) {
  says("605#C623200009000000");
  says("605#0148656C6C6F2C20");
  says("605#82796F0000000000");

  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, DropsSegmentsOutOfOrderAndTakesThemAgain) {
  expect_dialogue({
      {"605#C62320000F000000", "585#A42320007F000000"},
      {"605#0241414141414141", ""},  // the first one is lost
      {"605#8341000000000000", "585#A2007F0000000000"},
      {"605#0130313233343536", ""},
      {"605#0130313233343536", ""},  // twice
      {"605#0337383930313233", ""},
      {"605#8434000000000000", "585#A2017F0000000000"},
      {"605#0137383930313233", ""},
      {"605#8234000000000000", "585#A2027F0000000000"},
      {"605#D93E860000000000", "585#A100000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "012345678901234");
}

TEST_F(SdoBlockDownload, ConfirmsASubBlockOf127Segments) {
  says("605#C023200000000000");
  for (int number = 2; number < 127; ++number) {  // all of them without the first one
    char segment[32];
    std::snprintf(segment, sizeof segment, "605#%02X00000000000000", static_cast<unsigned>(number));
    EXPECT_EQ(says(segment), Lines{});
  }
  EXPECT_EQ(says("605#7F00000000000000"), (Lines{"585#A2007F0000000000"}));
}

TEST_F(SdoBlockDownload, AsksOnceForTheRestIfASubBlockIsNotClosed) {
  says("605#C623200009000000");
  says("605#0148656C6C6F2C20");  // the last segment is lost
  EXPECT_EQ(passes(4999ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"5000ms 585#A2017F0000000000"}));

  expect_dialogue({
      {"605#81796F0000000000", "585#A2017F0000000000"},
      {"605#D5BDAB0000000000", "585#A100000000000000"},
  });
  EXPECT_EQ(text_of(0x2023), "Hello, yo");
}

TEST_F(SdoBlockDownload, TimesOutInEveryPhase) {
  says("605#C623200009000000");
  EXPECT_EQ(passes(1min), (Lines{"5000ms 585#A2007F0000000000", "10000ms 585#8023200000000405"}));
  says("605#C623200009000000");
  says("605#0148656C6C6F2C20");
  passes(4s);
  says("605#82796F0000000000");
  EXPECT_EQ(passes(9999ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"74000ms 585#8023200000000405"}));
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, AsksAgainAfterFurtherSegments) {
  says("605#C62320000F000000");
  EXPECT_EQ(passes(6s), (Lines{"5000ms 585#A2007F0000000000"}));
  says("605#0148656C6C6F2C20");

  EXPECT_EQ(passes(1min), (Lines{"11000ms 585#A2017F0000000000", "16000ms 585#8023200000000405"}));
}

TEST_F(SdoBlockDownload, TakesNoSegmentTwiceFromAClientThatMissesTheEarlyConfirmation) {
  says("605#C023200000000000");  // without size and CRC nobody would see it
  says("605#0141414141414141");
  EXPECT_EQ(passes(6s), (Lines{"5000ms 585#A2017F0000000000"}));

  expect_dialogue({
      {"605#0242424242424242", ""},  // goes on with its sub-block, which the server has closed
      {"605#8343000000000000", "585#8023200003000405"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, GoesOnAfterAnEarlyConfirmationOfNothing) {
  says("605#C623200009000000");
  passes(6s);

  expect_dialogue({
      {"605#0248656C6C6F2C20", ""},  // the first one was lost
      {"605#8300000000000000", "585#A2007F0000000000"},
      {"605#0148656C6C6F2C20", ""},
      {"605#82796F0000000000", "585#A2027F0000000000"},
      {"605#D5BDAB0000000000", "585#A100000000000000"},
  });
}

TEST_F(SdoBlockDownload, TimesOutAlthoughAClientThatHasStartedAnewKeepsAsking) {
  for (const std::string_view request : {"605#4000100000000000", "605#C623200009000000"}) {
    for (const canopen::Duration pause : {1s, 6s}) {
      const canopen::TimePoint opened = now;
      says("605#C623200009000000");
      Lines answers;
      while (answers.empty() || answers.back().find("585#8023200000000405") == std::string::npos) {
        answers = passes(pause);
        ASSERT_LE(now - opened, 16s) << request;
        if (answers.empty() || answers.back().find("#80") == std::string::npos) says(request);
      }
      EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"}));
    }
  }
}

TEST_F(SdoBlockDownload, RefusesAWrongCrc) {
  expect_dialogue({
      {"605#C623200009000000", "585#A42320007F000000"},
      {"605#0148656C6C6F2C20", ""},
      {"605#82796F0000000000", "585#A2027F0000000000"},
      {"605#D5BCAB0000000000", "585#8023200004000405"},
      {"605#D5BDAB0000000000", "585#8000000001000405"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, RefusesMoreOrFewerBytesThanAnnounced) {
  expect_dialogue({
      {"605#C223200008000000", "585#A42320007F000000"},  // 8, and 9 come
      {"605#0148656C6C6F2C20", ""},
      {"605#82796F0000000000", "585#A2027F0000000000"},
      {"605#D500000000000000", "585#8023200012000706"},
      {"605#C223200008000000", "585#A42320007F000000"},  // 8, and 7 come
      {"605#8148656C6C6F2C20", "585#A2017F0000000000"},
      {"605#C100000000000000", "585#8023200013000706"},
      {"605#C223200008000000", "585#A42320007F000000"},  // 8, and more than 14 come
      {"605#0148656C6C6F2C20", ""},
      {"605#0248656C6C6F2C20", ""},
      {"605#8348656C6C6F2C20", "585#8023200012000706"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, RefusesLengthsThatTheEntryCannotHave) {
  expect_dialogue({
      {"605#C223200015000000", "585#8023200010000706"},  // 21 of at most 20 bytes
      {"605#C218200003000000", "585#8018200010000706"},
      {"605#C224200000000000", "585#A42420007F000000"},
      {"605#8141000000000000", "585#A2017F0000000000"},
      {"605#D900000000000000", "585#8024200012000706"},  // one byte, none was announced
      {"605#C024200000000000", "585#A42420007F000000"},
      {"605#0141414141414141", ""},
      {"605#8241414141414141", "585#8024200010000706"},
      {"605#C018200000000000", "585#A41820007F000000"},
      {"605#8141414100000000", "585#A2017F0000000000"},
      {"605#D100000000000000", "585#8018200010000706"},
  });
}

TEST_F(SdoBlockDownload, TakesNoSegmentForARequestWhenItRefusesASubBlock) {
  says("605#C024200000000000");  // a text of at most 3 bytes
  for (int number = 1; number < 127; ++number) {
    char segment[32];  // 23h would write 11223344h to 2018h
    std::snprintf(segment, sizeof segment, "605#%02X18200044332211", static_cast<unsigned>(number));
    EXPECT_EQ(says(segment), Lines{});
  }
  EXPECT_EQ(says("605#7F18200044332211"), (Lines{"585#8024200010000706"}));

  EXPECT_EQ(value_of(0x2018), 0);
}

TEST_F(SdoBlockDownload, RefusesASubBlockThatIsNotClosedToo) {
  says("605#C024200000000000");
  says("605#0141414141414141");
  EXPECT_EQ(passes(1min), (Lines{"5000ms 585#8024200010000706"}));
}

TEST_F(SdoBlockDownload, RefusesWhatANormalDownloadRefuses) {
  expect_dialogue({
      {"605#C201100004000000", "585#8001100000000206"},
      {"605#C200100104000000", "585#8000100111000906"},
      {"605#C221200002000000", "585#8021200002000106"},
      {"605#C201200001000000", "585#A40120007F000000"},
      {"605#81C9000000000000", "585#A2017F0000000000"},
      {"605#D900000000000000", "585#8001200031000906"},  // 201 of at most 200
  });
}

TEST_F(SdoBlockDownload, RefusesTheSequenceNumber0) {
  expect_dialogue({
      {"605#C623200009000000", "585#A42320007F000000"},
      {"605#0048656C6C6F2C20", "585#8023200003000405"},
      {"605#82796F0000000000", ""},  // an abort, for all the server knows
  });
}

TEST_F(SdoBlockDownload, EndsSilentlyWhenTheClientAborts) {
  expect_dialogue({
      {"605#C623200009000000", "585#A42320007F000000"},
      {"605#0148656C6C6F2C20", ""},
      {"605#8023200000000008", ""},
      {"605#D5BDAB0000000000", "585#8000000001000405"},
      {"605#C623200009000000", "585#A42320007F000000"},
      {"605#8148656C6C6F2C20", "585#A2017F0000000000"},
      {"605#8023200000000008", ""},
      {"605#D5BDAB0000000000", "585#8000000001000405"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
}

TEST_F(SdoBlockDownload, AbortsOnAnyOtherRequestThanTheEnd) {
  for (const std::string_view request : {"605#6000000000000000", "605#0000000000000000", "605#A300000000000000",
                                         "605#A201010000000000", "605#A100000000000000", "605#E000000000000000"}) {
    says("605#C623200003000000");
    says("605#8161626300000000");
    EXPECT_EQ(says(request), (Lines{"585#8023200001000405"})) << request;
  }
}

TEST_F(SdoBlockDownload, MakesWayForANewTransferWithoutAnAbort) {
  expect_dialogue({
      {"605#C623200003000000", "585#A42320007F000000"},
      {"605#8158595A00000000", "585#A2017F0000000000"},
      {"605#C624200003000000", "585#A42420007F000000"},
      {"605#8161626300000000", "585#A2017F0000000000"},
      {"605#D1D69D0000000000", "585#A100000000000000"},
      {"605#C623200003000000", "585#A42320007F000000"},
      {"605#8158595A00000000", "585#A2017F0000000000"},
      {"605#4000100000000000", "585#4300100092010200"},
  });
  EXPECT_EQ(text_of(0x2023), "abc");
  EXPECT_EQ(text_of(0x2024), "abc");
}

TEST_F(SdoBlockDownload, EndsWithoutAWordWhenTheNodeStops) {
  says("605#C623200009000000");
  says("605#0148656C6C6F2C20");
  says("000#0205");
  says("000#8005");

  expect_dialogue({{"605#82796F0000000000", ""}});
  EXPECT_EQ(passes(1min), Lines{});
}

}  // namespace
