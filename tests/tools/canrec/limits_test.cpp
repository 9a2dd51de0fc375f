#include "tools/canrec/commands/limits.hpp"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using canrec::read_age;
using canrec::read_bytes;
using canrec::read_speed;

TEST(Limits, ReadsTimes) {
  EXPECT_EQ(read_age("90"), 90s);
  EXPECT_EQ(read_age("0.5s"), 500ms);
  EXPECT_EQ(read_age("15m"), 15min);
  EXPECT_EQ(read_age("12h"), 12h);
  EXPECT_EQ(read_age("7d"), 7 * 24h);
  for (const char* const text : {"", "0", "-1", "m", "1w", "1 m", "9000000000d"})
    EXPECT_FALSE(read_age(text)) << text;
}

TEST(Limits, ReadsBytes) {
  EXPECT_EQ(read_bytes("0"), 0);
  EXPECT_EQ(read_bytes("500000"), 500000);
  EXPECT_EQ(read_bytes("2k"), 2048);
  EXPECT_EQ(read_bytes("100M"), 100 * 1024 * 1024);
  EXPECT_EQ(read_bytes("2G"), 2LL * 1024 * 1024 * 1024);
  for (const char* const text : {"", "-1", "k", "1K", "1.5G", "9999999999G"})
    EXPECT_FALSE(read_bytes(text)) << text;
}

TEST(Limits, ReadsSpeeds) {
  EXPECT_EQ(read_speed("1"), 1.0);
  EXPECT_EQ(read_speed("0.25"), 0.25);
  EXPECT_EQ(read_speed("1000000"), 1e6);
  for (const char* const text : {"", "0", "0.0", "-1", "nan", "inf", "2x", "1e7"})
    EXPECT_FALSE(read_speed(text)) << text;
}

}  // namespace
