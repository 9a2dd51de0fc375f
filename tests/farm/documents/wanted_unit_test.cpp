#include "farm/documents/wanted_unit.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

std::string error_of(std::string_view text) {
  const auto unit = parse_wanted_unit("line1.5", text);
  return unit ? "" : unit.error();
}

TEST(WantedUnit, HasAConfigurationAndPerhapsHosts) {
  const auto anywhere = parse_wanted_unit("line1.5", R"({"configuration": {"axes": [{}, {}]}})");
  const auto at_one = parse_wanted_unit("line1.5", R"({"configuration": {}, "host": "a"})");
  const auto at_some = parse_wanted_unit("line1.5", R"({"configuration": {}, "host": ["a", "b"]})");

  ASSERT_TRUE(anywhere && at_one && at_some);
  EXPECT_EQ(anywhere->configuration.at("axes").size(), 2u);
  EXPECT_TRUE(anywhere->allows("c"));
  EXPECT_TRUE(at_one->allows("a"));
  EXPECT_FALSE(at_one->allows("b"));
  EXPECT_TRUE(at_some->allows("b"));
  EXPECT_FALSE(at_some->allows("c"));
}

TEST(WantedUnit, IsWrittenAsItIsRead) {
  for (const char* const text : {R"({"configuration":{"axes":[{}]}})", R"({"configuration":{},"host":"a"})",
                                 R"({"configuration":{},"host":["a","b"]})"})
    EXPECT_EQ(text_of(parse_wanted_unit("line1.5", text).value()), text);
}

TEST(WantedUnit, SaysInOneLineWhatIsWrong) {
  EXPECT_EQ(error_of("{"), "line1.5: line 1, column 2: expected valid JSON");
  EXPECT_EQ(error_of("[]"), "line1.5: expected an object, got []");
  EXPECT_EQ(error_of("{}"), "line1.5: configuration: expected an object, got nothing");
  EXPECT_EQ(error_of(R"({"configuration": 5})"), "line1.5: configuration: expected an object, got 5");
  EXPECT_EQ(error_of(R"({"configuration": {}, "host": 5})"),
            "line1.5: host: expected a name of 1 to 32 letters, digits, '-' and '_', or a list of them, got 5");
  EXPECT_EQ(error_of(R"({"configuration": {}, "host": []})"),
            "line1.5: host: expected a name of 1 to 32 letters, digits, '-' and '_', or a list of them, got []");
  EXPECT_EQ(error_of(R"({"configuration": {}, "hosts": "a"})"),
            "line1.5: hosts: expected only configuration, host, got \"a\"");
}

TEST(WantedUnit, LeavesToItsKeyWhatThatSays) {
  EXPECT_EQ(error_of(R"({"configuration": {"node_id": 5}})"),
            "line1.5: configuration: expected an object without node_id, got {\"node_id\":5}");
  EXPECT_NE(error_of(R"({"configuration": {"units": []}})"), "");
}

}  // namespace
}  // namespace farm
