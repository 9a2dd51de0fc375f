#include <gtest/gtest.h>

#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/daemon/configuration/command_line.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

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

INSTANTIATE_TEST_SUITE_P(
    KeysThatAreThereTwice, BadFiles,
    testing::Values(
        BadFile{R"({"node_id": 5, "node_id": 6})", "node.json: /node_id: expected once, is there twice"},
        BadFile{R"({"axes": [{}, {"name": "X", "load": {"inertia": 1, "inertia": 1}}]})",
                "node.json: /axes/1/load/inertia: expected once, is there twice"},
        BadFile{R"({"axes": [{"load": {"torque": [1, {"type": "hoist"}, {"type": "fan", "type": "fan"}]}}]})",
                "node.json: /axes/0/load/torque/2/type: expected once, is there twice"},
        BadFile{R"({"axes": [{"parameters": {"p1120": 1}}], "axes": []})",
                "node.json: /axes: expected once, is there twice"},
        BadFile{R"({"a\nb": 5, "a\nb": 6})", "node.json: /a\\nb: expected once, is there twice"}));

INSTANTIATE_TEST_SUITE_P(
    Positioner, BadFiles,
    testing::Values(
        BadFile{R"({"axes": [{"positioner": 1}]})",
                "node.json: /axes/0/positioner: expected true or false, got 1"},
        BadFile{R"({"axes": [{"positioner_wiring": "mdi"}]})",
                "node.json: /axes/0/positioner_wiring: expected an axis with \"positioner\": true, got \"mdi\""},
        BadFile{
            R"({"axes": [{"positioner": false, "positioner_wiring": "blocks"}]})",
            "node.json: /axes/0/positioner_wiring: expected an axis with \"positioner\": true, got \"blocks\""},
        BadFile{R"({"axes": [{"positioner": true, "positioner_wiring": "epos"}]})",
                "node.json: /axes/0/positioner_wiring: expected mdi, blocks, telegram-110 or telegram-111, got "
                "\"epos\""}));

INSTANTIATE_TEST_SUITE_P(
    Unit, BadFiles,
    testing::Values(
        BadFile{R"({"nodeid": 5})",
                "node.json: /nodeid: unknown key, expected one of: interface, bus, profile, node_id, axes, "
                "parameters, supply, infeed, sdo_block, f08701, record, trace, audit, modbus, inject, serial, "
                "missed_setpoints, "
                "control_group"},
        BadFile{R"({"bus": "line.1"})",
                "node.json: /bus: expected a name of 1 to 32 letters, digits, '-' and '_', got \"line.1\""},
        BadFile{R"({"interface": 0})", "node.json: /interface: expected a string, got 0"},
        BadFile{R"({"interface": ""})", "node.json: /interface: expected " + kForms + ", got \"\""},
        BadFile{R"({"interface": "a-rather-long-name"})",
                "node.json: /interface: expected " + kForms + ", got \"a-rather-long-name\""},
        BadFile{R"({"interface": "../x"})", "node.json: /interface: expected " + kForms + ", got \"../x\""},
        BadFile{R"({"interface": "udp-multicast://10.0.0.1:43113"})",
                "node.json: /interface: expected a multicast group, 224.0.0.0 to 239.255.255.255 or [ff00::] to "
                "[ffff:...], got \"udp-multicast://10.0.0.1:43113\""},
        BadFile{R"({"node_id": "5"})", "node.json: /node_id: expected an integer 0 to 127, got \"5\""},
        BadFile{R"({"node_id": 5.5})", "node.json: /node_id: expected an integer 0 to 127, got 5.5"},
        BadFile{R"({"node_id": -1})", "node.json: /node_id: expected an integer 0 to 127, got -1"},
        BadFile{R"({"node_id": 128})", "node.json: /node_id: expected an integer 0 to 127, got 128"},
        BadFile{R"({"node_id": 18446744073709551615})",
                "node.json: /node_id: expected an integer 0 to 127, got 18446744073709551615"},
        BadFile{R"({"modbus": 502})", "node.json: /modbus: expected true or false, got 502"},
        BadFile{R"({"modbus": {"address": "localhost"}})",
                "node.json: /modbus/address: expected an IPv4 or IPv6 address, got \"localhost\""},
        BadFile{R"({"modbus": {"port": 65536}})",
                "node.json: /modbus/port: expected an integer 0 to 65535, got 65536"},
        BadFile{R"({"sdo_block": 1})", "node.json: /sdo_block: expected true or false, got 1"},
        BadFile{R"({"f08701": "no"})", "node.json: /f08701: expected true or false, got \"no\""},
        BadFile{R"({"record": true})", "node.json: /record: expected an object, got true"},
        BadFile{R"({"record": {"file": "x"}})",
                "node.json: /record/file: unknown key, expected one of: name, max_MB, signals, every_s, on_fault, "
                "before_s, after_s"},
        BadFile{
            R"({"record": {"name": "../x"}})",
            "node.json: /record/name: expected 1 to 64 letters, digits, '_', '-' or '.', a dot not in front, got "
            "\"../x\""},
        BadFile{R"({"record": {"max_MB": 0}})", "node.json: /record/max_MB: expected a number 1 to 1024, got 0"},
        BadFile{R"({"record": {"signals": [1]}})", "node.json: /record/signals/0: expected a string, got 1"},
        BadFile{R"({"trace": []})", "node.json: /trace: expected an object, got []"},
        BadFile{R"({"trace": {}})", "node.json: /trace/signals: expected a list of 1 to 8 names of signals"},
        BadFile{
            R"({"trace": {"signals": ["1/speed"], "evry": 1}})",
            "node.json: /trace/evry: unknown key, expected one of: signals, every, trigger, before_s, length_s, "
            "samples, repeat, keep"},
        BadFile{R"({"trace": {"signals": ["1/speed"], "trigger": {"on": "fault", "number": "F1"}}})",
                "node.json: /trace/trigger/number: expected a fault or alarm of the unit, such as 7860"},
        BadFile{R"({"axes": {}})", "node.json: /axes: expected an array of 1 to 8, got {}"},
        BadFile{R"({"axes": []})", "node.json: /axes: expected an array of 1 to 8, got []"},
        BadFile{R"({"axes": [{},{},{},{},{},{},{},{},{}]})",
                "node.json: /axes: expected an array of 1 to 8, got [{},{},{},{},{},{},{},{},{}]"}));

INSTANTIATE_TEST_SUITE_P(
    Axis, BadFiles,
    testing::Values(
        BadFile{R"({"axes": [1]})", "node.json: /axes/0: expected an object, got 1"},
        BadFile{R"({"axes": [{"speed": 1}]})",
                "node.json: /axes/0/speed: unknown key, expected one of: name, type, motor, encoder, load, "
                "plant, power_unit, setpoint_channel, positioner, positioner_wiring, switches, homing_distance, "
                "parameters"},
        BadFile{R"({"axes": [{"setpoint_channel": 0}]})",
                "node.json: /axes/0/setpoint_channel: expected true or false, got 0"},
        BadFile{R"({"axes": [{"type": "vector", "setpoint_channel": false}]})",
                "node.json: /axes/0/setpoint_channel: expected true, which a vector axis always has, got false"},
        BadFile{
            R"({"axes": [{"setpoint_channel": false, "parameters": {"p1120": 1}}]})",
            "node.json: /axes/0/parameters/p1120: expected no p1120, which this axis is delivered without, got 1"},
        BadFile{R"({"axes": [{"name": 1}]})", "node.json: /axes/0/name: expected a string, got 1"},
        BadFile{R"({"axes": [{"type": "infeed"}]})",
                "node.json: /axes/0/type: expected servo or vector, got \"infeed\""},
        BadFile{R"({"axes": [{"name": "X"}, {"name": "Y"}, {"name": "X"}]})",
                "node.json: /axes/2/name: expected a name that /axes/0 does not have, got \"X\""},
        BadFile{R"({"axes": [{"name": "Y"}, {}]})",
                "node.json: /axes/1: expected a name that /axes/0 does not have, got {}"},
        BadFile{R"({"axes": [{"motor": 1}]})", "node.json: /axes/0/motor: expected a string, got 1"},
        BadFile{R"({"axes": [{"motor": "1fk7"}]})",
                "node.json: /axes/0/motor: expected a motor preset (1fk7042, 1fk7063, 1ft7044, 1le1003-2k2, "
                "1ph8131, im-2k2, ipmsm-2k2) or the path of a motor file, got \"1fk7\""},
        BadFile{R"({"axes": [{"motor": "/nowhere/motor.json"}]})",
                "node.json: /axes/0/motor: expected a motor file that can be read (/nowhere/motor.json: cannot be "
                "read: No such file or directory), got \"/nowhere/motor.json\""},
        BadFile{R"({"axes": [{"plant": {"stator_resistance": 0}}]})",
                "node.json: /axes/0/plant/stator_resistance: expected a number 0.1 to 10, got 0"},
        BadFile{R"({"axes": [{"plant": {"rotor_resistance": 1.2}}]})",
                "node.json: /axes/0/plant/rotor_resistance: unknown key, expected one of: stator_resistance, "
                "d_inductance, q_inductance, magnet_flux, inertia, friction"},
        BadFile{
            R"({"axes": [{"plant": {"inertia": 0.1}, "load": {"inertia": 1, "coupling": {"stiffness": 1e7}}}]})",
            "node.json: /axes/0/plant: expected factors with which coupling.stiffness is a stiffness that "
            "resonates below 16 kHz, got {\"inertia\":0.1}"},
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
                "node.json: /axes/0/load/mass: unknown key, expected one of: inertia, friction, torque, coupling, "
                "end_stops, gear, pitch, brake"},
        BadFile{R"({"axes": [{"load": {"inertia": -1}}]})",
                "node.json: /axes/0/load/inertia: expected a number not below 0, got -1"},
        BadFile{R"({"axes": [{"load": {"friction": 1}}]})",
                "node.json: /axes/0/load/friction: expected an object, got 1"},
        BadFile{R"({"axes": [{"load": {"friction": {"dry": 1}}}]})",
                "node.json: /axes/0/load/friction/dry: unknown key, expected one of: coulomb, viscous, "
                "breakaway, stribeck_speed"},
        BadFile{R"({"axes": [{"load": {"friction": {"viscous": true}}}]})",
                "node.json: /axes/0/load/friction/viscous: expected a number, got true"},
        BadFile{R"({"axes": [{"load": {"torque": "5"}}]})",
                "node.json: /axes/0/load/torque: expected a number -1000000 to 1000000, got \"5\""},
        BadFile{R"({"axes": [{"load": {"torque": 1000001}}]})",
                "node.json: /axes/0/load/torque: expected a number -1000000 to 1000000, got 1000001"},
        BadFile{R"({"axes": [{"load": {"torque": {}}}]})",
                "node.json: /axes/0/load/torque: expected a number (N·m) or an object with the key type, got {}"},
        BadFile{R"({"axes": [{"load": {"torque": {"type": "spring"}}}]})",
                "node.json: /axes/0/load/torque/type: expected constant, friction, hoist, fan, pendulum or "
                "profile, got "
                "\"spring\""},
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
                "node.json: /axes/0/load/torque: expected the key coefficient, got {\"type\":\"fan\"}"},
        BadFile{R"({"axes": [{"load": {"friction": {"coulomb": -1}}}]})",
                "node.json: /axes/0/load/friction/coulomb: expected a number not below 0, got -1"},
        BadFile{
            R"({"axes": [{"load": {"torque": {"type": "profile", "points": [[0, 1], [0, 2]]}}}]})",
            "node.json: /axes/0/load/torque/points/1/0: expected a time after that of the point before, got 0"},
        BadFile{
            R"({"axes": [{"load": {"torque": {"type": "profile", "points": [[1, 1], [2, 2]], "repeats": true}}}]})",
            "node.json: /axes/0/load: expected a value for profile that is two points or more, the first at "
            "time 0, to repeat, got {\"torque\":{\"points\":[[1,1],[2,2]],\"repeats\":true,\"type\":\"pro..."},
        BadFile{
            R"({"axes": [{"load": {"coupling": {"stiffness": 100}}}]})",
            "node.json: /axes/0/load: expected a value for inertia that is a number above 0 behind a coupling, "
            "got {\"coupling\":{\"stiffness\":100}}"},
        BadFile{
            R"({"axes": [{"load": {"inertia": 1e-6, "coupling": {"stiffness": 1e8}}}]})",
            "node.json: /axes/0/load/coupling/stiffness: expected a stiffness that resonates below 16 kHz, got "
            "100000000.0"},
        BadFile{R"({"axes": [{"load": {"end_stops": {"lower": 1}}}]})",
                "node.json: /axes/0/load/end_stops/lower: expected a number not above 0, where the load is at "
                "power-on, got 1"},
        BadFile{
            R"({"axes": [{"load": {"end_stops": {"upper": 1, "stiffness": 1e9}}}]})",
            "node.json: /axes/0/load/end_stops/stiffness: expected a stiffness that resonates below 16 kHz, got "
            "1000000000.0"},
        BadFile{R"({"axes": [{"load": {"gear": 0}}]})",
                "node.json: /axes/0/load/gear: expected a number 0.001 to 10000, got 0"},
        BadFile{R"({"axes": [{"load": {"gear": 2, "torque": {"type": "pendulum", "mass": 1, "radius": 1}}}]})",
                "node.json: /axes/0/load/gear: expected 1, since there is a pendulum, got 2"}));

INSTANTIATE_TEST_SUITE_P(
    Supply, BadFiles,
    testing::Values(
        BadFile{R"({"supply": {"infeed": "thyristor"}})",
                "node.json: /supply/infeed: expected diode, regenerative or active, got \"thyristor\""},
        BadFile{R"({"supply": {"capacitance_F": 0}})",
                "node.json: /supply/capacitance_F: expected a number above 0, got 0"},
        BadFile{
            R"({"supply": {"chopper_off_V": 780}})",
            "node.json: /supply/chopper_off_V: expected less than the voltage at which the chopper goes on, got "
            "780"},
        BadFile{R"({"supply": {"line_voltage_V": 4000}})",
                "node.json: /supply/line_voltage_V: expected 0 or a number 70 to 1000, got 4000"},
        BadFile{R"({"supply": {"line_voltage_V": 24}})",
                "node.json: /supply/line_voltage_V: expected 0 or a number 70 to 1000, got 24"},
        BadFile{
            R"({"supply": {"line_voltage_V": 690}})",
            "node.json: /supply/line_voltage_V: expected a line whose rectified voltage, 1.35 times as high, is "
            "less than the overvoltage, got 690"},
        BadFile{R"({"supply": {"infeed": "active", "active_voltage_V": 6000}})",
                "node.json: /supply/active_voltage_V: expected less than the overvoltage, got 6000"},
        BadFile{R"({"supply": {"capacity": 1}})",
                "node.json: /supply/capacity: unknown key, expected one of: infeed, line_voltage_V, "
                "active_voltage_V, line_resistance_ohm, rated_power_W, capacitance_F, chopper_ohm, chopper_on_V, "
                "chopper_off_V, overvoltage_V, undervoltage_V"},
        BadFile{R"({"axes": [{"power_unit": {"rated_current_A": 0}}]})",
                "node.json: /axes/0/power_unit/rated_current_A: expected a number 0.001 to 1000000, got 0"},
        BadFile{R"({"axes": [{"power_unit": {"maximum_current_A": 5}}]})",
                "node.json: /axes/0/power_unit: expected a value for rated_current_A that is not more than the "
                "maximum current, got {\"maximum_current_A\":5}"},
        BadFile{R"({"axes": [{"encoder": {"pulses": 0}}]})",
                "node.json: /axes/0/encoder/pulses: expected an integer 1 to 16777215, got 0"},
        BadFile{R"({"axes": [{"encoder": {"type": "resolver"}}]})",
                "node.json: /axes/0/encoder/type: expected none, incremental or absolute, got \"resolver\""}));

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
              configuration_of({"--node-id", "-1"});
            }),
            "--node-id: expected an integer 0 to 127, got -1");
  EXPECT_EQ(message_of([] {
              configuration_of({"--node-id", "128"});
            }),
            "--node-id: expected an integer 0 to 127, got 128");
  EXPECT_EQ(message_of([] { configuration_of({"--axes", "9"}); }), "--axes: expected an integer 1 to 8, got 9");
  EXPECT_EQ(message_of([] {
              configuration_of({"--interface", "with space"});
            }),
            "--interface: expected " + kForms + ", got \"with space\"");
}

}  // namespace
}  // namespace axisd
