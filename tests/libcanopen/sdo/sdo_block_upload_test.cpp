#include "libcanopen/sdo/crc.hpp"
#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

/// Block upload (CiA 301, 7.2.4.3.12 to 7.2.4.3.15).
class SdoBlockUpload : public NodeTest {
 protected:
  void SetUp() override { start(); }
};

TEST(SdoCrc, IsThatOfTheStandard) {
  constexpr std::array<std::uint8_t, 9> kDigits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};

  EXPECT_EQ(canopen::sdo::crc(kDigits), 0x31C3);
  EXPECT_EQ(canopen::sdo::crc(std::span{kDigits}.subspan(4), canopen::sdo::crc(std::span{kDigits}.first(4))),
            0x31C3);
}

TEST_F(SdoBlockUpload, SendsATextInOneSubBlock) {
  EXPECT_EQ(says("605#A408100015000000"), (Lines{"585#C608100012000000"}));  // "Slave of the tests"
  EXPECT_EQ(says("605#A300000000000000"),
            (Lines{"585#01536C617665206F", "585#0266207468652074", "585#8365737473000000"}));
  EXPECT_EQ(says("605#A203150000000000"), (Lines{"585#CD247E0000000000"}));
  EXPECT_EQ(says("605#A100000000000000"), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(SdoBlockUpload, GivesNoCrcToAClientWithoutOne) {
  EXPECT_EQ(says("605#A008100015000000"), (Lines{"585#C608100012000000"}));
  says("605#A300000000000000");
  EXPECT_EQ(says("605#A203150000000000"), (Lines{"585#CD00000000000000"}));
}

TEST_F(SdoBlockUpload, SendsAsManySegmentsAsTheClientTakes) {
  says("605#A408100001000000");
  EXPECT_EQ(says("605#A300000000000000"), (Lines{"585#01536C617665206F"}));
  EXPECT_EQ(says("605#A201010000000000"), (Lines{"585#0166207468652074"}));
  EXPECT_EQ(says("605#A201020000000000"), (Lines{"585#8165737473000000"}));
  EXPECT_EQ(says("605#A201020000000000"), (Lines{"585#CD247E0000000000"}));
}

TEST_F(SdoBlockUpload, SendsAgainWhatWasNotConfirmed) {
  says("605#A408100003000000");
  says("605#A300000000000000");
  EXPECT_EQ(says("605#A200020000000000"), (Lines{"585#01536C617665206F", "585#0266207468652074"}));
  EXPECT_EQ(says("605#A2017F0000000000"), (Lines{"585#0166207468652074", "585#8265737473000000"}));
  EXPECT_EQ(says("605#A201030000000000"), (Lines{"585#8165737473000000"}));
  EXPECT_EQ(says("605#A201030000000000"), (Lines{"585#CD247E0000000000"}));
}

TEST_F(SdoBlockUpload, SendsNumbersAndTheEmptyText) {
  store_value(0x201D, 0, 0x0807060504030201);
  expect_dialogue({
      {"605#A400100015000000", "585#C600100004000000"},
      {"605#A300000000000000", "585#8192010200000000"},
      {"605#A201150000000000", "585#CDA57A0000000000"},
      {"605#A100000000000000", ""},
      {"605#A424200015000000", "585#C624200000000000"},  // no byte: a segment of which none counts
      {"605#A300000000000000", "585#8100000000000000"},
      {"605#A201150000000000", "585#DD00000000000000"},
      {"605#A100000000000000", ""},
      {"605#A41D200015000000", "585#C61D200008000000"},
  });
  EXPECT_EQ(says("605#A300000000000000"), (Lines{"585#0101020304050607", "585#8208000000000000"}));
  EXPECT_EQ(says("605#A202150000000000"), (Lines{"585#D9AC760000000000"}));
}

TEST_F(SdoBlockUpload, FillsTheLastSegmentIfTheSizeAllowsIt) {
  store_value(0x201C, 0, 0x07060504030201);  // UNSIGNED56
  expect_dialogue({
      {"605#A01C200015000000", "585#C61C200007000000"},
      {"605#A300000000000000", "585#8101020304050607"},
      {"605#A201150000000000", "585#C100000000000000"},
  });
}

TEST_F(SdoBlockUpload, SwitchesToNormalUploadWhereTheClientAllowsIt) {
  expect_dialogue({
      {"605#A408100015120000", "585#4108100012000000"},  // 18 bytes, up to 18 may be sent in segments
      {"605#6000000000000000", "585#00536C617665206F"},
      {"605#A408100015110000", "585#C608100012000000"},
      {"605#A400100015040000", "585#4300100092010200"},
      {"605#A400100015030000", "585#C600100004000000"},
      {"605#A424200015010000", "585#4124200000000000"},
      {"605#6000000000000000", "585#0F00000000000000"},
  });
}

TEST_F(SdoBlockUpload, RefusesWhatANormalUploadRefuses) {
  expect_dialogue({
      {"605#A401100015000000", "585#8001100000000206"},
      {"605#A400100115000000", "585#8000100111000906"},
      {"605#A420200015000000", "585#8020200001000106"},
  });
}

TEST_F(SdoBlockUpload, RefusesBlockSizesOtherThan1To127) {
  expect_dialogue({
      {"605#A408100000000000", "585#8008100002000405"},
      {"605#A408100080000000", "585#8008100002000405"},
      {"605#A408100001000000", "585#C608100012000000"},
      {"605#A300000000000000", "585#01536C617665206F"},
      {"605#A201000000000000", "585#8008100002000405"},
      {"605#A201010000000000", "585#8000000001000405"},  // and the transfer is gone
      {"605#A40810007F000000", "585#C608100012000000"},
  });
  EXPECT_EQ(says("605#A300000000000000").size(), 3U);
  EXPECT_EQ(says("605#A201800000000000"), (Lines{"585#8008100002000405"}));
}

TEST_F(SdoBlockUpload, RefusesToBeConfirmedWhatWasNotSent) {
  expect_dialogue({
      {"605#A408100001000000", "585#C608100012000000"},
      {"605#A300000000000000", "585#01536C617665206F"},
      {"605#A202010000000000", "585#8008100003000405"},
      {"605#A201010000000000", "585#8000000001000405"},
  });
}

TEST_F(SdoBlockUpload, AbortsOnEveryRequestThatIsNotTheNextOne) {
  const std::vector<std::string_view> opening{"605#A408100015000000", "605#A300000000000000",
                                              "605#A203150000000000"};
  const std::vector<std::string_view> other{"605#6000000000000000", "605#0000000000000000", "605#C100000000000000",
                                            "605#E000000000000000"};
  const std::vector<std::string_view> continuing{"605#A300000000000000", "605#A203150000000000",
                                                 "605#A100000000000000"};
  for (std::size_t phase = 1; phase <= opening.size(); ++phase) {
    std::vector<std::string_view> wrong = other;
    for (const std::string_view request : continuing)
      if (request != continuing[phase - 1]) wrong.push_back(request);
    for (const std::string_view request : wrong) {
      for (std::size_t i = 0; i < phase; ++i) says(opening[i]);
      EXPECT_EQ(says(request), (Lines{"585#8008100001000405"})) << request << " in phase " << phase;
      EXPECT_EQ(node->next_deadline(), canopen::kNever);
    }
  }
}

TEST_F(SdoBlockUpload, EndsSilentlyWhenTheClientAborts) {
  says("605#A408100001000000");
  says("605#A300000000000000");

  EXPECT_EQ(says("605#8008100000000008"), Lines{});
  EXPECT_EQ(says("605#A201010000000000"), (Lines{"585#8000000001000405"}));
}

TEST_F(SdoBlockUpload, MakesWayForANewTransferWithoutAnAbort) {
  says("605#A408100001000000");
  says("605#A300000000000000");
  expect_dialogue({
      {"605#4000100000000000", "585#4300100092010200"},
      {"605#A201010000000000", "585#8000000001000405"},
      {"605#A40A100001000000", "585#C60A100003000000"},
      {"605#A408100001000000", "585#C608100012000000"},
      {"605#A300000000000000", "585#01536C617665206F"},
      {"605#400A100000000000", "585#410A100003000000"},
  });
}

TEST_F(SdoBlockUpload, TimesOutInEveryPhase) {
  says("605#A408100001000000");
  EXPECT_EQ(passes(10s), (Lines{"10000ms 585#8008100000000405"}));
  says("605#A40A100001000000");
  says("605#A300000000000000");
  EXPECT_EQ(passes(10s), (Lines{"20000ms 585#800A100000000405"}));
  says("605#A40A100001000000");
  says("605#A300000000000000");
  says("605#A201010000000000");
  EXPECT_EQ(passes(10s), (Lines{"30000ms 585#800A100000000405"}));
}

}  // namespace
