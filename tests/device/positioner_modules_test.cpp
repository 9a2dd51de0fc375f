// The function modules of the positioner: p0108 shows them, and the connections that they bring are made once.
#include "drive/values/positioner_connections.hpp"
#include "tests/device/storage_fixture.hpp"
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030;
constexpr std::uint32_t kCan = 0x20000000, kWithChannel = 0x20000100, kPositioning = 0x18;
constexpr std::uint16_t kSpeedSetpoint = 1160, kPositionSetpoint = 2530;

Configuration with_positioner() {
  Configuration configuration = unit_of(1);
  configuration.axes[0].drive.positioner = true;
  return configuration;
}

std::uint32_t ask_for(WiredDevice& unit, std::uint32_t modules) {
  EXPECT_EQ(unit.write_parameter(1, 9, 1, 2), 0U);
  const std::uint32_t code = unit.write_parameter(1, 108, modules, 4, 1);
  EXPECT_EQ(unit.write_parameter(1, 9, 0, 2), 0U);
  unit.cycle();
  return code;
}

TEST(PositionerModules, FollowTheConfigurationWhateverIsWritten) {
  WiredDevice unit{with_positioner()};
  EXPECT_EQ(unit.read_parameter(1, 108, 1), kWithChannel | kPositioning);
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel | kPositioning);
  for (const std::uint32_t written : {kCan, kCan | 0x08, kCan | 0x10, kCan | kPositioning}) {
    EXPECT_EQ(ask_for(unit, written), 0U) << std::hex << written;
    EXPECT_EQ(unit.read_parameter(1, 108, 1), kCan | kPositioning) << std::hex << written;
    EXPECT_EQ(unit.read_parameter(2, 108), kCan | kPositioning) << "bit 8 is free as ever";
  }
  EXPECT_EQ(ask_for(unit, kWithChannel | kPositioning | 0x00010000), kInvalidValue) << "technology controller";
}

TEST(PositionerModules, AreNotThereWithoutTheConfiguration) {
  WiredDevice unit;
  EXPECT_EQ(ask_for(unit, kWithChannel | kPositioning), kInvalidValue);
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel);
}

TEST(PositionerModules, AreThoseOfThePresentConfigurationAfterASave) {
  WiredDevice without;
  ASSERT_EQ(ask_for(without, kCan), 0U);
  ASSERT_EQ(without.download(kStore, 1, kSave, 4), 0U);
  NextLife with{without, with_positioner()};
  EXPECT_EQ(with.unit.device.axis().read(108).value(), kCan | kPositioning);

  WiredDevice former{with_positioner()};
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
  NextLife next{former, unit_of(1)};
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kWithChannel);
  next.unit.says("000#8105");
  next.unit.passes(100ms);
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kWithChannel) << "reset node";
}

TEST(PositionerConnections, AreThoseOfANewAxisWithTheModuleOnly) {
  const WiredDevice with{with_positioner()};
  const WiredDevice without;
  EXPECT_EQ(with.parameter(kSpeedSetpoint), own(2562));
  EXPECT_EQ(without.parameter(kSpeedSetpoint), 0.0);
}

TEST(PositionerConnections, AreMadeOnceOverWhatWasSavedWithoutTheModule) {
  WiredDevice former;
  ASSERT_EQ(former.write_parameter(2, kPositionSetpoint, 1, 4), 0U);
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);

  WiredDevice first{with_positioner()};
  ASSERT_TRUE(first.device.load_parameters(former.listener.image));
  EXPECT_EQ(first.parameter(kSpeedSetpoint), own(2562));
  EXPECT_EQ(first.parameter(kPositionSetpoint), 1.0) << "the user's";
  first.says("000#8105");
  first.passes(100ms);
  EXPECT_EQ(first.parameter(kSpeedSetpoint), own(2562)) << "reset node";
  ASSERT_EQ(first.write_parameter(2, kSpeedSetpoint, 0, 4), 0U);
  ASSERT_EQ(first.download(kStore, 1, kSave, 4), 0U);

  NextLife next{first, with_positioner()};
  EXPECT_EQ(next.unit.device.axis().read(kSpeedSetpoint).value(), 0.0) << "what the user has removed stays so";
  EXPECT_EQ(next.unit.download(kRestore, 1, kLoad, 4), 0U);
  EXPECT_EQ(next.unit.device.axis().read(kSpeedSetpoint).value(), own(2562));
}

TEST(PositionerConnections, AreMadeWhereOnlyTheAxisWasSaved) {
  WiredDevice former;
  ASSERT_EQ(former.write_parameter(2, 971, 1, 2), 0U);
  NextLife first{former, with_positioner()};
  EXPECT_EQ(first.unit.device.axis().read(kSpeedSetpoint).value(), own(2562));
}

TEST(PositionerConnections, LeaveTheInputsOfOtherAxesAlone) {
  Configuration two = unit_of(2);
  WiredDevice former{two};
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
  two.axes[1].drive.positioner = true;
  NextLife next{former, two};
  EXPECT_EQ(next.unit.device.axis(1).read(kSpeedSetpoint).value(), 0.0);
  EXPECT_EQ(next.unit.device.axis(2).read(kSpeedSetpoint).value(), own(2562));
}

}  // namespace
}  // namespace device
