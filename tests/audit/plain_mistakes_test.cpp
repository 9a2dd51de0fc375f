// Mistakes of masters beside the examples that the rules have.
#include <string>

#include <gtest/gtest.h>

#include "tests/audit/heard_log.hpp"

namespace audit_test {
namespace {

struct Mistake {
  std::string name;
  std::string_view rule;  ///< that is broken, and no other
  std::string_view log;
};

const Mistake kMistakes[]{
    {"MapsMoreThanFitsThoughTheEntriesWereNotHeard", "pdo.mapping-long",
     R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160004000000
(0.0030) can0 585#8000160042000406)"},
    {"GivesATpdoTheIdentifierOfANodeThatSends", "bus.identifier-twice",
     R"((0.0000) can0 706#05
(0.1000) can0 186#0102
(0.2000) can0 605#2300180186010000
(0.2010) can0 585#6000180100000000)"},
    {"StopsSyncAndGoesOn", "sync.missing",
     R"((0.0000) can0 605#2F00180201000000
(0.0010) can0 585#6000180200000000
(0.0020) can0 605#2300180185010000
(0.0030) can0 585#6000180100000000
(0.0100) can0 000#0105
(0.0200) can0 705#05
(0.1000) can0 080#
(0.2000) can0 080#
(0.3000) can0 080#
(0.4000) can0 080#
(0.5000) can0 080#
(0.6000) can0 080#
(0.7000) can0 080#
(0.8000) can0 080#
(0.9000) can0 080#
(1.0000) can0 080#
(6.0000) can0 605#4001100000000000
(6.0010) can0 585#4F01100000000000)"},
    {"CountsBeyond1019h", "sync.counter",
     R"((0.0000) can0 605#2F19100003000000
(0.0010) can0 585#6019100000000000
(0.1000) can0 080#01
(0.1100) can0 080#02
(0.1200) can0 080#03
(0.1300) can0 080#04)"},
    {"HoldsBit7OfAnRpdo", "drive.reset-without-edge",
     R"((0.000000) can0 605#4000160000000000
(0.001000) can0 585#4F00160001000000
(0.010000) can0 605#4000160100000000
(0.011000) can0 585#4300160110004060
(0.020000) can0 605#40001A0000000000
(0.021000) can0 585#4F001A0001000000
(0.030000) can0 605#40001A0100000000
(0.031000) can0 585#43001A0110004160
(0.200000) can0 705#05
(0.250000) can0 205#8000
(0.500000) can0 185#0802
(0.510000) can0 205#8000
(1.200000) can0 205#8000
(1.700000) can0 205#8000)"},
    {"TellsNoHigherTimeThanTheProducerHas", "error-control.consumer-shorter",
     R"((0.0000) can0 605#23161001F4010600
(0.0010) can0 585#6016100100000000
(0.0020) can0 606#2B171000E8030000
(0.0030) can0 586#6017100000000000
(0.1000) can0 000#0105
(1.0000) can0 706#7F
(1.1000) can0 000#0105)"},
    {"ReadsALimitInABlockAndGoesBeyond", "drive.beyond-limits", R"((0.0000) can0 605#A07D60027F000000
(0.0010) can0 585#C27D600204000000
(0.0020) can0 605#A300000000000000
(0.0030) can0 585#81E8030000FFFFFF
(0.0040) can0 605#A2017F0000000000
(0.0050) can0 585#CD00000000000000
(0.0060) can0 605#A100000000000000
(0.0100) can0 605#237A600088130000
(0.0110) can0 585#607A600000000000)"},
    {"ReadsALimitInABlockOfWhichItHasLostAPart", "drive.beyond-limits", R"((0.0000) can0 605#A07D60027F000000
(0.0010) can0 585#C27D600204000000
(0.0020) can0 605#A300000000000000
(0.0030) can0 585#81E8030000FFFFFF
(0.0040) can0 605#A2007F0000000000
(0.0050) can0 585#81E8030000FFFFFF
(0.0060) can0 605#A2017F0000000000
(0.0070) can0 585#CD00000000000000
(0.0080) can0 605#A100000000000000
(0.0100) can0 605#237A600088130000
(0.0110) can0 585#607A600000000000)"},
};

class MistakeTest : public testing::TestWithParam<Mistake> {};

TEST_P(MistakeTest, IsFound) {
  const audit::Findings findings = findings_of(GetParam().log);
  EXPECT_EQ(rules_of(findings), std::vector{GetParam().rule});
  EXPECT_EQ(findings.total(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Masters, MistakeTest, testing::ValuesIn(kMistakes),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace audit_test
