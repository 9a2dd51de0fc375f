#include "tests/fakes/candump.hpp"

#include <gtest/gtest.h>

using fakes::candump;
using fakes::frame_of;

TEST(Candump, WritesWhatItReads) {
  for (const char* const text : {"605#4000100000000000", "705#7F", "080#", "705#R", "705#R1", "18FF1234#0102"}) {
    EXPECT_EQ(candump(frame_of(text)), text);
  }
}

TEST(Candump, ReadsDotsBetweenBytes) {
  EXPECT_EQ(frame_of("000#01.05"), frame_of("000#0105"));
}

TEST(Candump, RefusesWhatIsNoFrame) {
  for (const char* const text : {"605", "605#4", "605#XY", "605#000102030405060708", "zz#00"}) {
    EXPECT_THROW((void)frame_of(text), std::invalid_argument) << text;
  }
}
