#include "can/hub/medium/bit_time.hpp"

#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/can/hub/told.hpp"

namespace {

using hub::arbitration_field;
using hub::bits_on_wire;
using told::wire;

/// What the independent script says, one line "FRAME BITS" a frame; empty if it failed.
std::string ask_script(const std::string& arguments) {
  const std::string command = std::string{"python3 " BIT_TIME_SCRIPT " "} + arguments;
  FILE* const output = popen(command.c_str(), "r");
  std::string text;
  char part[4096];
  for (std::size_t size = 0; output != nullptr && (size = std::fread(part, 1, sizeof part, output)) > 0;)
    text.append(part, size);
  return output != nullptr && pclose(output) == 0 ? text : "";
}

void expect_equal_to_script(const std::string& arguments) {
  std::istringstream lines{ask_script(arguments)};
  std::string frame;
  unsigned bits = 0;
  unsigned count = 0;
  for (; lines >> frame >> bits; ++count) ASSERT_EQ(bits_on_wire(wire(frame)), bits) << frame;
  EXPECT_GT(count, 1000u) << "python3 " BIT_TIME_SCRIPT " failed; scripts/setup.sh installs what it needs";
}

TEST(BitsOnWire, AreThoseOfAnIndependentScriptForExtremeAndChosenFrames) {
  expect_equal_to_script("--seed 1");
}

TEST(BitsOnWire, AreThoseOfAnIndependentScriptForRandomFrames) {
  const std::string seed = std::to_string(told::seed());
  SCOPED_TRACE("seed " + seed);
  RecordProperty("seed", seed);

  expect_equal_to_script("--seed " + seed);
}

TEST(BitsOnWire, LieBetweenTheLengthWithoutStuffingAndTheLargestPossible) {
  // 47 + 8n bits without stuffing, a stuff bit for each four of the 34 + 8n - 1 behind the first of those stuffed.
  EXPECT_GE(bits_on_wire(wire("555#5555555555555555")), 111u);
  EXPECT_LE(bits_on_wire(wire("000#0000000000000000")), 135u);
  // 67 + 8n, and 54 + 8n - 1
  EXPECT_GE(bits_on_wire(wire("15555555#5555555555555555")), 131u);
  EXPECT_LE(bits_on_wire(wire("00000000#0000000000000000")), 160u);
}

TEST(BitsOnWire, OfARemoteFrameDoNotGrowWithTheLengthItAsksFor) {
  const unsigned shortest = bits_on_wire(wire("705#R"));

  EXPECT_NEAR(bits_on_wire(wire("705#R8")), shortest, 3);
}

TEST(BitsOnWire, OfAnErrorFrameAreFlagDelimiterAndIntermission) {
  can_frame error{};
  error.can_id = CAN_ERR_FLAG | 0x4;
  error.can_dlc = CAN_MAX_DLEN;

  EXPECT_EQ(bits_on_wire(error), 6u + 8u + 3u);
}

TEST(BitsOnWire, TakeALengthAboveEightForEightBytes) {
  can_frame frame = wire("123#0102030405060708");
  frame.can_dlc = 15;

  EXPECT_NEAR(bits_on_wire(frame), bits_on_wire(wire("123#0102030405060708")), 5);
}

TEST(ArbitrationField, OrdersFramesAsTheBusDoes) {
  constexpr const char* kFromHighestPriority[] = {
      "000#",  "000#R", "00000000#", "00000000#R", "00000001#", "0003FFFF#R", "001#",      "080#",
      "080#R", "100#",  "7FE#R",     "7FF#",       "7FF#R",     "1FFC0000#",  "1FFFFFFF#", "1FFFFFFF#R"};
  for (std::size_t i = 0; i + 1 < std::size(kFromHighestPriority); ++i)
    EXPECT_LT(arbitration_field(wire(kFromHighestPriority[i])),
              arbitration_field(wire(kFromHighestPriority[i + 1])))
        << kFromHighestPriority[i] << " against " << kFromHighestPriority[i + 1];
}

TEST(ArbitrationField, IsTheSameWhateverTheData) {
  EXPECT_EQ(arbitration_field(wire("123#00")), arbitration_field(wire("123#FFFF")));
}

}  // namespace
