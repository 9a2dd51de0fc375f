#include "farm/documents/place.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

TEST(Place, IsThatOfAnAgent) {
  const auto place = parse_place("line1.5", R"({"host": "a", "instance": 123, "term": 7})");

  ASSERT_TRUE(place);
  EXPECT_EQ(*place, (Place{.host = "a", .instance = 123, .term = 7, .restarts = 0, .problem = ""}));
}

TEST(Place, IsNobodysAndKeepsItsTerm) {
  const Place released{.host = "", .instance = 0, .term = 7, .restarts = 0, .problem = ""};

  EXPECT_EQ(text_of(released), R"({"term":7})");
  EXPECT_EQ(parse_place("line1.5", text_of(released)), released);
}

TEST(Place, SaysWhatIsWrongWithItsUnit) {
  const Place place{.host = "a", .instance = 123, .term = 7, .restarts = 2, .problem = "motor: expected a preset"};

  EXPECT_EQ(parse_place("line1.5", text_of(place)), place);
}

TEST(Place, IsRefusedInOneLine) {
  EXPECT_EQ(parse_place("line1.5", R"({"host": "a b", "term": 1})").error(),
            "line1.5: host: expected a name of 1 to 32 letters, digits, '-' and '_', got \"a b\"");
  EXPECT_EQ(parse_place("line1.5", R"({"host": "a", "instance": -1})").error(),
            "line1.5: instance: expected an integer 0 to 9007199254740991, got -1");
}

}  // namespace
}  // namespace farm
