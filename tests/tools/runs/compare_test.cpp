#include <gtest/gtest.h>

#include "tests/tools/runs/log_file.hpp"
#include "tools/axisctl/runs/compare/comparison.hpp"
#include "tools/axisctl/runs/compare/report.hpp"

namespace runs_test {
namespace {

using runs::Compared;
using runs::CompareOptions;
using runs::DifferenceKind;
using namespace std::chrono_literals;

class CompareTest : public testing::Test {
 protected:
  /// What comes of a comparison of two logs with these lines.
  Compared compare_lines(std::string_view a, std::string_view b) {
    auto one = runs::LogReader::open(logs.write("a.log", a)),
         other = runs::LogReader::open(logs.write("b.log", b));
    EXPECT_TRUE(one && other);
    auto compared = runs::compare(**one, **other, options, {});
    EXPECT_TRUE(compared) << compared.error().message;
    return compared ? *std::move(compared) : Compared{};
  }
  /// The same of frames that come a millisecond apart.
  Compared compare(std::string_view a, std::string_view b) {
    return compare_lines(Logs::lines_of(a), Logs::lines_of(b));
  }
  /// What the first difference of these frames is.
  DifferenceKind kind_of(std::string_view a, std::string_view b) {
    const Compared compared = compare(a, b);
    EXPECT_TRUE(compared.difference);
    return compared.difference ? compared.difference->kind : DifferenceKind{};
  }
  static std::string text(const Compared& compared) { return runs::text_of(compared, "a.log", "b.log"); }

  Logs logs;
  CompareOptions options;
};

constexpr const char* kDialogue = "000#0105 605#4041600000000000 585#4B41600037020000 080# 185#3702";

TEST_F(CompareTest, FindsNoDifferenceInTheSameLog) {
  const Compared compared = compare(kDialogue, kDialogue);
  EXPECT_FALSE(compared.difference);
  EXPECT_EQ(compared.frames, 5U);
  EXPECT_EQ(text(compared),
            "a.log and b.log are the same: 5 frames\nall times before are the same, to the microsecond\n");
}

TEST_F(CompareTest, NamesTheByteAndItsBits) {
  const Compared compared = compare("185#3702 185#3702", "185#3702 185#3F06");
  ASSERT_TRUE(compared.difference);
  EXPECT_EQ(compared.difference->kind, DifferenceKind::Data);
  ASSERT_EQ(compared.difference->bytes.size(), 2U);
  EXPECT_EQ(compared.difference->bytes[0].byte, 0U);
  EXPECT_EQ(compared.difference->bytes[0].bits(), 0x08);
  EXPECT_EQ(compared.difference->bytes[1].bits(), 0x04);
  EXPECT_NE(text(compared).find("byte 0: 37 and 3F, bit 3; byte 1: 02 and 06, bit 2"), std::string::npos);
}

TEST_F(CompareTest, TellsWhatOfAFrameDiffers) {
  EXPECT_EQ(kind_of("185#37", "186#37"), DifferenceKind::Identifier);
  EXPECT_EQ(kind_of("185#37", "185#3702"), DifferenceKind::Length);
  EXPECT_EQ(kind_of("185#37", "185#38"), DifferenceKind::Data);
  EXPECT_EQ(kind_of("185#", "185#R"), DifferenceKind::Format);
  EXPECT_EQ(kind_of("185#37", "00000185#37"), DifferenceKind::Format);
  EXPECT_EQ(kind_of("00000004#0000000000000000", "20000004#0000000000000000"), DifferenceKind::Format);
}

TEST_F(CompareTest, TellsWhichLogIsLonger) {
  EXPECT_NE(text(compare("185#37 185#38", "185#37")).find("only the first log has more frames"),
            std::string::npos);
  EXPECT_NE(text(compare("185#37", "185#37 185#38")).find("only the second log has more frames"),
            std::string::npos);
}

TEST_F(CompareTest, TellsAFrameThatComesLater) {
  const Compared swapped = compare("080# 185#37 285#01 705#05", "080# 285#01 185#37 705#05");
  ASSERT_TRUE(swapped.difference);
  EXPECT_EQ(swapped.difference->a_in_b, 1U);
  EXPECT_EQ(swapped.difference->b_in_a, 1U);
  EXPECT_NE(text(swapped).find("the second log has the frame of the first one 1 frame later"), std::string::npos);
  const Compared missing = compare("080# 185#37 285#01", "080# 285#01");
  EXPECT_EQ(missing.difference->a_in_b, 0U);
  EXPECT_EQ(missing.difference->b_in_a, 1U);
}

TEST_F(CompareTest, ShowsTheFramesAround) {
  options.surroundings = 2;
  const Compared compared =
      compare("001# 002# 003# 185#37 004# 005# 006#", "001# 002# 003# 185#38 004# 005# 006#");
  ASSERT_TRUE(compared.difference);
  ASSERT_EQ(compared.difference->before.size(), 2U);
  ASSERT_EQ(compared.difference->after.size(), 2U);
  EXPECT_EQ(compared.difference->before.front().a->frame.id, 0x002U);
  EXPECT_EQ(compared.difference->after.back().b->frame.id, 0x005U);
  EXPECT_EQ(compared.difference->at.a->place, 4U);
}

TEST_F(CompareTest, TellsWhatWasLastBeforeIt) {
  const Compared compared = compare(std::string{kDialogue} + " 185#3702", std::string{kDialogue} + " 185#3302");
  ASSERT_TRUE(compared.difference);
  std::vector<std::string> formers;
  for (const runs::Former& former : compared.difference->formers)
    formers.push_back(former.what + ": " + former.words);
  EXPECT_EQ(formers, (std::vector<std::string>{
                         "same identifier: TPDO 1 of node 5", "SDO request: SDO request to node 5: read 6041h:00",
                         "NMT: NMT start to node 5", "SYNC: SYNC", "PDO: TPDO 1 of node 5"}));
}

TEST_F(CompareTest, ShowsTheRequestThatAnAnswerBelongsTo) {
  const Compared compared = compare("605#4000100000000000 606#4018100100000000 585#4300100092010200",
                                    "605#4000100000000000 606#4018100100000000 585#8000100000000206");
  ASSERT_TRUE(compared.difference);
  EXPECT_NE(text(compared).find("SDO request to node 5: read 1000h:00"), std::string::npos);
  EXPECT_EQ(compared.difference->words_a, "SDO response of node 5: 1000h:00 = 00020192h");
  EXPECT_TRUE(compared.difference->words_b.starts_with("SDO response of node 5: 1000h:00 aborted: 06020000h"));
}

TEST_F(CompareTest, FollowsIdentifiersThatAreWritten) {
  constexpr const char* kMoved = "605#2301140112030000 585#6001140100000000 312#0F00";
  const Compared compared = compare(std::string{kMoved} + " 312#0F00", std::string{kMoved} + " 312#0700");
  ASSERT_TRUE(compared.difference);
  EXPECT_EQ(compared.difference->words_a, "RPDO 2 of node 5");
}

TEST_F(CompareTest, DoesNotFollowAWriteThatIsRefused) {
  constexpr const char* kRefused = "605#2301140112030000 585#8001140122000008";
  EXPECT_EQ(compare(std::string{kRefused} + " 312#0F", std::string{kRefused} + " 312#07").difference->words_a,
            "RPDO 2 of node 18");
}

TEST_F(CompareTest, IgnoresTimesUnlessTheyAreAskedFor) {
  EXPECT_FALSE(compare("185#37 +20 185#38", "185#37 185#38").difference);
  const Compared compared = compare("185#37 +20 185#38 185#39", "185#37 185#38 +40 185#39");
  EXPECT_EQ(compared.times.first, -19ms);
  EXPECT_EQ(compared.times.first_place, 2U);
  EXPECT_EQ(compared.times.largest, 20ms);
  EXPECT_EQ(compared.times.largest_place, 3U);
}

TEST_F(CompareTest, ComparesTimesToTheMicrosecond) {
  options.time = *runs::read_time_rule("exact");
  EXPECT_FALSE(compare(kDialogue, kDialogue).difference);
  const Compared compared = compare_lines("(1.000000) can0 001#\n(1.000100) can0 002#\n",
                                          "(5.000000) can0 001#\n(5.000101) can0 002#\n");
  ASSERT_TRUE(compared.difference);
  EXPECT_EQ(compared.difference->kind, DifferenceKind::Time);
}

TEST_F(CompareTest, ComparesTimesWithinABand) {
  options.time = *runs::read_time_rule("2ms");
  EXPECT_FALSE(compare("001# +2 002#", "001# +3 002#").difference);
  EXPECT_EQ(kind_of("001# +2 002#", "001# +5 002#"), DifferenceKind::Time);
}

TEST_F(CompareTest, TimesAreThoseSinceTheFirstFrame) {
  options.time = *runs::read_time_rule("exact");
  EXPECT_FALSE(
      compare_lines("(1.5) can0 001#\n(1.75) can0 002#\n", "(9.5) can0 001#\n(9.75) can0 002#\n").difference);
}

TEST_F(CompareTest, ReadsRulesOfTime) {
  EXPECT_FALSE(runs::read_time_rule("ignore")->within);
  EXPECT_EQ(*runs::read_time_rule("500us")->within, 500us);
  EXPECT_EQ(*runs::read_time_rule("0.1s")->within, 100ms);
  for (const char* const wrong : {"", "exactly", "5", "-1ms", "0ms", "ms", "1e300s", "nan s", "nans"})
    EXPECT_FALSE(runs::read_time_rule(wrong)) << wrong;
}

TEST_F(CompareTest, LooksAtSomeIdentifiersOnly) {
  options.identifiers = {0x185};
  EXPECT_FALSE(compare("185#37 001# 185#38", "185#37 285#01 285#02 185#38").difference);
  EXPECT_EQ(kind_of("001# 185#37", "185#38"), DifferenceKind::Data);
  options.identifiers = {0x185 | canopen::cob_id::kExtended};
  EXPECT_FALSE(compare("00000185#37 185#01", "00000185#37 185#02").difference);
}

TEST_F(CompareTest, ComparesLogsOfTwoFormats) {
  const Compared compared =
      compare_lines("(1.000000) can0 605#4000\n(1.001000) can0 585#43\n",
                    " (7.000000)  vcan0  605   [2]  40 00\n (7.001000)  vcan0  585   [1]  43\n");
  EXPECT_FALSE(compared.difference);
  EXPECT_EQ(compared.times.first_place, 0U);
}

TEST_F(CompareTest, ComparesNoTimesIfALogHasNone) {
  options.time = *runs::read_time_rule("exact");
  const Compared compared =
      compare_lines("(1.0) can0 605#40\n(2.0) can0 605#40\n", " can0  605   [1]  40\n can0  605   [1]  40\n");
  EXPECT_FALSE(compared.difference);
  EXPECT_NE(text(compared).find("times are not compared: a log has none"), std::string::npos);
}

TEST_F(CompareTest, TellsThatALogIsCut) {
  const Compared compared = compare_lines("(1.0) can0 605#40\n(2.0) can0 605#40\n", "(1.0) can0 605#40\n(2.0) ca");
  ASSERT_TRUE(compared.difference);
  EXPECT_EQ(compared.difference->kind, DifferenceKind::End);
  ASSERT_EQ(compared.remarks.size(), 1U);
  EXPECT_NE(compared.remarks.front().find("b.log:2: the log is cut"), std::string::npos);
}

TEST_F(CompareTest, IsForPrograms) {
  const auto json = runs::json_of(compare("080# 185#3702", "080# 185#3F02"), "a.log", "b.log");
  EXPECT_EQ(json.at("same"), false);
  EXPECT_EQ(json.at("frames"), 1);
  EXPECT_EQ(json.at("/difference/kind"_json_pointer), "data");
  EXPECT_EQ(json.at("/difference/bytes/0/bits"_json_pointer), 8);
  EXPECT_EQ(json.at("/difference/a/frame"_json_pointer), "185#3702");
  EXPECT_EQ(json.at("/difference/b/place"_json_pointer), 2);
  EXPECT_EQ(json.at("/difference/last/0/what"_json_pointer), "SYNC");
}

}  // namespace
}  // namespace runs_test
