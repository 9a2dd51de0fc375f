#include "record/candump.hpp"

#include <string>

#include <gtest/gtest.h>

namespace record {
namespace {

using namespace std::chrono_literals;

TEST(CandumpLine, IsThatOfTheTool) {
  constexpr auto kTime = 1700000000s + 123456789ns;
  const canopen::Frame data{.id = 0x605, .length = 3, .data = {0x40, 0, 0xAB}};
  const canopen::Frame remote{.id = 0x705, .length = 1, .remote = true};
  const canopen::Frame empty{.id = 0x705, .remote = true};
  const canopen::Frame extended{.id = 0x12ABC, .length = 0, .extended = true};

  EXPECT_EQ(candump_line(data, kTime, "can0"), "(1700000000.123456) can0 605#4000AB\n");
  EXPECT_EQ(candump_line(remote, kTime, "can0"), "(1700000000.123456) can0 705#R1\n");
  EXPECT_EQ(candump_line(empty, kTime, "can0"), "(1700000000.123456) can0 705#R\n");
  EXPECT_EQ(candump_line(extended, kTime, "can0"), "(1700000000.123456) can0 00012ABC#\n");
}

/// Lines that candump writes, and that come out again as they were.
class WholeLines : public testing::TestWithParam<const char*> {};

TEST_P(WholeLines, AreReadAndWrittenAgain) {
  const auto line = read_candump_line(GetParam());

  ASSERT_TRUE(line) << line.error();
  EXPECT_EQ(candump_line(*line), std::string{GetParam()} + "\n");
}

INSTANTIATE_TEST_SUITE_P(Candump, WholeLines,
                         testing::Values("(1700000000.123456) can0 605#4000AB", "(0000000001.000000) lab 000#",
                                         "(1700000000.123456) vcan0 7FF#0011223344556677",
                                         "(1700000000.123456) can0 1FFFFFFF#FF",
                                         "(1700000000.123456) can0 00000005#", "(1700000000.123456) can0 705#R",
                                         "(1700000000.123456) can0 12345678#R8",
                                         "(1700000000.123456) can0 20000004#000C000000000000",
                                         "(1700000000.123456) can0 200001A8#0102030405060708"));

TEST(CandumpLine, HasItsFlagsInTheIdentifier) {
  EXPECT_EQ(read_candump_line("(1.5) can0 123#")->frame.can_id, 0x123U);
  EXPECT_EQ(read_candump_line("(1.5) can0 00000123#")->frame.can_id, 0x123U | CAN_EFF_FLAG);
  EXPECT_EQ(read_candump_line("(1.5) can0 123#R4")->frame.can_id, 0x123U | CAN_RTR_FLAG);
  EXPECT_EQ(read_candump_line("(1.5) can0 123#R4")->frame.len, 4);
  EXPECT_EQ(read_candump_line("(1.5) can0 20000004#")->frame.can_id, 4U | CAN_ERR_FLAG);
}

TEST(CandumpLine, TakesTimesToTheNanosecond) {
  EXPECT_EQ(read_candump_line("(1700000000.123456789) can0 123#")->at, 1700000000s + 123456789ns);
  EXPECT_EQ(read_candump_line("(0.5) can0 123#")->at, 500ms);
}

TEST(CandumpLine, TakesWhatOtherToolsWrite) {
  for (const char* const text : {"  (1.5) can0 123#1122  ", "(1.5)\tcan0  123#1122\r", "(1.5) can0 123#11.22",
                                 "(1.5) can0 123#1122 R", "(1.5) can0 123#1122 T"}) {
    const auto line = read_candump_line(text);
    ASSERT_TRUE(line) << text << ": " << line.error();
    EXPECT_EQ(candump_line(*line), "(0000000001.500000) can0 123#1122\n") << text;
  }
}

struct Damage {
  const char* text;
  const char* expected;
};

TEST(CandumpLine, SaysWhatWasExpected) {
  constexpr const char* kTime = "(SECONDS.MICROSECONDS) at the beginning";
  constexpr const char* kFrame = "a frame as 123#1122, 12345678#1122 or 123#R behind the interface";
  constexpr const char* kIdentifier = "an identifier of 3 digits up to 7FF or of 8 up to 1FFFFFFF";
  constexpr const char* kData = "at most 8 bytes of two hexadecimal digits behind #";
  constexpr const char* kLength = "nothing or a length 0 to 8 behind #R";
  for (const Damage& damage : {
           Damage{"", kTime},
           Damage{"can0 123#11", kTime},
           Damage{"(1.5 can0 123#11", kTime},
           Damage{"(15) can0 123#11", kTime},
           Damage{"(-1.5) can0 123#11", kTime},
           Damage{"(1.) can0 123#11", kTime},
           Damage{"(1.0000000001) can0 123#11", kTime},
           Damage{"(99999999999.0) can0 123#11", kTime},
           Damage{"(1.5)", "the name of an interface behind the time"},
           Damage{"(1.5) can0", kFrame},
           Damage{"(1.5) 123#11", kFrame},
           Damage{"(1.5) can0 12", kFrame},
           Damage{"(1.5) can0 #11", kIdentifier},
           Damage{"(1.5) can0 12#11", kIdentifier},
           Damage{"(1.5) can0 800#11", kIdentifier},
           Damage{"(1.5) can0 1234#11", kIdentifier},
           Damage{"(1.5) can0 40000000#11", kIdentifier},
           Damage{"(1.5) can0 12G#11", kIdentifier},
           Damage{"(1.5) can0 123#1", kData},
           Damage{"(1.5) can0 123#1G", kData},
           Damage{"(1.5) can0 123#11.", kData},
           Damage{"(1.5) can0 123#112233445566778899", kData},
           Damage{"(1.5) can0 123#1122334455667788_B", kData},
           Damage{"(1.5) can0 123#R9", kLength},
           Damage{"(1.5) can0 123#R11", kLength},
           Damage{"(1.5) can0 123##311", "a classical frame, not one of CAN FD"},
           Damage{"(1.5) can0 123#11 X", "nothing, R or T behind the frame"},
       }) {
    const auto line = read_candump_line(damage.text);
    ASSERT_FALSE(line) << damage.text;
    EXPECT_EQ(line.error(), damage.expected) << damage.text;
  }
}

}  // namespace
}  // namespace record
