#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

/// Text of a motor file and the message it earns, without the name of the file.
class BadMotorFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadMotorFiles, AreRefusedWithFilePlaceAndExpectation) {
  const fakes::TemporaryDirectory folder;
  const std::string file = folder.path("motor.json");
  std::ofstream{file} << GetParam().text;
  const std::string text = R"({"axes": [{"motor": ")" + file + R"("}]})";

  EXPECT_EQ(message_of([&] { parse_configuration(text, "node.json"); }),
            file + ": " + std::string{GetParam().message});
}

INSTANTIATE_TEST_SUITE_P(
    Motor, BadMotorFiles,
    testing::Values(
        BadFile{"{", "line 1, column 2: expected valid JSON"}, BadFile{"7", "/: expected an object, got 7"},
        BadFile{R"({"inertia_kgm2": 0})", "/inertia_kgm2: expected a number above 0, got 0"},
        BadFile{R"({"rated_speed_rpm": "fast"})", "/rated_speed_rpm: expected a number, got \"fast\""},
        BadFile{R"({"stator_resistance_ohm": -0.5})",
                "/stator_resistance_ohm: expected a number above 0, got -0.5"},
        BadFile{R"({"q_inductance_mH": 0})", "/q_inductance_mH: expected a number above 0, got 0"},
        BadFile{R"({"pole_pairs": 0})", "/pole_pairs: expected an integer 1 to 255, got 0"},
        BadFile{R"({"rated_speed_rpm": 9000})",
                "/rated_speed_rpm: expected not more than the maximum speed, got 9000"},
        BadFile{R"({"maximum_speed_rpm": 1000})",
                "/: expected a value for rated_speed_rpm that is not more than the maximum speed, got "
                "{\"maximum_speed_rpm\":1000}"},
        BadFile{R"({"rated_current_A": 50})",
                "/rated_current_A: expected not more than the maximum current, got 50"},
        BadFile{R"({"winding_capacity_J_per_K": 0})",
                "/winding_capacity_J_per_K: expected a number above 0, got 0"},
        BadFile{R"({"d_inductance_mH": 1e-6})",
                "/: expected a value for stator_resistance_ohm that is a resistance with an electrical time "
                "constant above 10 us, got {\"d_inductance_mH\":1e-06}"},
        BadFile{R"({"type": "reluctance"})", "/type: expected synchronous or induction, got \"reluctance\""},
        BadFile{R"({"type": "induction", "pole_pairs": 2})",
                "/: expected the key rated_current_A, since there is a type, got {\"pole_pairs\":2,\"type\":"
                "\"induction\"}"},
        BadFile{R"({"source": 1})", "/source: expected a string, got 1"},
        BadFile{R"({"encoder": {"fine_bits": 1}})", "/encoder/fine_bits: expected an integer 2 to 18, got 1"}));

TEST(MotorFile, WithAnUnknownKeyIsToldAllKeys) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("motor.json")} << R"({"poles": 4})";

  const std::string message = message_of([&] {
    parse_configuration(R"({"axes": [{"motor": ")" + folder.path("motor.json") + R"("}]})", "node.json");
  });

  EXPECT_EQ(message.find(folder.path("motor.json") + ": /poles: unknown key, expected one of: description, "), 0U);
  for (const char* const key : {"pole_pairs", "rated_speed_rpm", "inertia_kgm2", "encoder"})
    EXPECT_NE(message.find(key), std::string::npos) << key;
}

}  // namespace
}  // namespace axisd
