#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/fixture/recording_view.hpp"
#include "tests/libcanopen/fixture/sdo_client.hpp"
#include "tests/libcanopen/fixture/sdo_table.hpp"

namespace {

using Bytes = SdoClient::Bytes;
using Outcome = SdoClient::Outcome;
using canopen::AbortCode;

/// Objects of the application beside those of the dictionary.
class SdoView : public NodeTest {
 protected:
  explicit SdoView(const canopen::Policy& policy = {.extended_identifiers = false})
      : NodeTest{policy, sdo_table()} {
    node->show(view);
    start();
  }
  /// The first @p size of 01h, 02h, ...
  static Bytes counting(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i + 1);
    return bytes;
  }
  Bytes& value(std::uint8_t server = 0) { return view.values[{server, 0x3000, 1}]; }

  RecordingView view;
  SdoClient client{*node, bus};
  static constexpr canopen::sdo::Address kObject{0x3000, 1};
};

TEST_F(SdoView, GivesUpToFourBytesInOneFrame) {
  value() = {0xA1};
  EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#4F003001A1000000"}));
  value() = {0xA1, 0xA2};
  EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#4B003001A1A20000"}));
  value() = {0xA1, 0xA2, 0xA3};
  EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#47003001A1A2A300"}));
  value() = {0xA1, 0xA2, 0xA3, 0xA4};
  EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#43003001A1A2A3A4"}));
}

TEST_F(SdoView, GivesUpToEightBytesInSegments) {
  value() = counting(5);
  expect_dialogue(
      {{"605#4000300100000000", "585#4100300105000000"}, {"605#6000000000000000", "585#0501020304050000"}});
  value() = counting(8);
  expect_dialogue({{"605#4000300100000000", "585#4100300108000000"},
                   {"605#6000000000000000", "585#0001020304050607"},
                   {"605#7000000000000000", "585#1D08000000000000"}});
}

TEST_F(SdoView, TakesUpToFourBytesInOneFrame) {
  expect_dialogue({{"605#2F003001B1FFFFFF", "585#6000300100000000"},
                   {"605#2B003001B1B2FFFF", "585#6000300100000000"},
                   {"605#27003001B1B2B3FF", "585#6000300100000000"},
                   {"605#23003001B1B2B3B4", "585#6000300100000000"}});
  EXPECT_EQ(view.told, (Lines{"0 3000:01 1", "0 3000:01 2", "0 3000:01 3", "0 3000:01 4"}));
  EXPECT_EQ(value(), (Bytes{0xB1, 0xB2, 0xB3, 0xB4}));
}

TEST_F(SdoView, SaysThatAClientHasNotSaidHowManyBytesCount) {
  EXPECT_EQ(says("605#22003001B1B2B3B4"), (Lines{"585#6000300100000000"}));
  EXPECT_EQ(view.told, (Lines{"0 3000:01 4 at most"}));
}

TEST_F(SdoView, TakesUpToEightBytesInSegmentsWithTheirLastOne) {
  for (std::size_t size = 1; size <= 8; ++size) {
    for (const bool says_size : {true, false}) {
      EXPECT_EQ(client.download(kObject, counting(size), says_size), Outcome{counting(size)});
      EXPECT_EQ(value(), counting(size));
    }
  }
  EXPECT_EQ(view.told.size(), 16U);
  EXPECT_EQ(view.told.back(), "0 3000:01 8");

  says("605#2100300108000000");
  says("605#0001020304050607");
  EXPECT_EQ(view.told.size(), 16U) << "not before its end";
}

TEST_F(SdoView, RefusesLengthsThatNoValueHas) {
  EXPECT_EQ(client.download(kObject, counting(9)), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(client.download(kObject, counting(9), false), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(client.download(kObject, {}), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(client.download(kObject, {}, false), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(client.block_download(kObject, counting(9)), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(client.block_download(kObject, counting(15), {}, false), Outcome{AbortCode::LengthMismatch});
  EXPECT_EQ(view.told, Lines{});
}

TEST_F(SdoView, RefusesMoreOrFewerBytesThanAnnounced) {
  expect_dialogue({{"605#2100300102000000", "585#6000300100000000"},
                   {"605#0901020300000000", "585#8000300112000706"},
                   {"605#2100300104000000", "585#6000300100000000"},
                   {"605#0901020300000000", "585#8000300113000706"}});
  EXPECT_EQ(view.told, Lines{});
}

TEST_F(SdoView, AnswersWithTheRefusalOfTheApplication) {
  view.answer = AbortCode::DeviceState;
  expect_dialogue(
      {{"605#4000300100000000", "585#8000300122000008"}, {"605#2F003001B1000000", "585#8000300122000008"}});
  EXPECT_EQ(client.download(kObject, counting(6)), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(client.block_download(kObject, counting(6)), Outcome{AbortCode::DeviceState});
  EXPECT_EQ(client.block_upload(kObject), Outcome{AbortCode::DeviceState});
}

TEST_F(SdoView, EndsAnUploadOfAnImpossibleSize) {
  for (const std::size_t size : {0U, 9U}) {
    view.size_given = size;
    EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#8000300120000008"})) << size;
  }
}

TEST_F(SdoView, ShowsAValueAsItWasWhenTheTransferBegan) {
  value() = counting(8);
  says("605#4000300100000000");
  value() = {0xFF};
  EXPECT_EQ(says("605#6000000000000000"), (Lines{"585#0001020304050607"}));
}

TEST_F(SdoView, HidesWhatIsNowhereFromEveryRequest) {
  for (const char* const request : {"605#4000400000000000", "605#2F00400000000000", "605#2100400008000000",
                                    "605#A400400004000000", "605#C600400004000000"}) {
    EXPECT_EQ(says(request), (Lines{"585#8000400000000206"})) << request;
  }
  EXPECT_EQ(says("680#4000200000000000"), (Lines{"681#8000200000000206"})) << "the dictionary has it";
}

TEST_F(SdoView, LeavesTheDictionaryAsItIs) {
  expect_dialogue({{"605#4000100000000000", "585#4300100092010200"},
                   {"605#4000100100000000", "585#8000100111000906"},
                   {"605#2B00100000000000", "585#8000100002000106"},
                   {"605#2300200078563412", "585#6000200000000000"},
                   {"605#4000200000000000", "585#4300200078563412"}});
  EXPECT_EQ(says("680#4000100000000000"), (Lines{"681#4300100092010200"}));
}

TEST_F(SdoView, TellsTheServerByTheNumberOfItsObject) {
  value(127) = {0x7F};
  EXPECT_EQ(says("680#4000300100000000"), (Lines{"681#4F0030017F000000"}));
  EXPECT_EQ(says("605#4000300100000000"), (Lines{"585#8000300111000906"})) << "not that of the first server";
  says("680#2F00300155000000");
  EXPECT_EQ(view.told, (Lines{"127 3000:01 1"}));
}

TEST_F(SdoView, WorksInBlocksToo) {
  for (std::size_t size = 1; size <= 8; ++size) {
    EXPECT_EQ(client.block_download(kObject, counting(size)), Outcome{counting(size)});
    EXPECT_EQ(client.block_upload(kObject), Outcome{counting(size)});
  }
  EXPECT_EQ(view.told.size(), 8U);
}

TEST_F(SdoView, SwitchesFromBlocksToNormalUploadWhereTheClientAllowsIt) {
  value() = counting(4);
  EXPECT_EQ(says("605#A400300104040000"), (Lines{"585#4300300101020304"}));
  EXPECT_EQ(says("605#A400300104030000"), (Lines{"585#C600300104000000"}));
  value() = counting(8);
  EXPECT_EQ(says("605#A400300104080000"), (Lines{"585#4100300108000000"}));
  EXPECT_EQ(says("605#A400300100000000"), (Lines{"585#8000300102000405"})) << "no block size";
}

TEST_F(SdoView, MakesWayForANewTransferWithoutAnAbort) {
  value() = counting(8);
  expect_dialogue({{"605#2100300108000000", "585#6000300100000000"},
                   {"605#4000300100000000", "585#4100300108000000"},
                   {"605#4000100000000000", "585#4300100092010200"},
                   {"605#6000000000000000", "585#8000000001000405"},
                   {"605#4000300100000000", "585#4100300108000000"},
                   {"605#4000400000000000", "585#8000400000000206"},
                   {"605#6000000000000000", "585#8000000001000405"}});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(SdoView, EndsWithoutAWordWhenTheNodeStopsAndWithAnAbortWhenTheClientIsSilent) {
  says("605#2100300108000000");
  says("000#0205");
  says("000#8005");
  EXPECT_EQ(says("605#0001020304050607"), (Lines{"585#8000000001000405"}));
  says("605#2100300108000000");
  EXPECT_EQ(passes(10s), (Lines{"10000ms 585#8000300100000405"}));
  EXPECT_EQ(client.download(kObject, counting(8)), Outcome{counting(8)});
}

TEST_F(SdoView, AnswersUnderTheOldIdentifierIfAWriteChangesIt) {
  view.reaction = [this] { ASSERT_TRUE(dictionary.write(**dictionary.find(0x127F, 2), 0x80000681)); };
  EXPECT_EQ(says("680#2F00300155000000"), (Lines{"681#6000300100000000"}));
  EXPECT_EQ(says("680#2F00300155000000"), Lines{});

  view.reaction = nullptr;
  EXPECT_EQ(writes_u32(0x127F, 2, 0x681), 0U);
  says("680#2100300105000000");
  view.reaction = [this] { ASSERT_TRUE(dictionary.write(**dictionary.find(0x127F, 1), 0x80000680)); };
  EXPECT_EQ(says("680#0501020304050000"), (Lines{"681#2000000000000000"}));
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

class SdoViewWithoutBlock : public SdoView {
 protected:
  SdoViewWithoutBlock() : SdoView{{.extended_identifiers = false, .sdo_block = false}} {}
};

TEST_F(SdoViewWithoutBlock, RefusesBlockTransferWhereverTheObjectIs) {
  for (const char* const request : {"605#A400300104000000", "605#C600300104000000"}) {
    EXPECT_EQ(says(request), (Lines{"585#8000300101000405"})) << request;
  }
  for (const char* const request : {"605#A400400004000000", "605#C600400004000000"}) {
    EXPECT_EQ(says(request), (Lines{"585#8000400001000405"})) << request;
  }
}

/// A master of nine servers, each of which has a value of its own under the same index.
class SdoViewOfNineServers : public NodeTest {
 protected:
  SdoViewOfNineServers() : NodeTest{{}, many_servers_table()} {
    node->show(view);
    start();
  }
  /// Says @p format to server @p n, with n in the place of %02X; it answers @p expected likewise.
  void expect_answer(unsigned n, const char* format, const char* expected) {
    char said[64], answered[64];
    std::snprintf(said, sizeof said, format, n);
    std::snprintf(answered, sizeof answered, expected, n);
    char request[16] = "605#", response[16] = "585#";
    if (n != 0) {
      std::snprintf(request, sizeof request, "%08X#", n);
      std::snprintf(response, sizeof response, "%08X#", 0x1000 + n);
    }
    EXPECT_EQ(says(request + std::string{said}), (Lines{response + std::string{answered}}));
  }

  RecordingView view;
  static constexpr unsigned kServers = 9;
};

TEST_F(SdoViewOfNineServers, KeepsTheirTransfersApart) {
  using Step = std::array<const char*, 2>;
  // A segmented download and upload; expedited ones around a segmented upload; a block download and upload.
  static constexpr std::array<std::array<Step, 6>, 3> kKinds{{
      {{{"2100300108000000", "6000300100000000"},
        {"00%02X112233445566", "2000000000000000"},
        {"1D88000000000000", "3000000000000000"},
        {"4000300100000000", "4100300108000000"},
        {"6000000000000000", "00%02X112233445566"},
        {"7000000000000000", "1D88000000000000"}}},
      {{{"23003001%02X221100", "6000300100000000"},
        {"2000300200000000", "6000300200000000"},
        {"05%02X223344550000", "2000000000000000"},
        {"4000300200000000", "4100300205000000"},
        {"6000000000000000", "05%02X223344550000"},
        {"4000300100000000", "43003001%02X221100"}}},
      {{{"C200300106000000", "A40030017F000000"},
        {"81%02X223344556600", "A2017F0000000000"},
        {"C500000000000000", "A100000000000000"},
        {"A000300101000000", "C600300106000000"},
        {"A300000000000000", "81%02X223344556600"},
        {"A201010000000000", "C500000000000000"}}},
  }};
  for (std::size_t step = 0; step < 6; ++step) {
    for (unsigned n = 0; n < kServers; ++n) {
      const auto& [said, answered] = kKinds[n % kKinds.size()][step];
      expect_answer(n, said, answered);
    }
  }
  EXPECT_EQ(view.values.size(), kServers + 3);
}

}  // namespace
