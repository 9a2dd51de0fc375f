// A servo without extended setpoint channel (p0108 bit 8): its setpoints begin behind the ramp.
#include "tests/device/storage_fixture.hpp"
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

constexpr std::uint32_t kNoObject = 0x06020000, kInvalidValue = 0x06090030, kDeviceState = 0x08000022;
constexpr std::uint32_t kCan = 0x20000000, kWithChannel = 0x20000100;
constexpr std::uint32_t kControlword = 0x60400010, kVelocity = 0x60FF0020;

/// p0108[@p object - 1] of the control unit, written in device commissioning.
std::uint32_t ask_for(WiredDevice& unit, std::uint32_t modules, std::uint8_t object = 2) {
  EXPECT_EQ(unit.write_parameter(1, 9, 1, 2), 0U);
  const std::uint32_t code = unit.write_parameter(1, 108, modules, 4, static_cast<std::uint8_t>(object - 1));
  EXPECT_EQ(unit.write_parameter(1, 9, 0, 2), 0U);
  unit.cycle();
  return code;
}

/// A servo that is delivered without the channel.
Configuration without_channel() {
  Configuration configuration = unit_of(1);
  configuration.axes[0].drive.setpoint_channel = false;
  return configuration;
}

TEST(FunctionModules, AreInForceWhenCommissioningOfTheUnitEnds) {
  WiredDevice unit;
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel);
  EXPECT_EQ(unit.write_parameter(1, 108, kCan, 4, 1), kDeviceState) << "p0009 = 0";
  ASSERT_EQ(unit.write_parameter(1, 9, 1, 2), 0U);
  ASSERT_EQ(unit.write_parameter(1, 108, kCan, 4, 1), 0U);
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel) << "not yet";
  ASSERT_EQ(unit.write_parameter(1, 9, 0, 2), 0U);
  EXPECT_EQ(unit.read_parameter(2, 108), kCan);
  EXPECT_EQ(ask_for(unit, kWithChannel), 0U);
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel);
}

TEST(FunctionModules, AreRefusedWhereTheyDoNotExist) {
  WiredDevice unit{[] {
    Configuration c = unit_of(2);
    c.axes[1].drive.kind = drive::ObjectKind::Vector;
    return c;
  }()};
  for (unsigned bit = 0; bit < 32; ++bit) {
    if (bit == 8 || bit == 29) continue;
    EXPECT_EQ(ask_for(unit, kWithChannel | 1U << bit), kInvalidValue) << "bit " << bit;
  }
  EXPECT_EQ(ask_for(unit, 0x00000100), kInvalidValue) << "CAN stays";
  EXPECT_EQ(ask_for(unit, kCan, 3), kInvalidValue) << "a vector axis has the channel always";
  EXPECT_EQ(ask_for(unit, kWithChannel, 3), 0U);
  EXPECT_EQ(ask_for(unit, kCan, 4), kInvalidValue) << "no such drive object";
  EXPECT_EQ(ask_for(unit, 0, 1), kInvalidValue) << "the control unit";
  EXPECT_EQ(unit.read_parameter(1, 108, 1), kWithChannel);
  EXPECT_EQ(unit.read_parameter(2, 108), kWithChannel);
}

TEST(SetpointChannelOff, LeadsTheTargetVelocityPastTheRamp) {
  WiredDevice unit;
  ASSERT_EQ(ask_for(unit, kCan), 0U);
  EXPECT_EQ(unit.parameter(1155), own(8860, 1));
  EXPECT_EQ(unit.parameter(2151), own(1438));
  unit.enter();
  unit.switch_on();
  ASSERT_EQ(unit.download(0x60FF, 0, increments(1500), 4), 0U);
  unit.cycle();
  EXPECT_NEAR(unit.double_word(0x606B), bus_speed(1500), bus_speed(1)) << "p1120 = 10 s would take 5 s";
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(5));
  EXPECT_NE(unit.statusword() & 0x0400, 0) << "target reached";
  ASSERT_EQ(unit.download(0x60FF, 0, increments(300), 4), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(300), bus_speed(5)) << "p1121 is for OFF1";
}

TEST(SetpointChannelOff, BrakesOff1OnItsRamp) {
  WiredDevice unit{without_channel()};
  ASSERT_EQ(unit.download(0x6084, 0, increments(3000), 4), 0U) << "p1121: 1 s from 3000 rpm";
  const double from_maximum = unit.parameter(1082) / 3000.0;
  EXPECT_NEAR(unit.parameter(1121), from_maximum, 1e-3);
  unit.enter();
  unit.switch_on();
  ASSERT_EQ(unit.download(0x60FF, 0, increments(3000), 4), 0U);
  unit.passes(1s);
  ASSERT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(5));
  ASSERT_EQ(unit.download(0x6040, 0, 0x0006, 2), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(60));
  EXPECT_TRUE(unit.reaches(0x006F, 0x0021, 2s)) << "Ready to switch on";
}

TEST(SetpointChannelOff, LeavesNothingOfTheChannel) {
  WiredDevice unit{without_channel()};
  for (const auto& [index, sub_index, size] :
       {std::tuple{0x6046, 1, 4U}, {0x6048, 2, 2U}, {0x6083, 0, 4U}, {0x6086, 0, 2U}}) {
    const auto sub = static_cast<std::uint8_t>(sub_index);
    EXPECT_EQ(unit.upload(static_cast<std::uint16_t>(index), sub).abort_code, kNoObject) << std::hex << index;
    EXPECT_EQ(unit.download(static_cast<std::uint16_t>(index), sub, 3, size), kNoObject) << std::hex << index;
  }
  for (const auto& [index, sub_index] : {std::pair{0x6046, 2}, {0x6048, 1}, {0x6084, 0}, {0x6085, 0}})
    EXPECT_EQ(unit.upload(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub_index)).abort_code, 0U)
        << std::hex << index;
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{
           1001, 1020, 1055, 1058, 1070, 1075, 1080, 1110, 1113, 1115, 1120, 1122, 1130, 1134, 1140, 1142}) {
    EXPECT_EQ(unit.device.axis().read(number).error().reason, drive::Refusal::NoParameter) << 'p' << number;
    EXPECT_EQ(unit.write_parameter(2, number, 0, 4), kNoObject) << 'p' << number;
  }
  for (const std::uint16_t number :
       std::initializer_list<std::uint16_t>{1082, 1083, 1085, 1086, 1088, 1121, 1135, 1136, 1155, 1160})
    EXPECT_TRUE(unit.device.axis().read(number).has_value()) << 'p' << number;
}

TEST(SetpointChannelOff, TakesTheRpmOfVelocityModeWithoutItsRampBits) {
  WiredDevice unit{without_channel()};
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  unit.cycle();
  EXPECT_EQ(unit.parameter(1155), own(8792));
  unit.enter();
  unit.switch_on();
  ASSERT_EQ(unit.download(0x6042, 0, 600, 2), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(600), bus_speed(2)) << "with 000Fh";
}

TEST(SetpointChannelOff, FollowsTheMappingsAndLeavesWhatTheUserHasWired) {
  WiredDevice unit{without_channel()};
  unit.unmap_all();
  EXPECT_EQ(unit.parameter(1155), own(8796));
  unit.map_rpdo(1, {kControlword, 0x58000010, kVelocity});
  EXPECT_EQ(unit.parameter(1155), own(8860, 2));
  ASSERT_EQ(unit.wire(2, 1155, {8850, drive::kOwnObject, 1}), 0U);
  unit.unmap_all();
  EXPECT_EQ(unit.parameter(1155), own(8850, 1));
  ASSERT_EQ(ask_for(unit, kWithChannel), 0U);
  EXPECT_EQ(unit.parameter(1155), own(8850, 1)) << "the user's";
  EXPECT_EQ(unit.parameter(1070), own(8796));
}

TEST(SetpointChannelOff, IsSavedAndGoesWithARestore) {
  WiredDevice unit;
  ASSERT_EQ(ask_for(unit, kCan), 0U);
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit, unit_of(1)};
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kCan);
  EXPECT_EQ(next.unit.device.axis().read(1155).value(), own(8860, 1));
  next.unit.says("000#8105");
  next.unit.passes(100ms);
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kCan) << "reset node";
  EXPECT_EQ(next.unit.download(kRestore, 3, kLoad, 4), 0U);
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kCan) << "no object of 6000h to 9FFFh";
  EXPECT_EQ(next.unit.download(kRestore, 1, kLoad, 4), 0U);
  EXPECT_EQ(next.unit.device.axis().read(108).value(), kWithChannel);
  EXPECT_EQ(next.unit.device.axis().read(1155).value(), 0.0);
  EXPECT_EQ(next.unit.device.axis().read(1070).value(), own(8860, 1));
}

TEST(SetpointChannelOff, SavesTheValuesOfTheChannelForLater) {
  constexpr std::uint32_t kFive = 0x40A00000;  // as F32
  WiredDevice unit;
  ASSERT_EQ(unit.write_parameter(2, 1120, kFive, 4), 0U);
  ASSERT_EQ(ask_for(unit, kCan), 0U);
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  unit.says("000#8105");
  unit.passes(100ms);
  ASSERT_EQ(ask_for(unit, kWithChannel), 0U);
  EXPECT_EQ(unit.read_parameter(2, 1120), kFive);
  EXPECT_EQ(unit.read_parameter(2, 1142), 1U);
}

TEST(SetpointChannelOff, KeepsThePresetsOfTheChannelForLater) {
  Configuration configuration = unit_of(1);
  configuration.axes[0].presets = {{1120, 0.5}};
  WiredDevice unit{configuration};
  ASSERT_EQ(ask_for(unit, kCan), 0U);
  EXPECT_EQ(unit.download(kRestore, 3, kLoad, 4), 0U);
  ASSERT_EQ(ask_for(unit, kWithChannel), 0U);
  EXPECT_NEAR(unit.parameter(1120), 0.5, 1e-6);
}

}  // namespace
}  // namespace device
