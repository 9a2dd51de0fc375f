// Sources of BICO inputs in a configuration.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/daemon/configuration/command_line.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

TEST(BicoSource, IsTakenAsText) {
  const Configuration configuration = parse_configuration(R"({
    "parameters": {"p2103": "r0899.2 of axis 2"},
    "axes": [{"parameters": {
      "p0840": "r8890.0", "p0844": "1", "p0848": 0, "p0852": "r0899.2 of axis 2",
      "p1055": "r0899.2 of drive object 3", "p1070": "r8860[1]", "p1155": "r8850", "p1085": "1"}}, {}]})",
                                                          "node.json");

  const auto value_of = [&](std::uint16_t number) {
    for (const ParameterValue& value : configuration.axes[0].parameters)
      if (value.number == number) return static_cast<std::uint32_t>(value.value);
    return ~0U;
  };
  EXPECT_EQ(value_of(840), 0x22BAFC00U);
  EXPECT_EQ(value_of(844), 1U);
  EXPECT_EQ(value_of(848), 0U);
  EXPECT_EQ(value_of(852), 0x03830C02U);
  EXPECT_EQ(value_of(1055), 0x03830C02U);
  EXPECT_EQ(value_of(1070), 0x229CFC01U);
  EXPECT_EQ(value_of(1155), 0x2292FC00U);
  EXPECT_EQ(value_of(1085), 1U);
  ASSERT_EQ(configuration.parameters.size(), 1U);
  EXPECT_EQ(static_cast<std::uint32_t>(configuration.parameters[0].value), 0x03830C02U);
}

const std::string kBinector = "a binector that exists, such as \"r8890.0\" or \"r0899.2 of axis 2\", or 0 or 1";
const std::string kConnector =
    "a connector that exists, such as \"r8860[1]\" or \"r0063[0] of axis 2\", or 0 or 1";

/// p0840 of the first of two axes, which is given @p value.
std::string with_on(const std::string& value) {
  return R"({"axes": [{"parameters": {"p0840": )" + value + "}}, {}]}";
}

TEST(BicoSource, OfAnInputIsRefusedInOneLineUnlessItExists) {
  for (const char* const value : {R"("r8890.16")",
                                  R"("r8890[0]")",
                                  R"("r9999.0")",
                                  R"("r0063.0")",
                                  R"("8890.0")",
                                  R"("r8890.0 of axis 3")",
                                  R"("r8890.0 of axis")",
                                  R"("r8890.0 of axis 0")",
                                  R"("r8890.0 of axis 9")",
                                  R"("r8890.0 ")",
                                  R"("ON")",
                                  R"("")",
                                  R"("2")",
                                  "2",
                                  "-1",
                                  "0.5",
                                  "4294967296",
                                  "true",
                                  "[]",
                                  "null"}) {
    EXPECT_EQ(message_of([&] { parse_configuration(with_on(value), "node.json"); }),
              "node.json: /axes/0/parameters/p0840: expected " + kBinector + ", got " + value);
  }
  EXPECT_EQ(message_of([] {
              parse_configuration(R"({"axes": [{"parameters": {"p1070[0]": "r8860.1"}}]})", "node.json");
            }),
            "node.json: /axes/0/parameters/p1070[0]: expected " + kConnector + ", got \"r8860.1\"");
  EXPECT_EQ(message_of([] { parse_configuration(R"({"parameters": {"p2103": "on"}})", "node.json"); }),
            "node.json: /parameters/p2103: expected " + kBinector + ", got \"on\"");
}

TEST(BicoSource, OnAnAxisThatTheCommandLineTakesAwayIsRefused) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("node.json")} << with_on(R"("r0899.2 of axis 2")");

  EXPECT_EQ(configuration_of({"--config", folder.path("node.json")}).axes.size(), 2U);
  EXPECT_EQ(message_of([&] {
              configuration_of({"--config", folder.path("node.json"), "--axes", "1"});
            }),
            "--axes: expected the axis that p0840[0] of axis X is connected to, got 1");
}

}  // namespace
}  // namespace axisd
