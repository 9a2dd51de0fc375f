#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/command_line.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

/// The message of the ConfigurationError that @p read throws.
template <class Read>
std::string message_of(const Read& read) {
  try {
    read();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "accepted";
}

/// Text of a configuration file and the whole message it earns.
struct BadFile {
  std::string_view text;
  std::string message;
};
/// How GoogleTest names a case.
void PrintTo(const BadFile& c, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << c.message;
}
class BadFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadFiles, AreRefusedWithFilePlaceAndExpectation) {
  EXPECT_EQ(message_of([] { parse_configuration(GetParam().text, "node.json"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(Syntax, BadFiles,
                         testing::Values(BadFile{"", "node.json: line 1, column 1: expected valid JSON"},
                                         BadFile{R"({"node_id": 5,})",
                                                 "node.json: line 1, column 15: expected valid JSON"},
                                         BadFile{"{\n  \"interface\": \"vcan0\",\n  \"node_id\": oops\n}",
                                                 "node.json: line 3, column 14: expected valid JSON"},
                                         BadFile{"{} {}", "node.json: line 1, column 4: expected valid JSON"},
                                         BadFile{R"({"node_id": 1e999})",
                                                 "node.json: expected valid JSON, got a number that is too large"},
                                         BadFile{"[]", "node.json: /: expected an object, got []"}));

/// What the key "interface" and the option of that name take.
const std::string kForms =
    "a name of 1 to 15 characters without spaces, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
    "socketcand://HOST:PORT/NAME";

INSTANTIATE_TEST_SUITE_P(
    Unit, BadFiles,
    testing::Values(
        BadFile{R"({"nodeid": 5})",
                "node.json: /nodeid: unknown key, expected one of: interface, node_id, axes, sdo_block, f08701"},
        BadFile{R"({"interface": 0})", "node.json: /interface: expected a string, got 0"},
        BadFile{R"({"interface": ""})", "node.json: /interface: expected " + kForms + ", got \"\""},
        BadFile{R"({"interface": "a-rather-long-name"})",
                "node.json: /interface: expected " + kForms + ", got \"a-rather-long-name\""},
        BadFile{R"({"interface": "../x"})", "node.json: /interface: expected " + kForms + ", got \"../x\""},
        BadFile{R"({"interface": "udp-multicast://10.0.0.1:43113"})",
                "node.json: /interface: expected a multicast group, 224.0.0.0 to 239.255.255.255 or [ff00::] to "
                "[ffff:...], got \"udp-multicast://10.0.0.1:43113\""},
        BadFile{R"({"node_id": "5"})", "node.json: /node_id: expected an integer 1 to 127, got \"5\""},
        BadFile{R"({"node_id": 5.5})", "node.json: /node_id: expected an integer 1 to 127, got 5.5"},
        BadFile{R"({"node_id": 0})", "node.json: /node_id: expected an integer 1 to 127, got 0"},
        BadFile{R"({"node_id": 128})", "node.json: /node_id: expected an integer 1 to 127, got 128"},
        BadFile{R"({"node_id": 18446744073709551615})",
                "node.json: /node_id: expected an integer 1 to 127, got 18446744073709551615"},
        BadFile{R"({"sdo_block": 1})", "node.json: /sdo_block: expected true or false, got 1"},
        BadFile{R"({"f08701": "no"})", "node.json: /f08701: expected true or false, got \"no\""},
        BadFile{R"({"axes": {}})", "node.json: /axes: expected an array of 1 to 8, got {}"},
        BadFile{R"({"axes": []})", "node.json: /axes: expected an array of 1 to 8, got []"},
        BadFile{R"({"axes": [{},{},{},{},{},{},{},{},{}]})",
                "node.json: /axes: expected an array of 1 to 8, got [{},{},{},{},{},{},{},{},{}]"}));

INSTANTIATE_TEST_SUITE_P(
    Axis, BadFiles,
    testing::Values(
        BadFile{R"({"axes": [1]})", "node.json: /axes/0: expected an object, got 1"},
        BadFile{R"({"axes": [{"speed": 1}]})",
                "node.json: /axes/0/speed: unknown key, expected one of: name, type, motor, load, parameters"},
        BadFile{R"({"axes": [{"name": 1}]})", "node.json: /axes/0/name: expected a string, got 1"},
        BadFile{R"({"axes": [{"type": "infeed"}]})",
                "node.json: /axes/0/type: expected servo or vector, got \"infeed\""},
        BadFile{R"({"axes": [{"name": "X"}, {"name": "Y"}, {"name": "X"}]})",
                "node.json: /axes/2/name: expected a name that /axes/0 does not have, got \"X\""},
        BadFile{R"({"axes": [{"name": "Y"}, {}]})",
                "node.json: /axes/1: expected a name that /axes/0 does not have, got {}"},
        BadFile{R"({"axes": [{"motor": 1}]})", "node.json: /axes/0/motor: expected a string, got 1"},
        BadFile{R"({"axes": [{"motor": "1fk7"}]})",
                "node.json: /axes/0/motor: expected a motor preset (1fk7063) or the path of a motor file, got "
                "\"1fk7\""},
        BadFile{R"({"axes": [{"motor": "/nowhere/motor.json"}]})",
                "/nowhere/motor.json: cannot be read: No such file or directory"},
        BadFile{R"({"axes": [{"parameters": []}]})", "node.json: /axes/0/parameters: expected an object, got []"},
        BadFile{R"({"axes": [{"parameters": {"1120": 1}}]})",
                "node.json: /axes/0/parameters/1120: expected a parameter of the axis such as p1120 or p1070[1] "
                "as key, "
                "got 1"},
        BadFile{R"({"axes": [{}, {"parameters": {"p1120[1]": 1}}]})",
                "node.json: /axes/1/parameters/p1120[1]: expected an index 0 to 0 of p1120 as key, got 1"},
        BadFile{R"({"axes": [{"parameters": {"p1120": "1"}}]})",
                "node.json: /axes/0/parameters/p1120: expected a number, got \"1\""},
        BadFile{R"({"axes": [{"parameters": {"p1120": -1}}]})",
                "node.json: /axes/0/parameters/p1120: expected a number 0 to 999999 s, got -1"},
        BadFile{R"({"axes": [{"parameters": {"p1082": 210001}}]})",
                "node.json: /axes/0/parameters/p1082: expected a number 0 to 210000 rpm, got 210001"},
        BadFile{R"({"axes": [{"parameters": {"p8791": -2}}]})",
                "node.json: /axes/0/parameters/p8791: expected an integer -1 to 3, got -2"},
        BadFile{R"({"axes": [{"parameters": {"p8641": 1.5}}]})",
                "node.json: /axes/0/parameters/p8641: expected an integer 0 to 3, got 1.5"},
        BadFile{R"({"axes": [{"parameters": {"p0311": 3000}}]})",
                "node.json: /axes/0/parameters/p0311: expected no such value (p0311: can only be written with "
                "p0010 = 3 or 1), got 3000"}));

INSTANTIATE_TEST_SUITE_P(
    Load, BadFiles,
    testing::Values(
        BadFile{R"({"axes": [{"load": 5}]})", "node.json: /axes/0/load: expected an object, got 5"},
        BadFile{R"({"axes": [{"load": {"mass": 5}}]})",
                "node.json: /axes/0/load/mass: unknown key, expected one of: inertia, friction, torque"},
        BadFile{R"({"axes": [{"load": {"inertia": -1}}]})",
                "node.json: /axes/0/load/inertia: expected a number not below 0, got -1"},
        BadFile{R"({"axes": [{"load": {"friction": 1}}]})",
                "node.json: /axes/0/load/friction: expected an object, got 1"},
        BadFile{R"({"axes": [{"load": {"friction": {"dry": 1}}}]})",
                "node.json: /axes/0/load/friction/dry: unknown key, expected one of: coulomb, viscous"},
        BadFile{R"({"axes": [{"load": {"friction": {"viscous": true}}}]})",
                "node.json: /axes/0/load/friction/viscous: expected a number not below 0, got true"},
        BadFile{R"({"axes": [{"load": {"torque": "5"}}]})",
                "node.json: /axes/0/load/torque: expected a number -1000000 to 1000000, got \"5\""},
        BadFile{R"({"axes": [{"load": {"torque": 1000001}}]})",
                "node.json: /axes/0/load/torque: expected a number -1000000 to 1000000, got 1000001"},
        BadFile{R"({"axes": [{"load": {"torque": {}}}]})",
                "node.json: /axes/0/load/torque: expected a number (N·m) or an object with the key type, got {}"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "spring"}}}]})",
                "node.json: /axes/0/load/torque/type: expected hoist or fan, got \"spring\""},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "hoist", "mass": 1}}}]})",
                "node.json: /axes/0/load/torque: expected the key radius, got {\"mass\":1,\"type\":\"hoist\"}"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "hoist", "mass": 1, "radius": -1}}}]})",
                "node.json: /axes/0/load/torque/radius: expected a number not below 0, got -1"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "hoist", "mass": 1e9, "radius": 1}}}]})",
                "node.json: /axes/0/load/torque: expected mass and radius that make at most 1000000 N·m, got "
                "{\"mass\":1000000000.0,\"radius\":1,\"type\":\"hoist\"}"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "fan", "mass": 1}}}]})",
                "node.json: /axes/0/load/torque/mass: unknown key, expected one of: type, coefficient"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "fan"}}}]})",
                "node.json: /axes/0/load/torque: expected the key coefficient (N·m·s²), got {\"type\":\"fan\"}"}));

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
    testing::Values(BadFile{"{", "line 1, column 2: expected valid JSON"},
                    BadFile{"7", "/: expected an object, got 7"},
                    BadFile{R"({"poles": 4})",
                            "/poles: unknown key, expected one of: rated_speed_rpm, maximum_speed_rpm, "
                            "rated_torque_Nm, maximum_torque_Nm, inertia_kgm2"},
                    BadFile{R"({"inertia_kgm2": 0})", "/inertia_kgm2: expected a number not below 1e-09, got 0"},
                    BadFile{R"({"rated_speed_rpm": "fast"})",
                            "/rated_speed_rpm: expected a number not below 1e-09, got \"fast\""}));

TEST(ConfigurationFile, ThatDoesNotExistIsNamed) {
  EXPECT_EQ(message_of([] {
              configuration_of({"--config", "/nowhere/node.json"});
            }),
            "/nowhere/node.json: cannot be read: No such file or directory");
}

TEST(ConfigurationFile, ThatIsAFolderIsNamed) {
  const fakes::TemporaryDirectory folder;

  EXPECT_EQ(message_of([&] {
              configuration_of({"--config", folder.path()});
            }),
            folder.path() + ": cannot be read: Is a directory");
}

TEST(CommandLineValues, OutOfRangeAreRefused) {
  EXPECT_EQ(message_of([] {
              configuration_of({"--node-id", "0"});
            }),
            "--node-id: expected an integer 1 to 127, got 0");
  EXPECT_EQ(message_of([] {
              configuration_of({"--node-id", "128"});
            }),
            "--node-id: expected an integer 1 to 127, got 128");
  EXPECT_EQ(message_of([] { configuration_of({"--axes", "9"}); }), "--axes: expected an integer 1 to 8, got 9");
  EXPECT_EQ(message_of([] {
              configuration_of({"--interface", "with space"});
            }),
            "--interface: expected " + kForms + ", got \"with space\"");
}

}  // namespace
}  // namespace axisd
