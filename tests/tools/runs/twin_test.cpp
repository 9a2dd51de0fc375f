#include <gtest/gtest.h>

#include "tests/tools/runs/log_file.hpp"
#include "tools/axisctl/runs/fidelity/judge.hpp"
#include "tools/axisctl/runs/fidelity/report.hpp"
#include "tools/axisctl/runs/replay/master_side.hpp"

namespace runs_test {
namespace {

using runs::Aspect;
using runs::Fidelity;
using runs::Nature;
using runs::Tally;

class TwinTest : public testing::Test {
 protected:
  /// What has passed in a log of node 5 whose frames come a millisecond apart.
  runs::Course course_of(std::string_view frames) {
    const auto log = runs::LogReader::open(logs.write("x.log", Logs::lines_of(frames)));
    runs::Nodes nodes;
    nodes.set(5);
    runs::MasterSide side{nodes, {}};
    runs::Course course;
    std::optional<std::chrono::nanoseconds> first;
    while (const auto logged = (*log)->next().value()) {
      const auto judgement = side.judge(*logged);
      const bool is_of_master = judgement.side == runs::Side::Master;
      if (!first && !is_of_master) continue;
      if (!first) first = logged->at;
      course.passages.push_back({.at = logged->at - *first,
                                 .frame = logged->frame,
                                 .meaning = judgement.meaning,
                                 .is_of_master = is_of_master,
                                 .place = logged->place,
                                 .entry = judgement.entry});
    }
    return course;
  }
  Fidelity judge(std::string_view log, std::string_view run) {
    return runs::judge(course_of(log), course_of(run), yardstick);
  }
  /// The only difference there is.
  static runs::Finding only(const Fidelity& fidelity) {
    EXPECT_EQ(fidelity.findings.size(), 1U) << runs::text_of(fidelity, 10);
    return fidelity.findings.empty() ? runs::Finding{} : fidelity.findings.front();
  }
  static std::uint64_t same(const Fidelity& fidelity, Aspect aspect) {
    return fidelity.tallies[static_cast<std::size_t>(aspect)].same;
  }

  Logs logs;
  runs::Yardstick yardstick;
};

// TPDO 2 of node 5 has 6041h and 606Ch once its mapping was read.
constexpr const char* kMapping =
    "605#40011A0000000000 585#4F011A0002000000 605#40011A0100000000 585#43011A0110004160 "
    "605#40011A0200000000 585#43011A0220006C60 ";
constexpr const char* kTrip =
    "000#0105 705#05 185#4002 605#4041600000000000 585#4B41600040020000 205#0600 185#3102 085#1030810000000000 "
    "605#40FFFF0000000000 585#80FFFF0000000206 705#05";

TEST_F(TwinTest, IsTrueToItself) {
  const Fidelity fidelity = judge(kTrip, kTrip);
  EXPECT_TRUE(fidelity.findings.empty()) << runs::text_of(fidelity, 10);
  EXPECT_EQ(fidelity.unknown(), 0U);
  EXPECT_EQ(same(fidelity, Aspect::Answer), 2U);
  EXPECT_EQ(same(fidelity, Aspect::AnswerTime), 2U);
  EXPECT_EQ(same(fidelity, Aspect::Emergency), 1U);
  EXPECT_EQ(same(fidelity, Aspect::State), 1U);
  EXPECT_EQ(same(fidelity, Aspect::PdoWord), 2U);
}

TEST_F(TwinTest, FindsAnotherValue) {
  const auto finding =
      only(judge("605#4041600000000000 585#4B41600040020000", "605#4041600000000000 585#4B41600031020000"));
  EXPECT_EQ(finding.aspect, Aspect::Answer);
  EXPECT_EQ(finding.nature, Nature::Value);
  EXPECT_EQ(finding.object->index, 0x6041);
  EXPECT_EQ(finding.log, "6041h:00 = 0240h");
  EXPECT_EQ(finding.run, "6041h:00 = 0231h");
  EXPECT_EQ(finding.place, 1U);
}

TEST_F(TwinTest, ComparesAbortsByTheirCodes) {
  constexpr const char* kRequest = "605#2300100000000000 ";
  const auto run = [&](const char* answer) {
    return judge(std::string{kRequest} + "585#8000100002000106", std::string{kRequest} + answer);
  };
  EXPECT_TRUE(run("585#8000100002000106").findings.empty());
  EXPECT_EQ(only(run("585#8000100010000706")).nature, Nature::Refusal);
  EXPECT_EQ(only(run("585#6000100000000000")).nature, Nature::Refusal);
}

TEST_F(TwinTest, FindsAnAnswerThatIsMissing) {
  const Fidelity fidelity =
      judge("605#4000100000000000 585#4300100092010200 205#00", "605#4000100000000000 +3 205#00");
  EXPECT_EQ(only(fidelity).nature, Nature::Missing);
  EXPECT_EQ(fidelity.tallies[0].missing, 1U);
  EXPECT_EQ(fidelity.unknown(), 1U);
}

TEST_F(TwinTest, FindsAnAnswerThatTheLogDoesNotHave) {
  constexpr const char* kRun =
      "605#4000100000000000 585#4300100092010200 605#4001100000000000 585#4F01100000000000";
  EXPECT_EQ(only(judge("605#4000100000000000 605#4001100000000000 585#4F01100000000000", kRun)).nature,
            Nature::Extra);
  EXPECT_TRUE(judge("605#4000100000000000 585#4300100092010200 605#4001100000000000", kRun).findings.empty())
      << "the log ends before the answer";
}

TEST_F(TwinTest, FindsAnAnswerThatIsLate) {
  constexpr const char* kLog = "605#4000100000000000 585#4300100092010200";
  EXPECT_TRUE(judge(kLog, "605#4000100000000000 +15 585#4300100092010200").findings.empty());
  const auto finding = only(judge(kLog, "605#4000100000000000 +40 585#4300100092010200"));
  EXPECT_EQ(finding.aspect, Aspect::AnswerTime);
  EXPECT_EQ(finding.log, "1.000 ms");
  EXPECT_EQ(finding.run, "40.000 ms");
}

TEST_F(TwinTest, FindsAnotherOrder) {
  constexpr const char* kLog = "605#2340600006000000 585#6040600000000000 +40 185#3102 +40 085#1030810000000000";
  constexpr const char* kSwapped =
      "605#2340600006000000 585#6040600000000000 +40 085#1030810000000000 +40 185#3102";
  EXPECT_TRUE(judge(kLog, kLog).findings.empty());
  const Fidelity fidelity = judge(kLog, kSwapped);
  const Tally& order = fidelity.tallies[static_cast<std::size_t>(Aspect::Order)];
  EXPECT_EQ(order.different, 1U) << runs::text_of(fidelity, 10);
}

TEST_F(TwinTest, LetsFramesChangePlacesThatAreCloseTogether) {
  const Fidelity fidelity = judge("605#2340600006000000 585#6040600000000000 185#3102 085#1030810000000000",
                                  "605#2340600006000000 585#6040600000000000 085#1030810000000000 185#3102");
  EXPECT_TRUE(fidelity.findings.empty()) << runs::text_of(fidelity, 10);
  EXPECT_EQ(fidelity.tallies[static_cast<std::size_t>(Aspect::Order)].within, 1U);
}

TEST_F(TwinTest, TakesMeasuredValuesWithinTheirBand) {
  constexpr const char* kRequest = "605#406C600000000000 ";
  const auto run = [&](const char* answer) {
    return judge(std::string{kRequest} + "585#436C6000E8030000", std::string{kRequest} + answer);
  };
  const Fidelity close = run("585#436C6000F8030000");
  EXPECT_TRUE(close.findings.empty());
  EXPECT_EQ(close.tallies[0].within, 1U) << "1016 beside 1000: 1 and 2 % of 1000";
  EXPECT_EQ(only(run("585#436C600008040000")).nature, Nature::Value) << "1032";
  ASSERT_TRUE(yardstick.bands.add("606Ch=100"));
  EXPECT_TRUE(run("585#436C600008040000").findings.empty());
}

TEST_F(TwinTest, TakesPdosApartByTheirMapping) {
  const std::string log =
      std::string{kMapping} + "205#0F00 285#3702E8030000 285#3702EE030000 285#3702EE030000 205#00";
  const Fidelity close =
      judge(log, std::string{kMapping} + "205#0F00 285#3702E9030000 285#3702F2030000 285#3702EE030000 205#00");
  EXPECT_TRUE(close.findings.empty()) << runs::text_of(close, 10);
  EXPECT_EQ(same(close, Aspect::PdoWord), 1U);
  EXPECT_EQ(close.tallies[static_cast<std::size_t>(Aspect::PdoValue)].within + same(close, Aspect::PdoValue), 3U);
  const auto far = only(
      judge(log, std::string{kMapping} + "205#0F00 285#3702E8030000 285#3702EE030000 +1 285#370200100000 205#00"));
  EXPECT_EQ(far.aspect, Aspect::PdoValue);
  EXPECT_EQ(far.run, "4096");
}

TEST_F(TwinTest, FindsAnotherWordOfAPdo) {
  const auto finding = only(judge("205#0F00 185#3302 185#3702", "205#0F00 185#3302 185#3F02"));
  EXPECT_EQ(finding.aspect, Aspect::PdoWord);
  EXPECT_EQ(finding.log, "185#3702");
  EXPECT_EQ(finding.run, "185#3F02");
}

TEST_F(TwinTest, FindsWordsThatAreMissingAndMore) {
  EXPECT_EQ(only(judge("205#0F00 185#3102 185#3302 185#3702", "205#0F00 185#3102 185#3702")).nature,
            Nature::Missing);
  EXPECT_EQ(only(judge("205#0F00 185#3102 185#3702 +30 705#05", "205#0F00 185#3102 185#3302 185#3702 +30 705#05"))
                .nature,
            Nature::Extra);
}

TEST_F(TwinTest, MissesNothingBehindTheEndOfTheLog) {
  EXPECT_TRUE(judge("205#0F00 185#3102 +5 185#3302", "205#0F00 185#3102 185#3302 185#3702").findings.empty())
      << "the run is earlier by what is within the band";
  EXPECT_TRUE(judge("205#0F00 +10000 185#3102", "205#0F00 +9700 185#3302 +300 185#3102").findings.empty())
      << "which has a share of the time since the master said something";
}

TEST_F(TwinTest, FindsMoreThanALogWithoutTimesHas) {
  constexpr const char* kRun = "205#0F00 185#3102 185#3302 185#3702 205#0F00";
  runs::Course log = course_of("205#0F00 185#3102 185#3702 205#0F00");
  log.has_times = false;
  for (runs::Passage& passage : log.passages) passage.at = {};
  EXPECT_EQ(only(runs::judge(log, course_of(kRun), yardstick)).nature, Nature::Extra);
}

TEST_F(TwinTest, FindsAnotherEmergencyAndState) {
  EXPECT_EQ(only(judge("205#00 085#1030810000000000", "205#00 085#1031810000000000")).aspect, Aspect::Emergency);
  EXPECT_EQ(only(judge("000#0105 705#7F 705#05", "000#0105 705#7F 705#04")).aspect, Aspect::State);
  EXPECT_TRUE(judge("000#0105 705#05 705#05 705#05", "000#0105 705#05 705#05").findings.empty())
      << "how often a state is told is no difference";
}

TEST_F(TwinTest, KnowsDifferencesThatAreListed) {
  yardstick.known = *runs::KnownDifferences::parse(
      R"([{"id": "AXD-01", "difference": "value", "object": "1018h:03-04", "reason": "so"}])");
  const auto read = [](int sub, int value) {
    return fmt::format("605#401810{:02X}00000000 585#431810{:02X}{:02X}000000 ", sub, sub, value);
  };
  const Fidelity fidelity = judge(read(3, 1) + read(2, 1), read(3, 2) + read(2, 2));
  EXPECT_EQ(fidelity.tallies[0].known, 1U);
  EXPECT_EQ(fidelity.tallies[0].different, 1U);
  EXPECT_EQ(fidelity.unknown(), 1U);
  EXPECT_EQ(fidelity.findings.front().known, "AXD-01: so");
}

TEST_F(TwinTest, RefusesAListOfNoDifferences) {
  for (const char* const wrong :
       {"", "{}", "[1]", R"([{"id": "A", "difference": "odd", "object": "1018h", "reason": "so"}])",
        R"([{"id": "A", "difference": "value", "object": "x", "reason": "so"}])"})
    EXPECT_FALSE(runs::KnownDifferences::parse(wrong)) << wrong;
}

TEST_F(TwinTest, ReadsBands) {
  for (const char* const good : {"606Ch=100", "2015h:00=2%", "6063h, 6064h=0"})
    EXPECT_TRUE(yardstick.bands.add(good)) << good;
  for (const char* const wrong : {"", "606Ch", "606Ch=", "606C=1", "606Ch=-1", "606Ch=nan", "606Ch=%"})
    EXPECT_FALSE(yardstick.bands.add(wrong)) << wrong;
  for (const runs::BandRow& row : runs::band_rows())
    EXPECT_TRUE(conformance::parse_objects(row.objects)) << row.objects;
}

TEST_F(TwinTest, HasTheBandsOfItsPage) {
  std::ostringstream page;
  page << std::ifstream{SOURCE_FOLDER "/docs/reference/runs.md"}.rdbuf();
  constexpr double kPercent = 100;
  for (const runs::BandRow& row : runs::band_rows()) {
    const std::string line = fmt::format("| {} | {} | {:g} | {:g} % |\n", row.objects, row.what, row.band.absolute,
                                         row.band.share * kPercent);
    EXPECT_NE(page.str().find(line), std::string::npos) << line;
  }
}

TEST_F(TwinTest, ComparesSegmentsByTheirBytes) {
  constexpr const char* kLog =
      "605#4008100000000000 585#4108100005000000 605#6000000000000000 585#0553313230000000";
  EXPECT_TRUE(judge(kLog, kLog).findings.empty());
  EXPECT_EQ(
      only(judge(kLog, "605#4008100000000000 585#4108100005000000 605#6000000000000000 585#0553313530000000"))
          .nature,
      Nature::Value);
}

TEST_F(TwinTest, IsForPrograms) {
  const auto json = runs::json_of(
      judge("605#4041600000000000 585#4B41600040020000", "605#4041600000000000 585#4B41600031020000"));
  EXPECT_EQ(json.at("/aspects/sdo_answers/different"_json_pointer), 1);
  EXPECT_EQ(json.at("/differences/0/object"_json_pointer), "6041h:00");
  EXPECT_EQ(json.at("/differences/0/difference"_json_pointer), "value");
  EXPECT_EQ(json.at("unknown"), 1);
  EXPECT_EQ(json.at("/answer_times/log/median_s"_json_pointer), 0.001);
}

}  // namespace
}  // namespace runs_test
