#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/command_line.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

Configuration parse(std::string_view text) {
  return parse_configuration(text, "node.json");
}

/// The first axis of a configuration whose `axes` hold @p axis alone.
AxisConfiguration axis_of(const std::string& axis) {
  return parse(R"({"axes": [)" + axis + "]}").axes.at(0);
}

TEST(Configuration, OfNothingIsOneServoAtNode2OfVcan0) {
  const Configuration configuration = configuration_of({});

  EXPECT_EQ(configuration.address.text, "vcan0");
  EXPECT_EQ(configuration.node_id, 2);
  EXPECT_FALSE(configuration.sdo_block);
  EXPECT_TRUE(configuration.fault_on_leaving_operational);
  ASSERT_EQ(configuration.axes.size(), 1U);
  EXPECT_EQ(configuration.axes[0].name, "X");
  EXPECT_DOUBLE_EQ(configuration.axes[0].machine.rated_speed, 3000.0 * motor::kRpm);
  EXPECT_TRUE(configuration.axes[0].parameters.empty());
}

TEST(Configuration, OfAnEmptyObjectIsTheDefault) {
  const Configuration configuration = parse("{}");

  EXPECT_EQ(configuration.address.text, "vcan0");
  EXPECT_EQ(configuration.node_id, 2);
  EXPECT_EQ(configuration.axes.size(), 1U);
}

TEST(Configuration, TakesEveryKeyOfTheUnit) {
  const Configuration configuration =
      parse(R"({"interface": "can1", "node_id": 127, "sdo_block": true, "f08701": false, "axes": [{}]})");

  EXPECT_EQ(configuration.address.text, "can1");
  EXPECT_EQ(configuration.node_id, 127);
  EXPECT_TRUE(configuration.sdo_block);
  EXPECT_FALSE(configuration.fault_on_leaving_operational);
}

TEST(Configuration, TakesEveryKeyOfAnAxis) {
  const AxisConfiguration axis = axis_of(R"({
    "name": "Spindle", "type": "servo", "motor": "1fk7063",
    "load": {"inertia": 0.002, "friction": {"coulomb": 0.5, "viscous": 0.001}, "torque": -3},
    "parameters": {"p1120": 0.5, "p8641": 1}
  })");

  EXPECT_EQ(axis.name, "Spindle");
  EXPECT_EQ(axis.load.inertia, 0.002);
  EXPECT_EQ(axis.load.coulomb_friction, 0.5);
  EXPECT_EQ(axis.load.viscous_friction, 0.001);
  EXPECT_EQ(axis.load.constant_torque, -3.0);
  ASSERT_EQ(axis.parameters.size(), 2U);
  EXPECT_EQ(axis.parameters[0].number, 1120);
  EXPECT_EQ(axis.parameters[0].value, 0.5);
  EXPECT_EQ(axis.parameters[1].number, 8641);
  EXPECT_EQ(axis.parameters[1].value, 1.0);
}

TEST(Configuration, TakesAHoistAsALoad) {
  const AxisConfiguration axis = axis_of(R"({"load": {"torque": {"type": "hoist", "mass": 10, "radius": 0.05}}})");

  EXPECT_DOUBLE_EQ(axis.load.constant_torque, 10 * 9.80665 * 0.05);
  EXPECT_EQ(axis.load.fan_coefficient, 0.0);
}

TEST(Configuration, TakesAFanAsALoad) {
  const AxisConfiguration axis = axis_of(R"({"load": {"torque": {"type": "fan", "coefficient": 2e-5}}})");

  EXPECT_EQ(axis.load.fan_coefficient, 2e-5);
  EXPECT_EQ(axis.load.constant_torque, 0.0);
}

TEST(Configuration, TakesAMotorFromAFileAndTheRestFromTheDefaultMotor) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("motor.json")} << R"({"rated_speed_rpm": 1500, "rated_torque_Nm": 12})";

  const motor::MachineData machine = axis_of(R"({"motor": ")" + folder.path("motor.json") + R"("})").machine;

  EXPECT_DOUBLE_EQ(machine.rated_speed, 1500.0 * motor::kRpm);
  EXPECT_EQ(machine.rated_torque, 12.0);
  EXPECT_EQ(machine.maximum_speed, motor::MachineData{}.maximum_speed);
}

TEST(Configuration, TakesEveryKeyOfAMotorFile) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("motor.json")} << R"({"rated_speed_rpm": 1500, "maximum_speed_rpm": 4000,
      "rated_torque_Nm": 12, "maximum_torque_Nm": 40, "inertia_kgm2": 0.004})";

  const motor::MachineData machine = axis_of(R"({"motor": ")" + folder.path("motor.json") + R"("})").machine;

  EXPECT_DOUBLE_EQ(machine.maximum_speed, 4000.0 * motor::kRpm);
  EXPECT_EQ(machine.maximum_torque, 40.0);
  EXPECT_EQ(machine.inertia, 0.004);
}

TEST(Configuration, OfAFileIsOverriddenByTheCommandLine) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("node.json")} << R"({"interface": "can1", "node_id": 5, "f08701": false})";
  const std::string file = folder.path("node.json");

  const Configuration plain = configuration_of({"--config", file});
  const Configuration overridden =
      configuration_of({"--config", file, "--interface", "can2", "--node-id", "6", "--axes", "1"});

  EXPECT_EQ(plain.address.text, "can1");
  EXPECT_EQ(plain.node_id, 5);
  EXPECT_EQ(overridden.address.text, "can2");
  EXPECT_EQ(overridden.node_id, 6);
  EXPECT_FALSE(overridden.fault_on_leaving_operational);
}

}  // namespace
}  // namespace axisd
