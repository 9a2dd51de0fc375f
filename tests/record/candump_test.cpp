#include "record/candump.hpp"

#include <gtest/gtest.h>

namespace record {
namespace {

using namespace std::chrono_literals;

TEST(CandumpLine, IsThatOfTheTool) {
  constexpr auto kTime = 1700000000s + 123456789ns;
  const canopen::Frame data{.id = 0x605, .length = 3, .data = {0x40, 0, 0xAB}};
  const canopen::Frame remote{.id = 0x705, .length = 1, .remote = true};
  const canopen::Frame extended{.id = 0x12ABC, .length = 0, .extended = true};

  EXPECT_EQ(candump_line(data, kTime, "can0"), "(1700000000.123456) can0 605#4000AB\n");
  EXPECT_EQ(candump_line(remote, kTime, "can0"), "(1700000000.123456) can0 705#R1\n");
  EXPECT_EQ(candump_line(extended, kTime, "can0"), "(1700000000.123456) can0 00012ABC#\n");
}

}  // namespace
}  // namespace record
