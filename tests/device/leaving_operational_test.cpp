#include "tests/device/test_unit.hpp"

namespace device {
namespace {

TEST(LeavingOperational, ToPreOperationalRaisesF08701) {
  TestUnit unit;
  unit.start_operational();

  EXPECT_EQ(unit.says("000#8005"), Lines{"085#011011FD21020000"});

  EXPECT_EQ(unit.upload(0x1001).number(), 0x11U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 1).number(), 0x00021001U);
  EXPECT_EQ(unit.upload(0x1003, 3).number(), 0x21FD1001U);
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
}

TEST(LeavingOperational, ToStoppedSendsNothingAndShowsF08701AfterTheNextChange) {
  TestUnit unit;
  unit.start_operational();

  EXPECT_EQ(unit.says("000#0205"), Lines{});
  EXPECT_EQ(unit.passes(1s), Lines{});
  EXPECT_EQ(unit.says("605#4003100000000000"), Lines{});
  EXPECT_EQ(unit.says("000#8005"), Lines{});

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 3).number(), 0x21FD1001U);
}

TEST(LeavingOperational, ByAnUnknownCommandStopsTheNode) {
  TestUnit unit;
  unit.start_operational();

  EXPECT_EQ(unit.says("000#7705"), Lines{});

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::Stopped);
  EXPECT_EQ(unit.device.axis().messages().faults().size(), 1U);
}

TEST(LeavingOperational, StopsATurningMotorOnTheOff3Ramp) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 0.1}, {1135, 0.5}})};
  unit.turn_at(3000, 1s);

  unit.says("000#8005");
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x0F);
  unit.passes(246ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(100));

  EXPECT_TRUE(unit.reaches(0x4F, 0x08, 400ms));
}

TEST(LeavingOperational, RaisesTheFaultAgainAfterAnAcknowledgement) {
  TestUnit unit;
  unit.start_operational();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(unit.says("000#8005"), Lines{"085#011011FD21020000"});
    EXPECT_EQ(unit.says("605#2F03100000000000"), (Lines{"085#0000000000000000", "585#6003100000000000"}));
    unit.says("000#0105");
  }
}

TEST(LeavingOperational, IsQuietIfTheConfigurationSaysSo) {
  Configuration configuration = unit_with({{1120, 0.1}});
  configuration.fault_on_leaving_operational = false;
  TestUnit unit{configuration};
  unit.turn_at(3000, 1s);

  EXPECT_EQ(unit.says("000#8005"), Lines{});
  EXPECT_EQ(unit.passes(1s), Lines{});

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
  EXPECT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(3));
}

TEST(ChangesBetweenTheOtherStates, RaiseNoFault) {
  TestUnit unit;
  unit.start();

  for (const char* const command : {"000#0205", "000#8005", "000#0200", "000#0105", "000#0105"})
    EXPECT_EQ(from("085#", unit.says(command)), Lines{}) << command;

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

TEST(NmtCommands, ForAnotherNodeAreIgnored) {
  TestUnit unit;
  unit.start_operational();

  for (const char* const command : {"000#8006", "000#0204", "000#8106", "000#80", "000#800500"})
    EXPECT_EQ(unit.says(command), Lines{}) << command;

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::Operational);
}

}  // namespace
}  // namespace device
