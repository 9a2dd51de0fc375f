#include "can/hub/medium/origins.hpp"

#include <gtest/gtest.h>

namespace hub {
namespace {

using bus::Mark;

constexpr std::uint32_t kSelf = 1;
constexpr std::uint32_t kOther = 2;

class OriginsTest : public testing::Test {
 protected:
  bool is_new(std::uint32_t number, std::uint32_t hub = kOther) {
    return origins.is_new({.hub = hub, .number = number & Mark::kLargestNumber});
  }

  Origins origins{kSelf};
};

TEST_F(OriginsTest, MarksEachFrameDifferently) {
  EXPECT_EQ(origins.make(), (Mark{.hub = kSelf, .number = 1}));
  EXPECT_EQ(origins.make(), (Mark{.hub = kSelf, .number = 2}));
}

TEST_F(OriginsTest, KnowsItsOwnFramesWhenTheyComeBack) {
  EXPECT_FALSE(origins.is_new(origins.make()));
}

TEST_F(OriginsTest, TakesWhatHasNoMark) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(origins.is_new({}));
}

TEST_F(OriginsTest, TakesEachFrameOfAnotherHubOnce) {
  for (std::uint32_t number = 1; number < 3 * Origins::kWindow; ++number) {
    ASSERT_TRUE(is_new(number)) << number;
    ASSERT_FALSE(is_new(number)) << number;
    ASSERT_FALSE(is_new(number - number / 2 % (Origins::kWindow / 2))) << number;
  }
}

TEST_F(OriginsTest, TakesFramesOutOfOrder) {
  for (const std::uint32_t number : {10u, 12u, 11u, 200u, 14u, 13u}) EXPECT_TRUE(is_new(number)) << number;
  for (const std::uint32_t number : {10u, 12u, 11u, 200u, 14u, 13u}) EXPECT_FALSE(is_new(number)) << number;
}

TEST_F(OriginsTest, GoesOnWhenNumbersBeginAnew) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t number = Mark::kLargestNumber - 500 + i;
    ASSERT_TRUE(is_new(number)) << i;
    ASSERT_FALSE(is_new(number)) << i;
  }
}

TEST_F(OriginsTest, TakesAFrameFarAheadAsWhatComesAfterALoss) {
  EXPECT_TRUE(is_new(1));
  EXPECT_TRUE(is_new(1 + 10 * Origins::kWindow));
  EXPECT_FALSE(is_new(1 + 10 * Origins::kWindow));
  EXPECT_TRUE(is_new(10 * Origins::kWindow)) << "the one before it has not come";
}

TEST_F(OriginsTest, TellsHubsApart) {
  for (std::uint32_t hub = kOther; hub < kOther + Origins::kMost; ++hub) EXPECT_TRUE(is_new(7, hub)) << hub;
  for (std::uint32_t hub = kOther; hub < kOther + Origins::kMost; ++hub) EXPECT_FALSE(is_new(7, hub)) << hub;
}

TEST_F(OriginsTest, ForgetsTheHubThatItHasNotHeardLongest) {
  for (std::uint32_t hub = kOther; hub <= kOther + Origins::kMost; ++hub) EXPECT_TRUE(is_new(7, hub)) << hub;

  EXPECT_FALSE(is_new(7, kOther + 1));
  EXPECT_TRUE(is_new(7, kOther));
}

}  // namespace
}  // namespace hub
