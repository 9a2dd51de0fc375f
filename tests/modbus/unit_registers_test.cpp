#include "modbus/unit_registers.hpp"

#include <gtest/gtest.h>

#include "tests/modbus/served_unit.hpp"

namespace modbus {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kUnit = 1, kX = 2, kY = 3;
constexpr int kServerFailure = 4;

unit::Configuration two_axes() {
  return {.drive = {.axes = {{}, {}}, .node_id = 5}};
}
unit::Configuration without_setpoint_channel() {
  unit::Configuration configuration = ServedUnit::one_axis();
  configuration.drive.axes[0].setpoint_channel = false;
  return configuration;
}

/// As a master chooses another axis for the registers.
void choose(ServedUnit& unit, double object) {
  unit.set(kUnit, 9, 1);
  unit.set(kUnit, 978, object);
  unit.set(kUnit, 9, 0);
  unit.passes(8ms);
}

bool has_alarm(const ServedUnit& unit, unsigned number, unsigned value) {
  const auto alarms = unit.runner.unit().control_unit().messages().alarms();
  return std::ranges::any_of(
      alarms, [&](const drive::FaultEntry& alarm) { return alarm.row->number == number && alarm.value == value; });
}

TEST(UnitRegisters, ShowParametersByTheirScale) {
  ServedUnit unit;
  unit.set(kX, 1120, 12.34);
  unit.set(kX, 1121, 999999.0);

  EXPECT_EQ(unit.read(40301), 480);
  EXPECT_EQ(unit.read(40322), 1234);
  EXPECT_EQ(unit.read(40323), 65535);
  EXPECT_EQ(unit.read(40324), 3000);
  EXPECT_EQ(unit.read(40344), static_cast<int>(std::lround(unit.value(kX, 26))));
  EXPECT_EQ(unit.read(40321), static_cast<int>(std::lround(unit.value(kX, 640) * 10)));
}

TEST(UnitRegisters, WriteParametersByTheirScale) {
  ServedUnit unit;
  EXPECT_EQ(unit.write(40322, 1500), 0);
  EXPECT_EQ(unit.write(40321, 55), 0);
  EXPECT_EQ(unit.value(kX, 1120), 15.0);
  EXPECT_NEAR(unit.value(kX, 640), 5.5, 1e-6);
}

TEST(UnitRegisters, RefuseValuesAsTheParameterDoes) {
  ServedUnit unit;
  EXPECT_EQ(unit.write(40324, 5), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x02);
  EXPECT_EQ(unit.read(40324), 3000);
}

TEST(UnitRegisters, WriteParametersUpToTheFirstThatIsRefused) {
  ServedUnit unit;
  EXPECT_EQ(unit.exchange("0001 0000 000D 01 10 0141 0003 06 0064 00C8 0005").substr(14), "9004");
  EXPECT_EQ(unit.value(kX, 1120), 1.0);
  EXPECT_EQ(unit.value(kX, 1121), 2.0);
  EXPECT_EQ(unit.read(40499), 0x02);
}

TEST(UnitRegisters, WriteNothingWhereOneCannotBeWritten) {
  ServedUnit unit;
  unit.set(kX, 1121, 7.0);
  EXPECT_EQ(unit.exchange("0001 0000 000D 01 10 0142 0003 06 0064 0BB8 0000").substr(14), "9004");
  EXPECT_EQ(unit.value(kX, 1121), 7.0);
  EXPECT_EQ(unit.read(40499), 0x00);
  EXPECT_EQ(unit.write(40340, 1), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x01);
  EXPECT_EQ(unit.write(40001, 1), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x00);
}

TEST(UnitRegisters, OfTheTechnologyControllerAreReserved) {
  ServedUnit unit;
  unit.write(40340, 1);
  EXPECT_EQ(unit.write(40500, 1), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x00);
  EXPECT_EQ(unit.read(40500), 0);
  EXPECT_EQ(unit.read(40522), 0);
}

TEST(UnitRegisters, OfTheSetpointChannelAreReservedWithoutIt) {
  ServedUnit unit{without_setpoint_channel()};
  EXPECT_EQ(unit.read(40322), 0);
  EXPECT_EQ(unit.write(40322, 100), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x00);
}

TEST(UnitRegisters, ShowFaultsAndAlarms) {
  ServedUnit unit;
  static_cast<void>(unit.runner.raise(1, 7860, 0, unit.runner.now()));
  unit.passes(8ms);
  EXPECT_EQ(unit.read(40400), 7860);
  EXPECT_EQ(unit.read(40401), 0);
}

TEST(UnitRegisters, BelongToTheFirstCyclicObject) {
  ServedUnit unit{two_axes()};
  unit.set(kX, 1120, 1.0);
  unit.set(kY, 1120, 2.0);
  EXPECT_EQ(unit.read(40322), 100);

  choose(unit, kY);

  EXPECT_EQ(unit.read(40322), 200);
}

TEST(UnitRegisters, AreNotServedWhereThatIsNoAxis) {
  ServedUnit unit;
  EXPECT_TRUE(unit.registers.is_available());
  EXPECT_FALSE(has_alarm(unit, 8555, 2));

  for (const double object : {1.0, 0.0, 77.0, 255.0}) {
    choose(unit, object);
    EXPECT_FALSE(unit.registers.is_available()) << object;
    EXPECT_TRUE(has_alarm(unit, 8555, 2)) << object;
  }
  choose(unit, kX);
  EXPECT_TRUE(unit.registers.is_available());
  EXPECT_FALSE(has_alarm(unit, 8555, 2));
}

TEST(UnitRegisters, RememberThatProcessDataWasWritten) {
  ServedUnit unit;
  unit.read(40100);
  unit.write(40322, 100);
  unit.write(40110, 1);
  EXPECT_FALSE(unit.registers.take_command());
  unit.write(40109, 1);
  EXPECT_TRUE(unit.registers.take_command());
  EXPECT_FALSE(unit.registers.take_command());
}

TEST(UnitRegisters, TellTheUnitThatWhoeverWroteProcessDataIsGone) {
  ServedUnit unit;
  unit.write(40100, 0x047E);
  unit.passes(8ms);
  unit.registers.on_command_lost();
  unit.passes(8ms);
  EXPECT_EQ(unit.read(40409), 1925);

  unit.write(40100, 0x047E);
  unit.passes(8ms);
  EXPECT_EQ(unit.read(40409), 0);
}

TEST(UnitRegisters, HoldTheProtocolWhileTheyAreServed) {
  ServedUnit unit;
  unit.interface.serve_modbus();
  EXPECT_EQ(unit.value(kUnit, 2030), 13.0);
  const auto refused = unit.runner.write_parameter(kUnit, 2030, 0, 7.0, unit.runner.now());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, drive::RefusalReason::Locked);
}

TEST(UnitRegisters, CarryRecordsInTheFirstWholeCycle) {
  ServedUnit unit;
  EXPECT_TRUE(unit.runner.is_resting());
  unit.passes(1ms);
  EXPECT_EQ(unit.exchange("0001 0000 0015 01 10 0258 0007 0E 0001 2F0A 8001 0201 1001 0460 0000"),
            "000100000006011002580007");
  EXPECT_EQ(unit.read(40601), 1);
  EXPECT_EQ(unit.read(40602), 0x2F00);
  EXPECT_EQ(unit.read(40603), 4);

  unit.passes(6ms);  // the rest of this cycle, and half of the next one
  EXPECT_EQ(unit.read(40601), 1);
  unit.passes(2ms);

  EXPECT_EQ(unit.read(40601), 2);
  EXPECT_EQ(unit.read(40602), 0x2F0A);
  EXPECT_EQ(unit.exchange("0001 0000 0006 01 03 025A 0006").substr(18), "800102010801412000000000")
      << "p1120 = 10 s";
  unit.passes(20ms);
  EXPECT_TRUE(unit.runner.is_resting());
}

TEST(UnitRegisters, RefuseParametersWhileTheUnitSaves) {
  ServedUnit unit;
  unit.shelf.is_slow = true;
  unit.set(kUnit, 977, 1);
  ASSERT_TRUE(unit.runner.is_saving());

  EXPECT_EQ(unit.write(40322, 100), kServerFailure);
  EXPECT_EQ(unit.read(40499), 0x11);

  unit.runner.on_stored(true, unit.runner.now());
  EXPECT_EQ(unit.write(40322, 100), 0);
}

}  // namespace
}  // namespace modbus
