/// The parameter channel of a telegram (PKW).
#include "tests/profidrive/record_unit.hpp"

namespace profidrive {
namespace {

struct Dialogue {
  const char* name;
  std::vector<device::Exchange> exchanges;
};

class ChannelDialogue : public testing::TestWithParam<Dialogue> {};

TEST_P(ChannelDialogue, GoesAsWritten) {
  RecordUnit unit;

  for (const auto& [request, answer] : GetParam().exchanges) EXPECT_EQ(unit.exchange(request), answer) << request;
}

INSTANTIATE_TEST_SUITE_P(
    ByTheRules, ChannelDialogue,
    testing::Values(
        Dialogue{"ReadOfADoubleWordThenNothing",
                 {{"1000008000000000", "20000080453B8000"}, {"0000000000000000", "0000000000000000"}}},
        Dialogue{"ReadOfAWord",
                 {{"1032 0000 0000 0000", "1032000000000000"}, {"6032 0000 0000 0000", "4032000000000000"}}},
        Dialogue{"ReadOfAnArray", {{"603F 0200 0000 0000", "503F020000000000"}}},
        Dialogue{"NumberOfElements",
                 {{"93B1000000000000", "63B1000000000040"}, {"9460 0000 0000 0000", "6460000000000001"}}},
        Dialogue{"WriteOfADoubleWord",
                 {{"3460 0000 4000 0000", "2460000040000000"},
                  {"1460 0000 0000 0000", "2460000040000000"},
                  {"8460 0000 4040 0000", "5460000040400000"},
                  {"6460 0000 0000 0000", "5460000040400000"}}},
        Dialogue{"WriteOfAWord",
                 {{"2317 0020 0000 0002", "1317002000000002"},  // p8791
                  {"1317 0020 0000 0000", "1317002000000002"},
                  {"7317 0020 FFFF FFFF", "43170020FFFFFFFF"},
                  {"6317 0020 0000 0000", "431700200000FFFF"},
                  {"7317 0020 0000 FFFF", "431700200000FFFF"}}},
        Dialogue{"WriteOfASourceAsAWord",
                 {{"2348 0000 0383 FC02", "134800000383FC02"}, {"1348 0000 0000 0000", "234800000383FC02"}}},
        Dialogue{"WriteOfASourceOfASecondCommandDataSet", {{"7348010002D2FC02", "7348010000030000"}}},
        Dialogue{"UnknownParameter",
                 {{"67CE000000000000", "77CE000000000000"}, {"17CF 0000 0000 0000", "77CF000000000000"}}},
        Dialogue{"UnknownPage", {{"1000 0001 0000 0000", "7000000100000000"}}},
        Dialogue{"NumberBeyondItsPage", {{"17D0 0000 0000 0000", "77D0000000000000"}}},
        Dialogue{"WriteOfAReadOnlyOne", {{"8015000000000000", "7015000000010000"}}},
        Dialogue{"UnknownRequests",
                 {{"5000008000000000", "70000080006A0000"},
                  {"A000008000000000", "70000080006A0000"},
                  {"F000 0080 0000 0000", "70000080006A0000"}}},
        Dialogue{"OtherWidth",
                 {{"2460 0000 0000 0002", "7460000000050000"}, {"3317 0020 0000 0002", "7317002000050000"}}},
        Dialogue{"HighWordThatIsNone",
                 {{"2317 0020 0001 0002", "7317002000020000"}, {"2317 0020 FFFF 0002", "7317002000020000"}}},
        Dialogue{"Limits",
                 {{"3460 0000 BF80 0000", "7460000000020000"}, {"2317 0020 0000 0004", "7317002000020000"}}},
        Dialogue{"NoArray", {{"1460 0100 0000 0000", "7460010000040000"}}},
        Dialogue{"NoSuchIndex", {{"63B1 4000 0000 0000", "73B1400000030000"}}},
        Dialogue{"Descriptions",
                 {{"4460 0100 0000 0000", "3460010000000008"},
                  {"4460 0200 0000 0000", "3460020000000001"},
                  {"4460 0300 0000 0000", "346003003F800000"},
                  {"4460 0600 0000 0000", "7460060000660000"},
                  {"4460 0000 0000 0000", "7460000000660000"},
                  {"4460 0D00 0000 0000", "74600D0000030000"}}},
        Dialogue{"PagesOfThousands",
                 {{"12BC 0020 0000 0000", "22BC002000000205"}, {"12BC 0090 0000 0000", "72BC009000000000"}}}),
    [](const auto& test) { return std::string{test.param.name}; });

TEST(Channel, CarriesARequestOutOnce) {
  RecordUnit unit;
  ASSERT_EQ(unit.exchange("3460 0000 4000 0000"), "2460000040000000");
  ASSERT_EQ(unit.record("01020201 1001 0460 0000 0801 40400000"), "01020201");

  EXPECT_EQ(unit.exchange("3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(unit.record("02010201 1001 0460 0000"), "02010201080140400000");
  EXPECT_EQ(unit.exchange("0000 0000 0000 0000"), "0000000000000000");
  EXPECT_EQ(unit.exchange("3460 0000 4000 0000"), "2460000040000000");
  EXPECT_EQ(unit.record("02010201 1001 0460 0000"), "02010201080140000000");
}

TEST(Channel, ReadsAgainWhileTheRequestStays) {
  RecordUnit unit;
  ASSERT_EQ(unit.exchange("1460 0000 0000 0000"), "2460000041200000");

  ASSERT_EQ(unit.record("01020201 1001 0460 0000 0801 40400000"), "01020201");

  EXPECT_EQ(unit.exchange("1460 0000 0000 0000"), "2460000040400000");
}

}  // namespace
}  // namespace profidrive
