#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/configuration/command_line.hpp"
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
  EXPECT_FALSE(configuration.audit);
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
  const Configuration configuration = parse(
      R"({"interface": "can1", "node_id": 127, "sdo_block": true, "f08701": false, "audit": true, "axes": [{}],
                "parameters": {"p8848": 1, "p8609[1]": 2}})");

  EXPECT_EQ(configuration.address.text, "can1");
  EXPECT_EQ(configuration.node_id, 127);
  EXPECT_TRUE(configuration.sdo_block);
  EXPECT_TRUE(configuration.audit);
  EXPECT_FALSE(configuration.fault_on_leaving_operational);
  ASSERT_EQ(configuration.parameters.size(), 2U);
  EXPECT_EQ(configuration.parameters[0].number, 8609);
  EXPECT_EQ(configuration.parameters[0].index, 1);
  EXPECT_EQ(configuration.parameters[1].number, 8848);
  EXPECT_EQ(configuration.parameters[1].value, 1.0);
}

TEST(Configuration, CallsTheBusAsItIsTold) {
  EXPECT_EQ(name_of(parse(R"({"interface": "can1"})")), "can1/2");
  EXPECT_EQ(name_of(parse(R"({"interface": "can1", "bus": "line1"})")), "line1/2");
  EXPECT_EQ(name_of(configuration_of({"--interface", "unix:/tmp/bus", "--bus", "line1"})), "line1/2");
  EXPECT_THROW(configuration_of({"--bus", ""}), ConfigurationError);
}

TEST(Configuration, TakesEveryKeyOfARecording) {
  const Configuration configuration =
      parse(R"({"record": {"name": "night", "max_MB": 20, "signals": ["1/r0063"], "every_s": 0.5, "on_fault": true,
                "before_s": 2, "after_s": 3}})");

  ASSERT_TRUE(configuration.record);
  EXPECT_EQ(configuration.record->name, "night");
  EXPECT_EQ(configuration.record->most_MB, 20.0);
  EXPECT_EQ(configuration.record->signals, std::vector<std::string>{"1/r0063"});
  EXPECT_EQ(configuration.record->period, 0.5);
  EXPECT_TRUE(configuration.record->on_fault);
  EXPECT_EQ(configuration.record->before, 2.0);
  EXPECT_EQ(configuration.record->after, 3.0);
  EXPECT_FALSE(parse("{}").record);
}

TEST(Configuration, TakesATrace) {
  const Configuration configuration =
      parse(R"({"trace": {"signals": ["1/speed", "1/r0899.2"], "every": 0.001, "before_s": 0.5, "length_s": 2,
                "trigger": {"on": "fault", "axis": 1, "number": "F07860"}, "repeat": true, "keep": 4}})");

  ASSERT_TRUE(configuration.trace);
  EXPECT_EQ(configuration.trace->signals, (std::vector<std::string>{"1/speed", "1/r0899.2"}));
  EXPECT_EQ(configuration.trace->every, std::chrono::milliseconds{1});
  EXPECT_EQ(configuration.trace->before, std::chrono::milliseconds{500});
  EXPECT_EQ(configuration.trace->length, std::chrono::seconds{2});
  EXPECT_EQ(configuration.trace->trigger.kind, trace::TriggerKind::Fault);
  EXPECT_EQ(configuration.trace->trigger.number, 7860);
  EXPECT_TRUE(configuration.trace->repeat);
  EXPECT_EQ(configuration.trace->keep, 4U);
  EXPECT_FALSE(parse("{}").trace);
}

TEST(Configuration, SaysWhatIsNoParameterOfTheControlUnit) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse(text);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto ends = [&](const std::string& text, const std::string& end) { return message(text).ends_with(end); };

  EXPECT_TRUE(ends(R"({"parameters": []})", "/parameters: expected an object, got []"));
  EXPECT_TRUE(ends(R"({"parameters": {"p1120": 1}})",
                   "/parameters/p1120: expected a parameter of the control unit such as p8848 as key, got 1"));
  EXPECT_TRUE(ends(R"({"parameters": {"p8848": 17}})", "/parameters/p8848: expected a number 1 to 16 ms, got 17"));
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

TEST(Configuration, DeliversAServoWithoutSetpointChannel) {
  EXPECT_TRUE(axis_of("{}").setpoint_channel);
  const AxisConfiguration axis = axis_of(R"({"setpoint_channel": false, "parameters": {"p1121": 0.5}})");
  EXPECT_FALSE(axis.setpoint_channel);
  EXPECT_EQ(axis.parameters.size(), 1U);
}

TEST(Configuration, DeliversAnAxisWithPositionerWithOrWithoutWiring) {
  EXPECT_FALSE(axis_of("{}").positioner);
  EXPECT_FALSE(axis_of(R"({"positioner": true})").positioner_wiring);
  const AxisConfiguration axis = axis_of(
      R"({"positioner": true, "positioner_wiring": "telegram-110", "parameters": {"p2612": "r0722.3 of drive object 1"}})");
  EXPECT_TRUE(axis.positioner);
  EXPECT_EQ(axis.positioner_wiring, drive::PositionerWiring::Telegram110);
  EXPECT_EQ(axis.parameters.size(), 1U);
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

TEST(Configuration, CompletesAMotorFileSoThatItFitsItself) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("motor.json")} << R"({"rated_torque_Nm": 12, "maximum_torque_Nm": 70})";

  const motor::MachineData machine = axis_of(R"({"motor": ")" + folder.path("motor.json") + R"("})").machine;

  EXPECT_DOUBLE_EQ(machine.rated_current, 12.0 / 1.37);
  EXPECT_DOUBLE_EQ(machine.rated_power, 12.0 * 3000.0 * motor::kRpm);
  EXPECT_NEAR(machine.maximum_current, 56.2, 0.1);
  EXPECT_GE(machine.stall_current, machine.rated_current);
}

TEST(Configuration, TakesWhatTurnsInPlaceOfTheDataSheet) {
  const AxisConfiguration axis =
      axis_of(R"({"motor": "1ph8131", "plant": {"stator_resistance": 1.2, "saturation_flux": 0.9}})");

  EXPECT_EQ(axis.deviation, (motor::PlantDeviation{.stator_resistance = 1.2, .saturation_flux = 0.9}));
  EXPECT_EQ(axis_of("{}").deviation, motor::PlantDeviation{});
}

TEST(Configuration, GivesAnAxisTheSmallestPowerUnitWithTheMaximumCurrentOfItsMotor) {
  EXPECT_EQ(axis_of("{}").inverter.rated_current, 18.0);
  EXPECT_EQ(axis_of(R"({"motor": "1fk7042"})").inverter.rated_current, 5.0);
  EXPECT_EQ(axis_of(R"({"motor": "1fk7042"})").inverter.maximum_current, 10.0);
  EXPECT_EQ(axis_of(R"({"motor": "1ph8131"})").inverter.rated_current, 30.0);
}

TEST(Configuration, TakesAPowerUnitAndFitsWhatIsNotSaid) {
  const motor::InverterData unit =
      axis_of(R"({"power_unit": {"rated_current_A": 30, "pulse_frequency_kHz": 4, "ambient_C": 45}})").inverter;

  EXPECT_EQ(unit.rated_current, 30.0);
  EXPECT_EQ(unit.maximum_current, 60.0);
  EXPECT_GT(unit.trip_current, 60.0 * 1.4142);
  EXPECT_EQ(unit.pulse_frequency, 4000.0);
  EXPECT_EQ(unit.ambient, 45.0);
}

TEST(Configuration, TakesTheSupplyOfTheUnit) {
  const motor::SupplyData supply = parse(R"({"supply": {
    "infeed": "active", "line_voltage_V": 480, "active_voltage_V": 720, "line_resistance_ohm": 0.1,
    "rated_power_W": 16000, "capacitance_F": 0.002, "chopper_ohm": 0, "chopper_on_V": 780, "chopper_off_V": 770,
    "overvoltage_V": 830, "undervoltage_V": 400
  }})")
                                       .supply;

  EXPECT_EQ(supply.infeed, motor::Infeed::Active);
  EXPECT_EQ(supply.line_voltage, 480.0);
  EXPECT_EQ(supply.active_voltage, 720.0);
  EXPECT_EQ(supply.line_resistance, 0.1);
  EXPECT_EQ(supply.rated_power, 16e3);
  EXPECT_EQ(supply.capacitance, 2e-3);
  EXPECT_EQ(supply.chopper_resistance, 0.0);
  EXPECT_EQ(supply.chopper_on, 780.0);
  EXPECT_EQ(supply.chopper_off, 770.0);
  EXPECT_EQ(supply.overvoltage, 830.0);
  EXPECT_EQ(supply.undervoltage, 400.0);
}

TEST(Configuration, TakesTheEncoderOfAnAxisOverThatOfItsMotor) {
  const motor::EncoderData encoder =
      axis_of(R"({"motor": "1ft7044", "encoder": {"pulses": 512, "start_position": 17.5}})").machine.encoder;

  EXPECT_EQ(encoder.type, motor::EncoderType::Absolute);
  EXPECT_EQ(encoder.pulses, 512U);
  EXPECT_EQ(encoder.start_position, 17.5);
  EXPECT_EQ(axis_of(R"({"encoder": {"type": "none"}})").machine.encoder.type, motor::EncoderType::None);
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

TEST(Configuration, TakesAnInfeedAsADriveObject) {
  EXPECT_FALSE(parse(R"({})").infeed);
  EXPECT_FALSE(parse(R"({"infeed": false})").infeed);
  EXPECT_EQ(parse(R"({"infeed": true})").infeed->name, "infeed");
  // r8890.15 of drive object 3, r0863.0 of drive object 2
  const Configuration configuration = parse(R"({"infeed": {"name": "ALM", "parameters": {"p0840": 582618127}},
                                                "axes": [{"parameters": {"p0864": 56559616}}]})");
  EXPECT_EQ(configuration.infeed->name, "ALM");
  ASSERT_EQ(configuration.infeed->parameters.size(), 1U);
  EXPECT_EQ(configuration.infeed->parameters[0].number, 840);
  EXPECT_EQ(configuration.infeed->parameters[0].value, 582618127.0);
  ASSERT_EQ(configuration.axes[0].parameters.size(), 1U);
}

TEST(Configuration, TakesAnAddressSwitchAtZero) {
  EXPECT_EQ(parse(R"({"node_id": 0})").node_id, kAddressSwitchOff);
  EXPECT_EQ(configuration_of({"--node-id", "0"}).node_id, kAddressSwitchOff);
}

}  // namespace
}  // namespace axisd
