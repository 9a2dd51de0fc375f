#include "tools/canrec/frames/time_range.hpp"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using canrec::Moment;
using canrec::read_moment;
using canrec::TimeRange;
using Place = TimeRange::Place;

constexpr auto kFirst = 1700000000s;

TEST(Moment, IsBehindTheFirstFrameOrOnTheClock) {
  EXPECT_EQ(read_moment("12.5"), (Moment{12500ms, false}));
  EXPECT_EQ(read_moment("0"), (Moment{0s, false}));
  EXPECT_EQ(read_moment("@1700000000.123456"), (Moment{kFirst + 123456us, true}));
  for (const char* const text : {"", "@", "-1", "1s", "1.", "now", "1e3", "12.5 "})
    EXPECT_FALSE(read_moment(text)) << text;
}

TEST(TimeRange, HasItsBeginningAndNotItsEnd) {
  const TimeRange range{.from = Moment{1s}, .to = Moment{3s}};
  EXPECT_EQ(range.place_of(kFirst + 999ms, kFirst), Place::Before);
  EXPECT_EQ(range.place_of(kFirst + 1s, kFirst), Place::Within);
  EXPECT_EQ(range.place_of(kFirst + 2999ms, kFirst), Place::Within);
  EXPECT_EQ(range.place_of(kFirst + 3s, kFirst), Place::Behind);
}

TEST(TimeRange, TakesTimeStamps) {
  const TimeRange range{.from = *read_moment("@1700000001.000001"), .to = {}};
  EXPECT_EQ(range.place_of(kFirst + 1s, kFirst), Place::Before);
  EXPECT_EQ(range.place_of(kFirst + 1000001us, kFirst), Place::Within);
}

TEST(TimeRange, IsAllIfNothingIsSaid) {
  EXPECT_EQ(TimeRange{}.place_of(0s, kFirst), Place::Within);
}

}  // namespace
