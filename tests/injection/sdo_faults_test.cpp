#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

constexpr std::string_view kRead = "605#4000100000000000";
const std::string kAnswer = "585#430010009201FFFF";
const Lines kNone{};

class SdoFaults : public testing::Test {
 protected:
  SdoFaults() {
    unit.start();
    unit.passes(100ms);
  }
  static device::Configuration with_block() {
    device::Configuration configuration = device::unit_with({});
    configuration.sdo_block = true;
    return configuration;
  }
  FaultyUnit unit{with_block()};
};

TEST_F(SdoFaults, OfARequestThatIsNotHeardOrNotAnswered) {
  unit.inject("sdo.deaf times=1");
  EXPECT_EQ(unit.says("605#2B17100014000000"), kNone);
  EXPECT_EQ(unit.number_at(0x1017), 0);  // not carried out
  unit.inject("sdo.silent times=1");
  EXPECT_EQ(unit.says("605#2B17100014000000"), Lines{"705#7F"});
  EXPECT_EQ(unit.number_at(0x1017), 20);  // carried out
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(SdoFaults, ComeOnTheObjectThatIsNamed) {
  unit.inject("sdo.silent object=1018 sub_index=1");
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
  EXPECT_EQ(unit.says("605#4018100200000000").size(), 1U);
  EXPECT_EQ(unit.says("605#4018100100000000"), kNone);
}

TEST_F(SdoFaults, DelayTheAnswerAndKeepTheOrder) {
  unit.inject("sdo.late delay_ms=50 times=1");
  EXPECT_EQ(unit.says(kRead), kNone);
  EXPECT_EQ(unit.says("605#4018100100000000"), kNone);
  EXPECT_EQ(unit.passes(49ms), kNone);
  EXPECT_EQ(unit.passes(1ms), (Lines{kAnswer, "585#4318100153000006"}));
}

TEST_F(SdoFaults, AnswerTwice) {
  unit.inject("sdo.twice times=1");
  EXPECT_EQ(unit.says(kRead), (Lines{kAnswer, kAnswer}));
}

TEST_F(SdoFaults, AbortWithACode) {
  unit.inject("sdo.abort code=0x06060000 object=1017");
  EXPECT_EQ(unit.says("605#2B17100014000000"), Lines{"585#8017100000000606"});
  EXPECT_EQ(unit.number_at(0x1017), 0);
}

TEST_F(SdoFaults, AbortAtAStepOfASegmentedTransfer) {
  unit.inject("sdo.abort code=0x05040000 step=2 times=1");
  EXPECT_EQ(unit.says("605#4008100000000000"), Lines{"585#4108100008000000"});
  EXPECT_EQ(unit.says("605#6000000000000000"), Lines{"585#8008100000000405"});
  EXPECT_EQ(unit.says("605#6000000000000000"), Lines{"585#8000000001000405"});  // the server has forgotten it
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(SdoFaults, AbortAtAStepOfABlockDownload) {
  unit.inject("sdo.abort code=0x08000000 step=2 times=1");
  EXPECT_EQ(unit.says("605#C200580104000000").size(), 1U);
  const Lines answer = unit.says("605#8178563412000000");
  ASSERT_EQ(answer.size(), 1U);
  EXPECT_TRUE(answer[0].starts_with("585#80") && answer[0].ends_with("00000008")) << answer[0];
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(SdoFaults, TurnTheToggleBitOfASegment) {
  unit.inject("sdo.toggle step=2");
  EXPECT_EQ(unit.says("605#4008100000000000"), Lines{"585#4108100008000000"});
  const Lines wrong = unit.says("605#6000000000000000");
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_TRUE(wrong[0].starts_with("585#10")) << wrong[0];
  const Lines right = unit.says("605#7000000000000000");
  ASSERT_EQ(right.size(), 1U);
  EXPECT_TRUE(right[0].starts_with("585#1D")) << right[0];  // the third frame is as it should be
}

TEST_F(SdoFaults, NameAnotherObject) {
  unit.inject("sdo.multiplexor");
  EXPECT_EQ(unit.says(kRead), Lines{"585#430110009201FFFF"});
  EXPECT_EQ(unit.says("605#4004100000000000"), Lines{"585#8005100000000206"});
}

TEST_F(SdoFaults, AnnounceAnotherSize) {
  unit.inject("sdo.length");
  EXPECT_EQ(unit.says(kRead), Lines{"585#470010009201FFFF"});                   // three bytes of four
  EXPECT_EQ(unit.says("605#4017100000000000"), Lines{"585#4717100000000000"});  // three bytes of two
  EXPECT_EQ(unit.says("605#4008100000000000"), Lines{"585#4108100009000000"});
}

/// The frames of a block upload of 1008h: initiation, start, the segments.
Lines block_upload(FaultyUnit& unit) {
  Lines lines = unit.says("605#A408100004000000");
  for (std::string& line : unit.says("605#A300000000000000")) lines.push_back(std::move(line));
  for (std::string& line : unit.says("605#A202040000000000")) lines.push_back(std::move(line));
  return lines;
}

TEST_F(SdoFaults, ChangeTheCrcOfABlockUpload) {
  const Lines right = block_upload(unit);
  ASSERT_EQ(right.size(), 4U);
  unit.says("605#A100000000000000");
  unit.inject("sdo.crc");
  const Lines wrong = block_upload(unit);
  ASSERT_EQ(wrong.size(), 4U);
  EXPECT_TRUE(std::equal(right.begin(), right.begin() + 3, wrong.begin()));
  EXPECT_EQ(right[3].substr(0, 6), wrong[3].substr(0, 6));
  EXPECT_NE(right[3], wrong[3]);
}

TEST_F(SdoFaults, ChangeTheNumberOfASegmentOfABlock) {
  unit.inject("sdo.sequence step=2");
  const Lines wrong = block_upload(unit);
  ASSERT_GE(wrong.size(), 3U);
  EXPECT_TRUE(wrong[1].starts_with("585#02")) << wrong[1];
  EXPECT_TRUE(wrong[2].starts_with("585#82")) << wrong[2];
}

TEST_F(SdoFaults, LeaveTheLastSegmentOfABlockASegment) {
  unit.inject("sdo.sequence step=2");
  unit.says("605#A400100004000000");  // four bytes
  const Lines wrong = unit.says("605#A300000000000000");
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_TRUE(wrong[0].starts_with("585#82")) << wrong[0];  // 80h would be an abort
}

TEST_F(SdoFaults, NameTheIndexAboveAlsoOverAByte) {
  unit.inject("sdo.multiplexor");
  EXPECT_EQ(unit.says("605#40FF600000000000"), Lines{"585#4300610000000000"});
}

TEST_F(SdoFaults, DoNotAnswerAnAbort) {
  const auto id = unit.inject("sdo.abort code=0x08000000");
  EXPECT_EQ(unit.says("605#8000100000000405"), kNone);
  EXPECT_EQ(unit.faults.loaded()[0].trigger.opportunities(), 0U);
  unit.faults.remove(id);
}

TEST_F(SdoFaults, DoNotAnswerWhereNoServerDoes) {
  unit.inject("sdo.abort code=0x08000000");
  EXPECT_EQ(unit.says("605#40001000"), kNone);  // of eight bytes alone
  unit.says("000#0205");
  EXPECT_EQ(unit.says(kRead), kNone);  // Stopped
  unit.says("000#8005");
  EXPECT_EQ(unit.says(kRead), Lines{"585#8000100000000008"});
}

TEST_F(SdoFaults, AbortAlsoWhatTheServerHadBegunBefore) {
  unit.inject("sdo.abort code=0x08000000 object=0x1000");
  unit.says("605#4008100000000000");
  EXPECT_EQ(unit.says(kRead), Lines{"585#8000100000000008"});
  EXPECT_EQ(unit.says("605#6000000000000000"), Lines{"585#8000000001000405"});
}

TEST_F(SdoFaults, FollowTransfersThroughAReset) {
  unit.inject("sdo.abort code=0x08000000 object=0x1000");
  unit.says("605#C200580104000000");  // segments are to come
  unit.says("000#8105");
  EXPECT_EQ(unit.says(kRead), Lines{"585#8000100000000008"});
}

TEST_F(SdoFaults, FollowTransfersThatEndUnheard) {
  unit.inject("sdo.abort code=0x08000000 object=0x1000");
  unit.says("605#C200580104000000");
  const auto gone = unit.inject("node.gone");
  unit.passes(60s);  // the server has lost its patience
  unit.faults.remove(gone);
  EXPECT_EQ(unit.says(kRead), Lines{"585#8000100000000008"});
}

TEST_F(SdoFaults, ComeOnOneServerOfSeveral) {
  const Lines before = unit.says("605#4001120100000000");
  ASSERT_EQ(before.size(), 1U);
  unit.inject("sdo.silent server=2");
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(SdoFaults, OfAServerThatIsNotThereAreRefused) {
  const auto id = unit.faults.add(fault_of("sdo.silent server=9"));
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error(), "server: expected 1 to 3, the SDO servers of the unit, got 9");
}

}  // namespace
}  // namespace injection
