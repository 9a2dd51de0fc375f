// Gear, feed, polarity, limits and probes, as a master sees them.
#include <cmath>

#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

TEST(Quantities, GearAndFeedScalePositionsAndVelocities) {
  TestDevice device;
  device.start();
  device.write(0x6091, 1, 10);  // ten revolutions of the motor for one of the shaft
  device.write(0x6092, 1, 3600);
  device.write(0x6081, 3600);
  device.write(0x6083, 36000);
  device.write(0x6084, 36000);
  device.says("000#0105");
  device.write(0x6060, 1);
  for (const int word : {0x06, 0x07, 0x0F}) device.write(0x6040, word);
  device.passes(20ms);
  device.write(0x607A, 1800);
  device.write(0x6040, 0x1F);
  device.passes(300ms);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 3600.0, 20.0);
  EXPECT_TRUE(device.reaches(0x0400, 0x0400, 2000ms));
  device.passes(200ms);
  EXPECT_EQ(device.position(), 1800);
  EXPECT_NEAR(static_cast<double>(device.read(0x6063)), 5.0 * kRevolution, 20.0);
}

TEST(Quantities, AreChangedOutsideOperationEnabledOnly) {
  TestDevice device;
  device.enable(Mode::ProfilePosition);
  for (const std::uint16_t index : {std::uint16_t{0x6091}, std::uint16_t{0x6092}})
    EXPECT_EQ(device.write(index, 1, 2), 0x08000022U);
  EXPECT_EQ(device.write(0x607E, 0x80), 0x08000022U);
  device.write(0x6040, 0);
  EXPECT_EQ(device.write(0x607E, 0x80), 0U);
}

TEST(Polarity, InvertsPositionAndVelocityEachForItself) {
  for (const std::int64_t polarity : {0x00, 0x80, 0x40, 0xC0}) {
    TestDevice device;
    device.start();
    ASSERT_EQ(device.write(0x607E, polarity), 0U);
    device.says("000#0105");
    device.write(0x6060, 3);
    for (const int word : {0x06, 0x07, 0x0F}) device.write(0x6040, word);
    device.write(0x60FF, 100000);
    device.passes(500ms);
    EXPECT_NEAR(static_cast<double>(device.velocity()), 100000.0, 1000.0);
    const bool turns_back = (polarity & 0x40) != 0, shows_back = (polarity & 0x80) != 0;
    EXPECT_EQ(device.read(0x6063) < 0, turns_back) << polarity;
    EXPECT_EQ(device.position() < 0, turns_back != shows_back) << polarity;
  }
}

TEST(Limits, OfSoftwareClipTargetsOfAHomedAxis) {
  TestDevice device;
  device.enable(Mode::Homing);
  device.write(0x6098, 37);
  device.write(0x6040, 0x1F);
  ASSERT_TRUE(device.reaches(0x3400, 0x1400, 100ms));
  device.write(0x607D, 1, -5000);
  device.write(0x607D, 2, 10000);
  device.write(0x6040, 0x0F);
  device.write(0x6060, 1);
  device.write(0x607A, 50000);
  device.write(0x6040, 0x1F);
  device.passes(1s);
  EXPECT_EQ(device.position(), 10000);
  EXPECT_EQ(device.statusword() & 0x0800, 0x0800);
}

TEST(Limits, OfSpeedHoldEveryMode) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  device.write(0x607F, 50000);
  device.write(0x60FF, 200000);
  device.passes(500ms);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 50000.0, 500.0);
  EXPECT_EQ(device.statusword() & 0x0800, 0x0800);
  device.write(0x6060, 4);
  device.write(0x6071, 300);
  device.passes(1s);
  EXPECT_LT(static_cast<double>(device.velocity()), 53000.0);
}

TEST(Limits, OfTorqueHold) {
  TestDevice device;
  device.enable(Mode::ProfileTorque);
  device.write(0x60E0, 150);
  device.write(0x6071, 400);
  device.passes(100ms);
  EXPECT_LE(device.read(0x6077), 152);
}

TEST(LimitSwitch, StopsWhatLeadsTowardsItAndLetsAwayFromIt) {
  Configuration configuration{.node_id = 5};
  configuration.axes.front().switches.set(Signal::PositiveLimit, {.from = 3.0, .to = 1e6});
  TestDevice device{configuration};
  device.enable(Mode::ProfileVelocity);
  device.write(0x60FF, 200000);
  device.passes(2s);
  EXPECT_EQ(device.read(0x60FD) & 0x2, 0x2);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 0.0, 100.0);
  EXPECT_EQ(device.statusword() & 0x6F, 0x27) << "no fault";
  const std::int64_t stopped = device.position();
  device.write(0x60FF, -100000);
  device.passes(1s);
  EXPECT_LT(device.position(), stopped - 50000);
}

TEST(TouchProbe, KeepsTheExactPositionOfAnEdge) {
  Configuration configuration{.node_id = 5};
  configuration.axes.front().switches.set(Signal::Probe1, {.from = 1.23, .to = 2.0});
  TestDevice device{configuration};
  device.enable(Mode::ProfileVelocity);
  ASSERT_EQ(device.write(0x60B8, 0x0031), 0U);
  EXPECT_EQ(device.read(0x60B9) & 0x1, 0x1);
  device.write(0x60FF, 300000);
  device.passes(1s);
  EXPECT_EQ(device.read(0x60B9) & 0x7, 0x7);
  EXPECT_NEAR(static_cast<double>(device.read(0x60BA)), 1.23 * kRevolution, 1.0);
  EXPECT_NEAR(static_cast<double>(device.read(0x60BB)), 2.0 * kRevolution, 1.0);
  EXPECT_EQ(device.read(0x60D5), 1);
}

TEST(Position, IsShownAnewAtRestInOtherUnits) {
  TestDevice device;
  device.enable(Mode::ProfilePosition);
  device.write(0x607A, 3 * kRevolution);
  device.write(0x6040, 0x1F);
  ASSERT_TRUE(device.reaches(0x0400, 0x0400, 5s));
  device.write(0x6040, 0);
  device.passes(2s);
  EXPECT_NEAR(static_cast<double>(device.position()), 3.0 * kRevolution, 100.0) << "where it has coasted to";
  ASSERT_EQ(device.write(0x607B, 2, kRevolution - 1), 0U);
  EXPECT_LT(device.position(), kRevolution);
  ASSERT_EQ(device.write(0x607B, 2, 0x7FFFFFFF), 0U);
  ASSERT_EQ(device.write(0x6092, 1, 3600), 0U);
  EXPECT_NEAR(static_cast<double>(device.position()), 3.0 * 3600, 6.0);
}

TEST(DigitalOutputs, KeepTheBrakeClosedWhereTheMaskHasIt) {
  Configuration configuration{.node_id = 5};
  configuration.axes.front().drive.load.brake.torque = 100.0;
  TestDevice device{configuration};
  device.enable(Mode::ProfileVelocity);
  device.write(0x60FE, 1, 1);
  device.write(0x60FF, 200000);
  device.passes(1s);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 200000.0, 1000.0) << "the mask leaves it to the drive";
  device.write(0x60FE, 2, 1);
  device.passes(300ms);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 0.0, 100.0);
  device.write(0x60FE, 1, 0);
  device.passes(1s);
  EXPECT_NEAR(static_cast<double>(device.velocity()), 200000.0, 1000.0);
}

}  // namespace
}  // namespace cia402
