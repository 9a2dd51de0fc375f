#include "gateway/base/percent.hpp"

#include <gtest/gtest.h>

namespace gateway {
namespace {

using Parts = std::vector<std::string_view>;

TEST(Percent, IsTakenOff) {
  EXPECT_EQ(decoded("p1070%5B1%5d"), "p1070[1]");
  EXPECT_EQ(decoded("2%2Fp1120"), "2/p1120");
  EXPECT_EQ(decoded("%C3%A9"), "é");
  EXPECT_EQ(decoded(""), "");
}

TEST(Percent, ThatIsBrokenOrHidesAControlCharacterIsNone) {
  for (const std::string_view text : {"%", "%2", "%2x", "%-1", "%00", "a%0Ab", "%7f", "a\tb"})
    EXPECT_EQ(decoded(text), std::nullopt) << text;
}

TEST(Percent, SegmentsStandBetweenSlashes) {
  EXPECT_EQ(segments_of("/api/v1"), (Parts{"api", "v1"}));
  EXPECT_EQ(segments_of("/"), (Parts{""}));
  EXPECT_EQ(segments_of("/a//b/"), (Parts{"a", "", "b", ""}));
  EXPECT_EQ(segments_of(""), Parts{});
}

TEST(Percent, ListsHaveCommas) {
  EXPECT_EQ(list_of("a,b"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(list_of("a"), (std::vector<std::string>{"a"}));
  EXPECT_EQ(list_of("a,,b"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(list_of(""), std::vector<std::string>{});
}

}  // namespace
}  // namespace gateway
