#include "farm/documents/settings.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

TEST(BusSettings, HaveABitRateOrNone) {
  EXPECT_EQ(parse_bus_settings("line1", R"({"bitrate": 500000})"), BusSettings{500'000});
  EXPECT_EQ(parse_bus_settings("line1", "{}"), BusSettings{0});
  EXPECT_EQ(parse_bus_settings("line1", text_of(BusSettings{125'000})), BusSettings{125'000});
  EXPECT_EQ(parse_bus_settings("line1", R"({"bitrate": 5})").error(),
            "line1: bitrate: expected 0, or 1000 to 1000000, got 5");
  EXPECT_EQ(parse_bus_settings("line1", R"({"bit_rate": 5})").error(),
            "line1: bit_rate: expected only bitrate, got 5");
}

TEST(HostSettings, SayWhetherItGivesItsUnitsAway) {
  EXPECT_EQ(parse_host_settings("a", R"({"drain": true})"), HostSettings{true});
  EXPECT_EQ(parse_host_settings("a", "{}"), HostSettings{false});
  EXPECT_EQ(parse_host_settings("a", text_of(HostSettings{true})), HostSettings{true});
  EXPECT_EQ(parse_host_settings("a", R"({"drain": 1})").error(), "a: drain: expected true or false, got 1");
}

}  // namespace
}  // namespace farm
