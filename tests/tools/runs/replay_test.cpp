#include "tools/axisctl/runs/replay/replay.hpp"

#include <gtest/gtest.h>

#include "tests/tools/runs/log_file.hpp"
#include "tests/tools/runs/scripted_unit.hpp"

namespace runs_test {
namespace {

using runs::ExitStatus;
using runs::Replay;
using runs::ReplayOptions;
using namespace std::chrono_literals;

class ReplayTest : public testing::Test {
 protected:
  /// Plays the log @p lines to a unit that speaks as in @p unit.
  runs::Expected<void> play(std::string_view lines, std::string_view unit) {
    wire.emplace(**runs::LogReader::open(logs.write("unit.log", unit)));
    if (prepare) prepare(*wire);
    runs::Nodes nodes;
    nodes.set(5);
    const auto log = runs::LogReader::open(logs.write("x.log", lines));
    Replay replay{*wire, nodes, {}, options};
    const auto played = replay.play(**log);
    figures = replay.figures();
    run = replay.run();
    return played;
  }
  /// Plays @p frames to a unit that speaks as in @p unit, all a millisecond apart.
  void play_frames(std::string_view frames, std::string_view unit) {
    const auto played = play(Logs::lines_of(frames), Logs::lines_of(unit));
    EXPECT_TRUE(played) << played.error().message;
  }
  /// What was sent, and when (ms since the first frame): "0 000#0105, 2 605#40".
  [[nodiscard]] std::string sent() const {
    std::string text;
    for (const conformance::TimedFrame& frame : wire->sent)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", (frame.time - wire->sent.front().time) / 1ms,
                          runs::text_of({.frame = frame.frame}));
    return text;
  }

  Logs logs;
  ReplayOptions options;
  std::function<void(ScriptedUnit&)> prepare{};
  std::optional<ScriptedUnit> wire{};
  runs::ReplayFigures figures{};
  runs::Course run{};
};

constexpr const char* kTalk = "000#0105 185#4002 605#4000100000000000 585#4300100092010200 205#0F00 080# 185#3702";

TEST_F(ReplayTest, SendsWhatTheMasterHasSentWhenItDid) {
  play_frames(kTalk, kTalk);
  EXPECT_EQ(sent(), "0 000#0105, 2 605#4000100000000000, 4 205#0F00, 5 080#");
  EXPECT_EQ(figures.sent, 4U);
  EXPECT_EQ(figures.answers, 1U);
  EXPECT_EQ(figures.unanswered, 0U);
  EXPECT_EQ(figures.late, 0ns);
}

TEST_F(ReplayTest, WaitsForALateAnswer) {
  play_frames("605#4000100000000000 585#4300100092010200 205#0F00 +5 205#0700",
              "605#4000100000000000 +30 585#4300100092010200 205#0F00 205#0700");
  EXPECT_EQ(sent(), "0 605#4000100000000000, 31 205#0F00, 36 205#0700") << "and keeps what is between frames";
  EXPECT_EQ(figures.late, 29ms);
}

TEST_F(ReplayTest, GivesUpAnAnswerThatDoesNotCome) {
  options.patience = 100ms;
  play_frames("605#4000100000000000 585#4300100092010200 605#4001100000000000 585#4F01100000000000",
              "605#4000100000000000 605#4001100000000000 585#4F01100000000000");
  EXPECT_EQ(figures.answers, 2U);
  EXPECT_EQ(figures.unanswered, 1U);
  EXPECT_EQ(figures.sent, 2U);
}

TEST_F(ReplayTest, DoesNotWaitForAnAnswerThatTheLogDoesNotHave) {
  play_frames("605#4000100000000000 605#4001100000000000", "605#4000100000000000 +50 585#4300100092010200");
  EXPECT_EQ(sent(), "0 605#4000100000000000, 1 605#4001100000000000");
}

TEST_F(ReplayTest, WaitsForTheBootUpMessage) {
  play_frames("000#8105 705#00 000#0105", "000#8105 +400 705#00 000#0105");
  EXPECT_EQ(sent(), "0 000#8105, 401 000#0105");
}

TEST_F(ReplayTest, PlaysFaster) {
  options.speed = 2;
  play_frames("205#0F00 +20 205#0700 +10 205#0600", "205#0F00");
  EXPECT_EQ(sent(), "0 205#0F00, 10 205#0700, 15 205#0600");
}

TEST_F(ReplayTest, PlaysWhatIsOfTheMasterAlone) {
  play_frames(
      "705#05 080# 100#010203040506 77F#05 705#R 7E5#04 185#37 085#0010 606#4000100000000000 206#00 000#0106 "
      "000#0100 123#00 705#05",
      "080#");
  EXPECT_EQ(sent(), "0 080#, 1 100#010203040506, 2 77F#05, 3 705#R, 4 7E5#04, 10 000#0100");
  EXPECT_EQ(figures.left_out, 4U) << "requests, a PDO and a command for node 6, and 123h";
}

TEST_F(ReplayTest, FollowsIdentifiersOfRpdosThatAreWritten) {
  constexpr const char* kMoved = "605#2301140123010000 585#6001140100000000 123#0F00 205#0700";
  play_frames(kMoved, kMoved);
  EXPECT_EQ(sent(), "0 605#2301140123010000, 2 123#0F00, 3 205#0700");
  constexpr const char* kRefused = "605#2301140123010000 585#8001140122000008 123#0F00";
  play_frames(kRefused, kRefused);
  EXPECT_EQ(sent(), "0 605#2301140123010000");
}

TEST_F(ReplayTest, ForgetsIdentifiersWithAResetUnlessTheyAreSaved) {
  const std::string save = "605#2310100173617665 585#6010100100000000 ";
  const std::string reset = "000#8205 705#00 123#0F00";
  const std::string moved = "605#2301140123010000 585#6001140100000000 ";
  play_frames(moved + reset, moved + reset);
  EXPECT_TRUE(sent().ends_with("000#8205")) << sent();
  play_frames(moved + save + reset, moved + save + reset);
  EXPECT_TRUE(sent().ends_with("123#0F00")) << sent();
}

TEST_F(ReplayTest, SendsATimeThatGoesBackRightBehind) {
  ASSERT_TRUE(play("(10.0) can0 205#01\n(9.0) can0 205#02\n(10.5) can0 205#03\n", ""));
  EXPECT_EQ(sent(), "0 205#01, 0 205#02, 500 205#03");
}

TEST_F(ReplayTest, PlaysALogWithoutTimesByItsAnswers) {
  ASSERT_TRUE(
      play(" can0  605   [8]  40 00 10 00 00 00 00 00\n can0  585   [8]  43 00 10 00 92 01 02 00\n"
           " can0  205   [2]  0F 00\n",
           Logs::lines_of("605#4000100000000000 +7 585#4300100092010200 205#0F00")));
  EXPECT_EQ(sent(), "0 605#4000100000000000, 7 205#0F00");
}

TEST_F(ReplayTest, KeepsWhatHasPassed) {
  options.keeps_courses = true;
  play_frames(kTalk, kTalk);
  ASSERT_EQ(run.passages.size(), 7U);
  EXPECT_TRUE(run.passages[0].is_of_master);
  EXPECT_EQ(run.passages[3].frame.id, 0x585U);
  EXPECT_EQ(run.passages[3].at, 3ms);
}

TEST_F(ReplayTest, CountsWhatTheBusDoesNotCarry) {
  prepare = [](ScriptedUnit& unit) { unit.refused = 0x705; };
  play_frames("705#R 205#00", "");
  EXPECT_EQ(figures.refused, 1U);
  EXPECT_EQ(sent(), "0 205#00");
}

TEST_F(ReplayTest, EndsWithTheBusAndWithASignal) {
  prepare = [](ScriptedUnit& unit) { unit.down_after = 1; };
  const auto down = play(Logs::lines_of("205#00 205#01"), "");
  ASSERT_FALSE(down);
  EXPECT_EQ(down.error().status, ExitStatus::CutOff);
  prepare = [](ScriptedUnit& unit) { unit.interrupted_after = 1; };
  const auto interrupted = play(Logs::lines_of("205#00 205#01"), "");
  ASSERT_FALSE(interrupted);
  EXPECT_EQ(interrupted.error().message, "interrupted, 1 frames had been sent");
}

TEST_F(ReplayTest, RefusesALogWithoutAMaster) {
  const auto played = play(Logs::lines_of("185#00 705#05"), "");
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().status, ExitStatus::Damaged);
}

}  // namespace
}  // namespace runs_test
