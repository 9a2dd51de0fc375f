#include "tools/axisctl/runs/log/log_reader.hpp"

#include <gtest/gtest.h>

#include "record/format.hpp"
#include "tests/fakes/recording_bytes.hpp"
#include "tests/tools/runs/log_file.hpp"
#include "tools/axisctl/runs/log/log_facts.hpp"

namespace runs_test {
namespace {

using runs::ExitStatus;
using runs::LogReader;

class LogReaderTest : public testing::Test {
 protected:
  /// The frames of a log with @p text, or what is wrong with it.
  std::string read(std::string_view text, const std::string& interface = {}) {
    auto log = LogReader::open(logs.write("x.log", text), interface);
    if (!log) return logs.shown(log.error().message);
    std::string found;
    for (;;) {
      const auto frame = (*log)->next();
      if (!frame) return found + logs.shown(frame.error().message);
      if (!*frame) break;
      found += runs::text_of(**frame) + ' ';
    }
    has_times = (*log)->has_times();
    return found + logs.shown((*log)->remark());
  }
  /// What is said of a log with @p text that is to be played onto a bus of @p bit_rate.
  std::vector<std::string> remarks(std::string_view text, std::uint32_t bit_rate = 0) {
    std::vector<std::string> lines;
    const auto facts = runs::check_log(logs.write("x.log", text), "", bit_rate, lines);
    if (!facts) lines.push_back(facts.error().message);
    for (std::string& line : lines) line = logs.shown(line);
    return lines;
  }

  Logs logs;
  bool has_times = false;
};

TEST_F(LogReaderTest, ReadsWhatCandumpWritesAndPrints) {
  EXPECT_EQ(read("(1.000001) can0 605#4000100000000000\n(1.2) can0 00012345#R\n"),
            "605#4000100000000000 00012345#R ");
  EXPECT_EQ(read(" (1.000001)  can0  605   [8]  40 00 10 00 00 00 00 00   '@.......'\n"
                 " (1.000002)  can0  RX - -  705   [1]  05\n"
                 " (1.000003)  can0  080   [0] \n (1.000004)  can0  705   [0]  remote request\n"),
            "605#4000100000000000 705#05 080# 705#R ");
}

TEST_F(LogReaderTest, ReadsLinesWithoutTimes) {
  EXPECT_EQ(read("  can0  605   [2]  40 00\n  can0  585   [1]  43\n"), "605#4000 585#43 ");
  EXPECT_FALSE(has_times);
}

TEST_F(LogReaderTest, NamesTheLineThatIsDamaged) {
  EXPECT_EQ(read("(1.0) can0 605#40\n(2.0) can0 6x5#40\n(3.0) can0 605#40\n"),
            "605#40 x.log:2: expected an identifier of 3 digits up to 7FF or of 8 up to 1FFFFFFF, got "
            "\"(2.0) can0 6x5#40\"");
  EXPECT_EQ(read(" (1.0)  can0  605   [3]  40 00\n(2.0) can0 605#40\n"),
            "x.log:1: expected as many bytes of two hexadecimal digits as the length says, got "
            "\" (1.0)  can0  605   [3]  40 00\"");
  EXPECT_EQ(read("(1.0) can0 605#40\n can0  605   [1]  40\n"),
            "605#40 x.log:2: expected a time, as in the lines before, got \" can0  605   [1]  40\"");
}

TEST_F(LogReaderTest, SaysThatALogIsCut) {
  EXPECT_EQ(read("(1.0) can0 605#40\n(2.0) can"),
            "605#40 x.log:2: the log is cut within its last line, which is left out");
  EXPECT_EQ(read("(1.0) can0 605#40\n(2.0) can0 605#41"),
            "605#40 605#41 x.log:2: the last line has no end: the log may be cut");
}

TEST_F(LogReaderTest, TakesOneInterfaceOfSeveral) {
  constexpr const char* kTwo = "(1.0) can0 001#\n(2.0) can1 002#\n";
  EXPECT_EQ(read(kTwo, "can1"), "002# ");
  EXPECT_EQ(read(kTwo),
            "001# x.log:2: expected the interface can0 of the lines before, unless --of names one, got "
            "\"(2.0) can1 002#\"");
}

TEST_F(LogReaderTest, ReadsRecordingsWithWhoHasSent) {
  fakes::RecordingBytes recording{R"({"wall_clock_ns": 1000000000})"};
  const canopen::Frame frame{.id = 0x585, .length = 1, .data = {0x43}};
  recording.add(record::frame_record(frame, true, std::chrono::milliseconds{5}).bytes());
  recording.add(record::lost_record(12, std::chrono::milliseconds{6}).bytes());
  recording.add(record::frame_record(frame, false, std::chrono::milliseconds{7}).bytes());
  auto log = *LogReader::open(logs.write("x.axrec", recording.bytes()));
  const auto first = *log->next(), second = *log->next();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->sender, runs::Sender::Unit);
  EXPECT_EQ(first->at, std::chrono::milliseconds{1005});
  EXPECT_EQ(second->sender, runs::Sender::Others);
  EXPECT_FALSE(*log->next());
  EXPECT_EQ(log->lost(), 12U);
  EXPECT_FALSE(log->remark().empty()) << "it does not say that it ends";
}

TEST_F(LogReaderTest, RefusesARecordingThatIsDamaged) {
  const auto log = LogReader::open(logs.write("x.axrec", std::string{record::kMagic} + "none"));
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().status, ExitStatus::Damaged);
}

TEST_F(LogReaderTest, SaysWhatIsNotThere) {
  const auto log = LogReader::open(logs.path("none.log"));
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().status, ExitStatus::NotThere);
  EXPECT_EQ(LogReader::open(logs.path("")).error().status, ExitStatus::NotThere) << "a folder";
}

TEST_F(LogReaderTest, TellsGapsAndTimesThatAreWrong) {
  EXPECT_EQ(remarks("(1.0) can0 605#40\n(4.5) can0 605#40\n(4.5) can0 605#40\n(4.4) can0 605#40\n"),
            (std::vector<std::string>{
                "x.log:2: a gap of more than 2 s without a frame, the longest of 3.500 s before here",
                "x.log: 1 of 4 frames have the time stamp of the frame before",
                "x.log:4: the time goes back here: such frames go out right behind the one before"}));
  EXPECT_TRUE(remarks("(1.0) can0 605#40\n(1.5) can0 605#40\n").empty());
}

TEST_F(LogReaderTest, TellsThatThereAreNoTimes) {
  EXPECT_EQ(
      remarks(" can0  605   [1]  40\n"),
      (std::vector<std::string>{"x.log: the log has no time stamps: each frame goes out behind the answers to "
                                "those before it, and no time is compared"}));
}

TEST_F(LogReaderTest, TellsALogThatIsTooDenseForTheBitRate) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += fmt::format("({:.6f}) can0 181#1122334455667788\n", 1.0 + i * 0.00015);
  EXPECT_TRUE(remarks(text, 1'000'000).empty());
  const auto said = remarks(text, 500'000);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said.front().find("more than the 500 kbit/s of the bus: the log is of another bit rate"),
            std::string::npos)
      << said.front();
}

TEST_F(LogReaderTest, RefusesALogWithoutFrames) {
  EXPECT_EQ(remarks("\n\n"), (std::vector<std::string>{"x.log: there is no frame in it"}));
}

}  // namespace
}  // namespace runs_test
