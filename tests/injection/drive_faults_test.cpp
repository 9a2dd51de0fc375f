#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

/// Node 5, turning at 300 rpm.
class DriveFaultsTest : public testing::Test {
 protected:
  DriveFaultsTest() {
    unit.enable();
    unit.says("305#0F0000004001");
    unit.passes(2s);
  }
  FaultyUnit unit;
};

TEST_F(DriveFaultsTest, FreezeTheActualValues) {
  const auto id = unit.inject("drive.frozen axis=1");
  unit.passes(10ms);
  const auto turning = unit.number_at(0x606C);
  ASSERT_GT(turning, 20000000);
  unit.says("305#0F0000000000");
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x606C), turning);
  EXPECT_LT(unit.device.axis(1).actual().speed, 1.0);  // the shaft stands
  unit.faults.remove(id);
  unit.passes(10ms);
  EXPECT_LT(unit.number_at(0x606C), 100000);
}

TEST_F(DriveFaultsTest, KeepAControlwordInForce) {
  const auto id = unit.inject("drive.ignores-controlword");
  unit.passes(10ms);
  unit.says("205#0000");
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x27);
  unit.faults.remove(id);
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x40);
}

TEST_F(DriveFaultsTest, HoldABitOfTheStatusword) {
  unit.inject("drive.status-bit bit=3 value=1 for_ms=50");
  unit.passes(20ms);
  EXPECT_EQ(unit.number_at(0x6041) & 0x8, 0x8);
  unit.passes(100ms);
  EXPECT_EQ(unit.number_at(0x6041) & 0x8, 0);
}

TEST_F(DriveFaultsTest, KeepTheDriveFromAState) {
  unit.says("205#0600");
  unit.passes(2s);
  ASSERT_EQ(unit.number_at(0x6041) & 0x6F, 0x21);
  const auto id = unit.inject("drive.never state=operation-enabled");
  unit.turns("205#0700");
  unit.turns("205#0F00");
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x23);
  unit.faults.remove(id);
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x27);
}

TEST_F(DriveFaultsTest, WorkOnAControlwordOverSdoToo) {
  unit.inject("drive.never state=switched-on");
  unit.says("205#0000");
  unit.passes(1s);
  for (const char* const word : {"605#2B40600006000000", "605#2B40600007000000"}) {
    unit.says(word);
    unit.passes(100ms);
  }
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x21);
}

TEST_F(DriveFaultsTest, StayAsTheyAreWhenAnotherIsTakenBack) {
  const auto other = unit.inject("heartbeat.gap");
  unit.inject("drive.frozen");
  unit.inject("drive.ignores-controlword");
  unit.passes(10ms);
  const auto turning = unit.number_at(0x606C);
  unit.says("305#000000000000");
  unit.passes(100ms);
  unit.faults.remove(other);
  unit.passes(1s);
  EXPECT_EQ(unit.number_at(0x606C), turning);
  EXPECT_EQ(unit.number_at(0x6041) & 0x6F, 0x27);
}

TEST(RestingUnit, ShowsAFaultOfTheDriveAndItsEnd) {
  FaultyUnit unit;
  unit.start_operational();
  unit.passes(10s);
  ASSERT_TRUE(unit.device.runner().is_resting());
  unit.inject("drive.status-bit bit=3 value=1 for_ms=50");
  unit.passes(20ms);
  EXPECT_EQ(unit.number_at(0x6041) & 0x8, 0x8);
  unit.passes(100ms);
  EXPECT_EQ(unit.number_at(0x6041) & 0x8, 0);
  unit.inject("drive.status-bit bit=3 value=1 times=3");
  unit.passes(100ms);
  EXPECT_EQ(unit.number_at(0x6041) & 0x8, 0);
  EXPECT_TRUE(unit.device.runner().is_resting());
}

TEST(RestingUnit, CountsCyclesForAFault) {
  FaultyUnit unit;
  unit.start();
  unit.passes(10s);
  unit.inject("node.reset after=10");
  EXPECT_EQ(unit.passes(40ms), Lines{});
  EXPECT_EQ(unit.passes(8ms), Lines{"705#00"});
}

TEST_F(DriveFaultsTest, OfAnAxisThatIsNotThereAreRefused) {
  const auto id = unit.faults.add(fault_of("drive.frozen axis=3"));
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error(), "axis: expected 1 to 1, the axes of the unit, got 3");
}

}  // namespace
}  // namespace injection
