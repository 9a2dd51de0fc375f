#include "gateway/live/line_ring.hpp"

#include <gtest/gtest.h>

#include "gateway/live/cursor.hpp"

namespace gateway {
namespace {

using namespace std::chrono_literals;

/// What is behind number @p after, and behind '|' how many are no longer kept.
std::string behind(const LineRing& ring, std::uint64_t after) {
  std::string text;
  const std::uint64_t lost = ring.copy_behind(after, text);
  return text + '|' + std::to_string(lost);
}

TEST(LineRing, TellsWhatIsBehindALine) {
  LineRing ring;
  EXPECT_EQ(ring.last(), 0U);
  EXPECT_EQ(behind(ring, 0), "|0");
  for (const char* const text : {"a", "b", "c"}) ring.push(text, 0ms);
  EXPECT_EQ(ring.last(), 3U);
  EXPECT_EQ(behind(ring, 0), "a,b,c|0");
  EXPECT_EQ(behind(ring, 2), "c|0");
  EXPECT_EQ(behind(ring, 3), "|0");
  EXPECT_EQ(behind(ring, 4), "|0");
}

TEST(LineRing, CountsWhatIsTooOld) {
  LineRing ring;
  ring.push("a", 0ms);
  ring.push("b", 1000ms);
  ring.forget(LineRing::kLongest);
  EXPECT_EQ(behind(ring, 0), "a,b|0");
  ring.forget(LineRing::kLongest + 1ms);
  EXPECT_EQ(behind(ring, 0), "b|1");
  EXPECT_EQ(behind(ring, 1), "b|0");
  ring.push("c", LineRing::kLongest + 1001ms);
  EXPECT_EQ(behind(ring, 0), "c|2");
  ring.forget(LineRing::kLongest * 3);
  EXPECT_EQ(behind(ring, 0), "|3");
  EXPECT_EQ(behind(ring, 2), "|1");
  EXPECT_EQ(ring.last(), 3U);
}

TEST(LineRing, CountsWhatIsTooMuch) {
  LineRing ring;
  const std::string half(LineRing::kMostBytes / 2, 'x');
  ring.push(half, 0ms);
  ring.push(half, 0ms);
  EXPECT_EQ(behind(ring, 0), half + ',' + half + "|0");
  ring.push("c", 0ms);
  EXPECT_EQ(behind(ring, 0), half + ",c|1");
}

TEST(Cursor, IsReadAsItIsWritten) {
  for (const Cursor& cursor : {Cursor{{1, 0}}, Cursor{{0xfedcba9876543210, 17}, {2, 18446744073709551615U}}})
    EXPECT_EQ(parse_cursor(text_of(cursor)), cursor) << text_of(cursor);
  EXPECT_EQ(text_of({{0xabc, 5}, {0xabd, 0}}), "0000000000000abc.5_0000000000000abd.0");
}

TEST(Cursor, IsNothingElse) {
  for (const char* const text :
       {"", "_", "5", "0000000000000abc", "0000000000000abc.", "0000000000000abc.x", "abc.5",
        "0000000000000abc.-1", "0000000000000abc.5_", "_0000000000000abc.5", "0000000000000abg.5",
        "0000000000000abc.18446744073709551616", "0000000000000abc.5 ",
        "0000000000000abc.5_0000000000000abc.5_0000000000000abc.5"})
    EXPECT_FALSE(parse_cursor(text).has_value()) << text;
}

}  // namespace
}  // namespace gateway
