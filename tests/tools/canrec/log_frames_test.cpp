#include "tools/canrec/frames/log_frames.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/fakes/temporary_directory.hpp"

namespace {

using canrec::LogFrames;
using canrec::Status;

/// A log in a file.
class LogFramesTest : public testing::Test {
 protected:
  std::string write(std::string_view text) {
    const std::string path = folder_.path("x.log");
    std::ofstream{path, std::ios::binary} << text;
    return path;
  }
  /// Identifiers of the frames, and how it has ended.
  std::string read(std::string_view text, const std::string& interface = {}, LogFrames::OnDamage on_damage = {}) {
    auto log = LogFrames::open(write(text), interface, std::move(on_damage));
    if (!log) return log.error().text;
    std::string found;
    for (;;) {
      const auto frame = (*log)->next();
      if (!frame) return found + frame.error().text.substr(folder_.path("x.log").size() - 5);
      if (!*frame) return found + "end";
      found += std::to_string((*frame)->frame.can_id) + " ";
    }
  }

  fakes::TemporaryDirectory folder_;
};

TEST_F(LogFramesTest, GivesEveryFrame) {
  EXPECT_EQ(read("(1.0) can0 001#\n(2.0) can0 002#11\r\n\n  \n(3.0) can0 003#R\n"), "1 2 1073741827 end");
  EXPECT_EQ(read("(1.0) can0 001#\n(2.0) can0 002#11"), "1 2 end") << "without an end of line";
  EXPECT_EQ(read(""), "end");
}

TEST_F(LogFramesTest, SaysWhichLineIsDamaged) {
  constexpr const char* kCut =
      "1 x.log:2: expected a frame as 123#1122, 12345678#1122 or 123#R behind the interface, "
      "got \"(2.0) can0\"";
  EXPECT_EQ(read("(1.0) can0 001#\n(2.0) can0"), kCut);
  EXPECT_EQ(read("(1.0) can0 001#\n(2.0) can0\n(3.0) can0 003#\n"), kCut);
}

TEST_F(LogFramesTest, ShowsNothingThatATerminalObeys) {
  EXPECT_EQ(read("\x1b[2Jhello\n"),
            "x.log:1: expected (SECONDS.MICROSECONDS) at the beginning, got \"?[2Jhello\"");
  EXPECT_EQ(read(std::string("(1.0) can0 001#\0\0\n", 18)),
            "x.log:1: expected at most 8 bytes of two hexadecimal digits behind #, got \"(1.0) can0 001#??\"");
}

TEST_F(LogFramesTest, LooksAtNoLineThatIsTooLong) {
  const std::string line(1'000'000, 'x');
  EXPECT_EQ(read("(1.0) can0 001#\n" + line + "\n"),
            "1 x.log:2: expected a line of at most 256 characters, got \"" + std::string(50, 'x') + "...\"");
}

TEST_F(LogFramesTest, GoesOnBehindDamage) {
  std::vector<std::string> told;
  const auto on_damage = [&told](std::string_view line) { told.emplace_back(line); };

  EXPECT_EQ(read("x\n(1.0) can0 001#\n" + std::string(300, 'y') + "\n(2.0) can0 002#\n(3.", {}, on_damage),
            "1 2 end");

  ASSERT_EQ(told.size(), 3U);
  EXPECT_NE(told[2].find("x.log:5: expected"), std::string::npos) << told[2];
}

TEST_F(LogFramesTest, HasOneInterface) {
  constexpr const char* kTwo = "(1.0) can0 001#\n(2.0) can1 002#\n(3.0) can0 003#\n";
  EXPECT_EQ(read(kTwo),
            "1 x.log:2: expected the interface can0 of the lines before, unless --interface names one, got "
            "\"(2.0) can1 002#\"");
  EXPECT_EQ(read(kTwo, "can0"), "1 3 end");
  EXPECT_EQ(read(kTwo, "can1"), "2 end");
  EXPECT_EQ(read(kTwo, "can2"), "end");
}

TEST_F(LogFramesTest, OpensRegularFilesOnly) {
  const auto missing = LogFrames::open(folder_.path("none"), {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().status, Status::Failed);
  EXPECT_EQ(missing.error().text, folder_.path("none") + ": No such file or directory");
  const auto directory = LogFrames::open(folder_.path(), {});
  ASSERT_FALSE(directory);
  EXPECT_EQ(directory.error().text, folder_.path() + ": expected a log of candump, this is no regular file");
}

}  // namespace
