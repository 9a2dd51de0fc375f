#include "tools/canrec/frames/transcript.hpp"

#include <gtest/gtest.h>

#include "can/hub/trunk/message.hpp"
#include "tests/can/hub/told.hpp"

namespace {

using namespace std::chrono_literals;
using canrec::TimedFrame;
using canrec::Transcript;
using hub::trunk::Header;
using hub::trunk::Kind;
using hub::trunk::Writer;

constexpr std::chrono::nanoseconds kStart = 1700000000s;

/// What hubs tell, one message after the other.
class TranscriptTest : public testing::Test {
 protected:
  /// A message with @p frames, which the stream takes in at @p at.
  void frames(Header header, std::chrono::nanoseconds at, std::initializer_list<const char*> frames) {
    if (header.origin == 0) header.origin = header.hub;
    Writer writer;
    writer.begin(header);
    auto number = static_cast<std::uint32_t>(header.counter);
    for (const char* const frame : frames) writer.add({told::wire(frame), number++});
    take(writer, at);
  }
  void beat(Header header, std::chrono::nanoseconds at) {
    header.kind = Kind::Beat;
    Writer writer;
    writer.begin(header);
    writer.add_name("a hub");
    take(writer, at);
  }
  /// A frame that the arbiter of @p term lets pass, which ended at @p end.
  void grant(std::uint32_t term, std::uint64_t counter, const char* frame, std::chrono::nanoseconds end) {
    Writer writer;
    writer.begin({.kind = Kind::Granted, .hub = 1, .origin = 1, .counter = counter, .term = term});
    writer.add_granted({told::wire(frame), static_cast<std::uint32_t>(counter)}, (kStart + end).count());
    take(writer, end + 1ms);
  }
  void arbiter(std::uint32_t term, std::chrono::nanoseconds at) {
    Writer writer;
    writer.begin({.kind = Kind::ArbiterBeat, .hub = 9, .counter = 1, .term = term, .detail = 125000});
    take(writer, at);
  }
  /// All that have passed, as text.
  std::string passed() const {
    std::string text;
    for (const TimedFrame& each : passed_) text += told::text_of(each.frame) + " ";
    return text;
  }

  void take(Writer& writer, std::chrono::nanoseconds at) {
    transcript_.take({.bytes = writer.finish(), .sequence = ++sequence_, .at = kStart + at}, passed_);
  }

  Transcript transcript_;
  std::vector<TimedFrame> passed_;
  std::uint64_t sequence_ = 0;
};

TEST_F(TranscriptTest, HasTheFramesOfAllHubsInOrder) {
  beat({.hub = 1, .epoch = 1, .counter = 1}, 0ms);
  frames({.hub = 1, .epoch = 1, .counter = 1}, 1ms, {"123#11", "124#22"});
  frames({.hub = 2, .epoch = 3, .counter = 700}, 2ms, {"12345678#R"});
  frames({.hub = 1, .epoch = 1, .counter = 3}, 3ms, {"125#"});

  EXPECT_EQ(passed(), "123#11 124#22 12345678#R 125# ");
  EXPECT_EQ(passed_[1].at, kStart + 1ms);
  EXPECT_EQ(passed_[2].at, kStart + 2ms);
  EXPECT_EQ(transcript_.text(), "4 frames, none missed");
}

TEST_F(TranscriptTest, HasWhatTheArbiterLetsPassAndItsTime) {
  grant(7, 4, "123#11", 3ms);  // whose term that is has not been said yet
  arbiter(7, 5ms);
  grant(7, 5, "124#22", 6ms);

  EXPECT_EQ(passed(), "123#11 124#22 ");
  EXPECT_EQ(passed_[1].at, kStart + 6ms);
  EXPECT_EQ(transcript_.text(), "2 frames, none missed");
}

TEST_F(TranscriptTest, LeavesOutWhatComesFromAnArbiterThatIsItNoMore) {
  arbiter(7, 0ms);
  grant(7, 4, "001#", 1ms);
  arbiter(8, 3ms);
  grant(7, 5, "002#", 4ms);
  grant(8, 5, "003#", 6ms);

  EXPECT_EQ(passed(), "001# 003# ");
  EXPECT_EQ(transcript_.text(), "2 frames, none missed; 1 late");
}

TEST_F(TranscriptTest, CountsNumbersThatAreLeftOut) {
  frames({.hub = 1, .counter = 1}, 0ms, {"001#"});
  frames({.hub = 1, .counter = 4}, 1ms, {"004#"});
  frames({.hub = 1, .counter = 5}, 2ms, {"005#"});
  beat({.hub = 1, .counter = 10}, 3ms);

  EXPECT_EQ(passed(), "001# 004# 005# ");
  EXPECT_EQ(transcript_.text(), "3 frames, 6 missed in 2 gaps");
}

TEST_F(TranscriptTest, LeavesOutWhatIsLate) {
  const std::int64_t seen = (kStart).count();
  frames({.hub = 1, .counter = 1, .seen = seen}, 500ms, {"001#"});
  frames({.hub = 1, .counter = 2, .seen = seen}, 501ms, {"002#", "003#"});
  frames({.hub = 1, .counter = 4, .seen = seen + 100'000'000}, 502ms, {"004#"});

  EXPECT_EQ(passed(), "001# 004# ");
  EXPECT_EQ(transcript_.text(), "2 frames, none missed; 2 late");
}

TEST_F(TranscriptTest, LeavesOutWhatComesBehindTheReturnOfItsHub) {
  frames({.hub = 1, .epoch = 1, .counter = 1}, 0ms, {"001#"});
  beat({.hub = 1, .epoch = 2, .counter = 3}, 1ms);
  frames({.hub = 1, .epoch = 1, .counter = 2}, 2ms, {"002#"});
  frames({.hub = 1, .epoch = 2, .counter = 3}, 3ms, {"003#"});

  EXPECT_EQ(passed(), "001# 003# ");
  EXPECT_EQ(transcript_.text(), "2 frames, 1 missed in 1 gap; 1 late");
}

TEST_F(TranscriptTest, LeavesOutWhatIsRepeated) {
  frames({.hub = 1, .counter = 1}, 0ms, {"001#", "002#"});
  frames({.hub = 1, .counter = 1}, 1ms, {"001#", "002#"});
  frames({.hub = 1, .counter = 2}, 2ms, {"002#", "003#"});

  EXPECT_EQ(passed(), "001# 002# 003# ");
  EXPECT_EQ(transcript_.text(), "3 frames, none missed; 3 repeated");
}

TEST_F(TranscriptTest, LeavesOutWhatABridgeBringsASecondTime) {
  frames({.hub = 1, .origin = 9, .counter = 5}, 0ms, {"001#"});
  frames({.hub = 2, .origin = 9, .counter = 5}, 1ms, {"001#"});

  EXPECT_EQ(passed(), "001# ");
  EXPECT_EQ(transcript_.text(), "1 frames, none missed; 1 repeated");
}

TEST_F(TranscriptTest, CountsWhatIsNoMessageOfAHub) {
  const std::array<std::byte, 3> noise{};
  transcript_.take({.bytes = noise, .sequence = 1, .at = kStart}, passed_);
  transcript_.take({.bytes = {}, .sequence = 2, .at = kStart}, passed_);
  frames({.hub = 1, .counter = 1}, 1ms, {"001#"});

  EXPECT_EQ(passed(), "001# ");
  EXPECT_EQ(transcript_.text(), "1 frames, none missed; 2 messages that are none of a hub");
}

TEST_F(TranscriptTest, HasErrorFrames) {
  Writer writer;
  writer.begin({.hub = 1, .origin = 1, .counter = 1});
  can_frame error{};
  error.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL;
  error.len = CAN_ERR_DLC;
  writer.add({error, 1});
  take(writer, 0ms);

  ASSERT_EQ(passed_.size(), 1U);
  EXPECT_EQ(passed_[0].frame.can_id, CAN_ERR_FLAG | CAN_ERR_CRTL);
}

TEST_F(TranscriptTest, HasTheTimesOfALog) {
  Writer writer;
  writer.begin({.hub = 1, .epoch = 1, .origin = 1, .counter = 1});
  writer.add({told::wire("123#"), 1});

  transcript_.take({.bytes = writer.finish(), .sequence = 1, .at = kStart, .log_time = 5s}, passed_);

  ASSERT_EQ(passed_.size(), 1U);
  EXPECT_EQ(passed_[0].at, 5s);
}

}  // namespace
