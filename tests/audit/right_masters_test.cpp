#include <string>

#include <gtest/gtest.h>

#include "tests/audit/heard_log.hpp"

namespace audit_test {
namespace {

/// Frames of masters that do nothing wrong, or of which too little was heard to say so.
struct RightMaster {
  std::string name;
  std::string_view log;
};

const RightMaster kRightMasters[]{
    {"LogBeginsInATransfer", R"((0.0000) can0 585#0053696D756C6174
(0.0010) can0 605#7000000000000000
(0.0020) can0 585#1B65640000000000
(0.0030) can0 605#8008100000000405)"},
    {"LogBeginsWhileLssConfigures", R"((0.0000) can0 7E5#1105000000000000
(0.0010) can0 7E4#1100000000000000
(0.0020) can0 7E5#1700000000000000
(0.0030) can0 7E4#1700000000000000
(0.0040) can0 7E5#0400000000000000)"},
    {"PdoOnAnotherIdentifierThanTheUsual", "(0.0000) can0 6A0#0102"},
    {"StartsAllWithEachNodeThatBoots", R"((0.0000) can0 705#00
(0.0010) can0 000#0100
(0.1000) can0 706#00
(0.1010) can0 000#0100
(0.2000) can0 707#00
(0.2010) can0 000#0100
(0.3000) can0 708#00
(0.3010) can0 000#0100
(0.4000) can0 709#00
(0.4010) can0 000#0100)"},
    {"StartsAllThoughOneIsGone", R"((0.0000) can0 705#7F
(0.0010) can0 706#7F
(0.0020) can0 000#8100
(1.0000) can0 705#00
(1.1000) can0 000#0100)"},
    {"LooksForNodesAfterAReset", R"((0.0000) can0 000#8100
(1.0000) can0 705#00
(1.1000) can0 606#4000100000000000
(2.1000) can0 606#8000100000000405)"},
    {"TellsTheProducerOfSyncAgain", R"((0.0000) can0 080#
(0.1000) can0 080#
(0.2000) can0 080#
(0.2010) can0 605#2305100080000040
(0.2020) can0 585#6005100000000000)"},
    {"MakesHeartbeatsRare", R"((0.0000) can0 705#05
(0.1000) can0 705#05
(0.2000) can0 705#05
(0.3000) can0 705#05
(0.3100) can0 605#2B17100010270000
(0.3110) can0 585#6017100000000000
(5.0000) can0 605#4001100000000000
(5.0010) can0 585#4F01100000000000)"},
    {"EndsNodeGuarding", R"((0.0000) can0 705#R
(0.0010) can0 705#05
(0.1000) can0 705#R
(0.1010) can0 705#85
(0.2000) can0 705#R
(0.2010) can0 705#05
(0.3000) can0 705#R
(0.3010) can0 705#85
(0.4000) can0 705#R
(0.4010) can0 705#05
(5.0000) can0 605#4001100000000000
(5.0010) can0 585#4F01100000000000)"},
    {"GuardsAgainAfterAReset", R"((0.0000) can0 605#2B0C100064000000
(0.0010) can0 585#600C100000000000
(0.0020) can0 605#2F0D100003000000
(0.0030) can0 585#600D100000000000
(0.1000) can0 705#R
(0.1010) can0 705#7F
(0.2000) can0 000#8105
(1.0000) can0 705#00
(1.0010) can0 605#2B0C100064000000
(1.0020) can0 585#600C100000000000
(1.0030) can0 605#2F0D100003000000
(1.0040) can0 585#600D100000000000
(2.0000) can0 705#R
(2.0010) can0 705#7F)"},
    {"HeartbeatWasUnderWayBeforeTheStart", R"((0.0000) can0 705#7F
(1.0000) can0 000#0105
(1.0010) can0 705#7F
(1.0100) can0 205#0600)"},
    {"StopsWithoutALookAtTheStatusword", R"((0.0000) can0 605#4041600000000000
(0.0010) can0 585#4B41600033020000
(0.0020) can0 605#2B4060000F000000
(0.0030) can0 585#6040600000000000
(0.0040) can0 605#2B40600000000000
(0.0050) can0 585#6040600000000000)"},
    {"SendsNoSetPointsAtRest", R"((0.0000) can0 605#2F60600008000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4061600000000000
(0.0030) can0 585#4F61600008000000
(0.0040) can0 605#4000160000000000
(0.0050) can0 585#4F00160001000000
(0.0060) can0 605#4000160100000000
(0.0070) can0 585#4300160120007A60
(0.0080) can0 605#4041600000000000
(0.0090) can0 585#4B41600037020000
(0.0100) can0 705#05
(0.0200) can0 205#01000000
(0.0300) can0 080#
(0.0350) can0 205#02000000
(0.0400) can0 080#
(0.0450) can0 205#02000000
(0.0500) can0 080#
(0.0600) can0 080#
(0.0700) can0 080#
(0.0750) can0 205#03000000)"},
    {"ConfiguresAnewAfterAReset", R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#6000160100000000
(0.0060) can0 605#2F00160001000000
(0.0070) can0 585#6000160000000000
(0.0080) can0 000#8205
(1.0000) can0 705#00
(1.0010) can0 000#0105)"},
    {"DoesWithoutAnInhibitTime", R"((0.0000) can0 605#2300180185010080
(0.0010) can0 585#6000180100000000
(0.0020) can0 605#2B00180364000000
(0.0030) can0 585#8000180320000008
(0.0040) can0 605#2300180185010000
(0.0050) can0 585#6000180100000000)"},
    {"MapsAnewWhatWasRefused", R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#8000160120000008
(0.0060) can0 605#2F00160000000000
(0.0070) can0 585#6000160000000000
(0.0080) can0 605#2300140105020000
(0.0090) can0 585#6000140100000000)"},
    {"ResetsWhatLssHasConfigured", R"((0.0000) can0 7E5#0401000000000000
(0.0100) can0 7E5#1107000000000000
(0.0110) can0 7E4#1100000000000000
(0.0200) can0 000#8200
(1.0000) can0 707#00
(9.0000) can0 707#7F)"},
    {"GivesUpAsTheAnswerComes", R"((0.0000) can0 605#4000100000000000
(0.5000) can0 585#4300100092010200
(0.5002) can0 605#8000100000000405)"},
    {"AsksTwoServersOfANode", R"((0.0000) can0 605#4001120100000000
(0.0010) can0 585#43011201C5060000
(0.0020) can0 605#4001120200000000
(0.0030) can0 585#43011202A5060000
(0.0040) can0 605#4000100000000000
(0.0050) can0 6C5#4001100000000000
(0.0060) can0 585#4300100092010200
(0.0070) can0 6A5#4F01100000000000)"},
    {"IsGoneWhenANodeBootsAgain", R"((0.0000) can0 000#0105
(0.0100) can0 705#05
(1.0000) can0 705#00
(2.0000) can0 705#7F
(9.0000) can0 705#7F)"},
};

class RightMasterTest : public testing::TestWithParam<RightMaster> {};

TEST_P(RightMasterTest, IsLeftAlone) {
  const audit::Findings findings = findings_of(GetParam().log);
  EXPECT_EQ(rules_of(findings), std::vector<std::string_view>{});
}

INSTANTIATE_TEST_SUITE_P(Masters, RightMasterTest, testing::ValuesIn(kRightMasters),
                         [](const auto& each) { return each.param.name; });

/// What a device would say of two of its entries.
eds::Description description_of_two() {
  eds::Description description{5};
  const eds::DataTypeRow* const unsigned16 = eds::find_data_type(6);
  description.add({.index = 0x2000, .type = unsigned16, .high = eds::Value{.integer = {.magnitude = 1000}}});
  description.add({.index = 0x1017, .type = unsigned16, .initial = eds::Value{.integer = {.magnitude = 500}}});
  return description;
}

std::vector<std::string_view> rules_by_eds(std::string_view log) {
  return rules_of(findings_of(log, {.descriptions = {description_of_two()}}));
}

TEST(Eds, TellsOfValuesThatTheDeviceHasTakenAllTheSame) {
  EXPECT_EQ(rules_by_eds("(0.000) can0 605#2B002000E9030000\n(0.001) can0 585#6000200000000000"),
            std::vector<std::string_view>{"object.limits"});
  EXPECT_EQ(rules_by_eds("(0.000) can0 605#23002000E8030000\n(0.001) can0 585#6000200000000000"),
            std::vector<std::string_view>{"object.length"});
  EXPECT_EQ(rules_by_eds("(0.000) can0 605#2B002000E8030000\n(0.001) can0 585#6000200000000000"),
            std::vector<std::string_view>{});
}

TEST(Eds, HoldsForANodeThatWasHeardToBoot) {
  EXPECT_EQ(rules_by_eds("(0.000) can0 705#00\n(0.100) can0 705#R"),
            std::vector<std::string_view>{"error-control.guards-heartbeat"});
  EXPECT_EQ(rules_by_eds("(0.000) can0 705#7F\n(0.100) can0 705#R"), std::vector<std::string_view>{});
}

}  // namespace
}  // namespace audit_test
