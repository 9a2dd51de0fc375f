// Modes of operation as a master sees them: 6060h by SDO and by RPDO, velocity mode, torque mode.
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

constexpr std::uint32_t kControlword = 0x60400010, kMode = 0x60600008, kTorque = 0x60710010,
                        kVelocity = 0x60FF0020;
constexpr std::uint32_t kVlVelocity = 0x60420010;

Configuration configured(std::vector<ParameterPreset> presets, drive::ObjectKind kind = drive::ObjectKind::Servo) {
  Configuration configuration = unit_of(1, kind);
  configuration.axes[0].presets = std::move(presets);
  return configuration;
}

struct ModeRow {
  int asked, shown;
};
void expect_modes(WiredDevice& unit, std::initializer_list<ModeRow> rows) {
  for (const ModeRow& row : rows) {
    EXPECT_EQ(unit.download(0x6060, 0, static_cast<std::uint8_t>(row.asked), 1), 0U) << "never refused";
    EXPECT_EQ(static_cast<std::int8_t>(unit.upload(0x6060).number()), row.asked);
    unit.cycle();
    EXPECT_EQ(static_cast<std::int8_t>(unit.upload(0x6061).number()), row.shown) << row.asked;
    EXPECT_EQ(static_cast<std::int16_t>(unit.read_parameter(2, 8762)), row.shown) << "r8762";
  }
}

TEST(Modes, OfAServoAreThoseOfP1300AndTheVelocityMode) {
  WiredDevice unit;
  expect_modes(unit, {{3, 3},
                      {4, 4},
                      {2, 2},
                      {6, 2},
                      {1, 2},
                      {0, 2},
                      {-5, 2},
                      {-20, -20},
                      {-22, -22},
                      {-21, -22},
                      {127, -22},
                      {-128, -22},
                      {3, 3},
                      {2, 2},
                      {3, 3}});
  for (const auto& [asked, p1300] :
       {std::pair{4, 23U}, std::pair{-20, 20U}, std::pair{-22, 22U}, std::pair{2, 21U}}) {
    ASSERT_EQ(unit.download(0x6060, 0, static_cast<std::uint8_t>(asked), 1), 0U);
    EXPECT_EQ(unit.read_parameter(2, 1300), p1300) << asked;
  }
}

TEST(Modes, OfAVectorDriveAreTheUfCharacteristicsToo) {
  WiredDevice unit{configured({}, drive::ObjectKind::Vector)};
  expect_modes(unit, {{3, 3}, {-1, -1}, {-5, -5}, {-7, -7}, {-19, -19}, {0, 0}, {4, 4}, {-20, -20}, {2, 2}});
}

TEST(Modes, FollowP1300AndLeaveVelocityModeByIt) {
  WiredDevice unit;
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  ASSERT_EQ(unit.write_parameter(2, 1300, 21, 2), 0U);
  EXPECT_EQ(unit.upload(0x6060).number(), 3U);
  EXPECT_EQ(unit.upload(0x6061).number(), 3U);
  unit.cycle();
  EXPECT_EQ(unit.parameter(1070), own(8860, 1)) << "60FFh leads";
  ASSERT_EQ(unit.write_parameter(2, 1300, 23, 2), 0U);
  EXPECT_EQ(unit.upload(0x6060).number(), 4U);
}

TEST(Modes, AreNotTakenOverSdoWithThePulsesOn) {
  WiredDevice unit;
  unit.switch_on();
  expect_modes(unit, {{4, 3}, {2, 3}, {-20, 3}});
  EXPECT_EQ(unit.read_parameter(2, 1300), 21U);
}

TEST(VelocityMode, MovesWithBits4To6Only) {
  WiredDevice unit{configured({{1120, 0.1}, {1121, 0.1}})};
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  ASSERT_EQ(unit.download(0x6042, 0, 600, 2), 0U);
  unit.switch_on();
  for (const std::uint32_t word : {0x000FU, 0x002FU, 0x006FU, 0x003FU}) {
    ASSERT_EQ(unit.download(0x6040, 0, word, 2), 0U);
    unit.passes(300ms);
    EXPECT_EQ(unit.word(0x6044), 0) << std::hex << word;
  }
  ASSERT_EQ(unit.download(0x6040, 0, 0x007F, 2), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.word(0x6044), 600, 1);
  EXPECT_NEAR(unit.word(0x6043), 600, 1);

  ASSERT_EQ(unit.download(0x6040, 0, 0x005F, 2), 0U);  // the ramp stands
  ASSERT_EQ(unit.download(0x6042, 0, 100, 2), 0U);
  unit.passes(300ms);
  EXPECT_NEAR(unit.word(0x6044), 600, 1);
  ASSERT_EQ(unit.download(0x6040, 0, 0x007F, 2), 0U);
  unit.passes(300ms);
  EXPECT_NEAR(unit.word(0x6044), 100, 1);
  ASSERT_EQ(unit.download(0x6042, 0, static_cast<std::uint16_t>(-700), 2), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.word(0x6044), -700, 1);
  ASSERT_EQ(unit.download(0x6040, 0, 0x003F, 2), 0U);  // no reference
  unit.passes(500ms);
  EXPECT_EQ(unit.word(0x6043), 0);
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
}

TEST(VelocityMode, HasTheLimitsOf6046AndTheRampOf6048) {
  WiredDevice unit;
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  ASSERT_EQ(unit.download(0x6046, 1, 50, 4), 0U);
  ASSERT_EQ(unit.download(0x6046, 2, 900, 4), 0U);
  ASSERT_EQ(unit.download(0x6048, 2, 1, 2), 0U);
  unit.switch_on(0x007F);
  unit.passes(500ms);
  EXPECT_NEAR(unit.word(0x6043), 50, 1) << "at least the minimum";
  ASSERT_EQ(unit.download(0x6042, 0, 32767, 2), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.word(0x6043), 500, 8) << "900 rpm/s";
  unit.passes(1s);
  EXPECT_NEAR(unit.word(0x6043), 900, 1);
  ASSERT_EQ(unit.download(0x6048, 2, 0, 2), 0U);
  ASSERT_EQ(unit.download(0x6042, 0, 0x8000, 2), 0U);
  unit.passes(2500ms + 10s);
  EXPECT_NEAR(unit.word(0x6043), -900, 1);
}

TEST(VelocityMode, IgnoresTheTargetVelocityAndOtherModesIgnoreItsBits) {
  WiredDevice unit{configured({{1120, 0.1}, {1121, 0.1}})};
  unit.switch_on(0x000F);
  ASSERT_EQ(unit.download(0x60FF, 0, increments(300), 4), 0U);
  ASSERT_EQ(unit.download(0x6042, 0, 900, 2), 0U);
  unit.passes(300ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(300), bus_speed(1)) << "profile velocity needs no bits 4 to 6";
}

/// A unit whose RPDO 1 has 6040h, 6060h, 6071h and RPDO 3 60FFh, in operation.
struct Toggle : WiredDevice {
  explicit Toggle(const Configuration& configuration = configured({{1120, 0.5}, {1121, 0.5}}))
      : WiredDevice{configuration} {
    unmap_all();
    map_rpdo(1, {kControlword, kMode, kTorque});
    map_rpdo(3, {kVelocity, kVlVelocity});
    enter();
    for (const std::uint16_t word : std::initializer_list<std::uint16_t>{0x0006, 0x0007, 0x000F})
      send(word, 3, 0), cycle();
  }
  void send(std::uint16_t controlword, std::int8_t mode, std::int16_t torque) {
    canopen::Frame frame{.id = 0x205, .length = 5};
    canopen::store(&frame.data[0], controlword);
    frame.data[2] = static_cast<std::uint8_t>(mode);
    canopen::store(&frame.data[3], torque);
    says(fakes::candump(frame));
  }
  void send_speed(double rpm) {
    canopen::Frame frame{.id = 0x405, .length = 6};
    canopen::store(&frame.data[0], static_cast<std::int32_t>(std::lround(bus_speed(rpm))));
    canopen::store(&frame.data[4], static_cast<std::int16_t>(rpm));
    says(fakes::candump(frame));
  }
  double rpm() const { return device.axis().actual().speed / drive::kRpm; }
  double torque() const { return device.axis().actual().torque; }
  int shown() { return static_cast<std::int8_t>(upload(0x6061).number()); }
};

TEST(ModeByRpdo, TogglesInOperationWithoutAJump) {
  Toggle unit;
  unit.device.set_load_torque(1, 1.0, unit.now);
  unit.send_speed(600);
  unit.passes(2s);
  ASSERT_NEAR(unit.rpm(), 600, 1);
  const double rated = unit.parameter(333);
  for (const int mode : {4, 3, 4, 2, 4, 3, 2, 3}) {
    const double torque = unit.torque();
    const auto asked = static_cast<std::int16_t>(std::lround(torque / rated * 1000));
    unit.send(0x007F, static_cast<std::int8_t>(mode), asked);
    for (int i = 0; i < 10; ++i) {
      unit.passes(Device::kCycle);
      EXPECT_NEAR(unit.torque(), torque, 0.05 * rated) << "to " << mode << ", cycle " << i;
      EXPECT_NEAR(unit.rpm(), 600, 12) << "to " << mode << ", cycle " << i;
    }
    EXPECT_EQ(unit.shown(), mode);
    EXPECT_EQ(unit.parameter(1300), 21.0) << "p1300 keeps its value";
    unit.passes(400ms);
  }
}

TEST(ModeByRpdo, LeavesTheActiveOneWhereItIsNotPossible) {
  Toggle unit;
  for (const int mode : {0, 1, 6, -5, 100}) {
    unit.send(0x000F, static_cast<std::int8_t>(mode), 0);
    unit.cycle();
    EXPECT_EQ(unit.shown(), 3) << mode;
    EXPECT_EQ(static_cast<std::int8_t>(unit.upload(0x6060).number()), mode);
  }
  unit.send(0x000F, 4, 0);
  unit.cycle();
  EXPECT_EQ(unit.shown(), 4);
  unit.send(0x000F, 6, 0);
  unit.cycle();
  EXPECT_EQ(unit.shown(), 4);
}

TEST(ModeByRpdo, ToTorqueWithoutEncoderIsF07430) {
  Configuration configuration = configured({{1300, 20}});
  configuration.axes[0].drive.machine.encoder.type = motor::EncoderType::None;
  Toggle unit{configuration};
  ASSERT_EQ(unit.shown(), -20);
  unit.send(0x000F, 4, 0);
  unit.cycle();
  EXPECT_EQ(unit.shown(), -20);
  EXPECT_EQ(unit.read_parameter(2, 945), 7430U);
}

TEST(TorqueMode, FollowsTheTargetTorque) {
  WiredDevice unit;
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);
  unit.switch_on();
  for (const int target : {100, -250, 800, 0}) {
    ASSERT_EQ(unit.download(0x6071, 0, static_cast<std::uint16_t>(target), 2), 0U);
    unit.passes(20ms);
    EXPECT_NEAR(unit.word(0x6074), target, 1);
    EXPECT_NEAR(unit.word(0x6077), target, 20);
  }
  ASSERT_EQ(unit.download(0x6072, 0, 300, 2), 0U);
  for (const auto& [target, gets] : {std::pair{1000, 300}, std::pair{-1000, -300}, std::pair{32767, 300}}) {
    ASSERT_EQ(unit.download(0x6071, 0, static_cast<std::uint16_t>(target), 2), 0U);
    unit.passes(20ms);
    EXPECT_NEAR(unit.word(0x6077), gets, 20) << target;
    EXPECT_NE(unit.statusword() & 0x0800, 0) << "the limit is reached";
  }
}

}  // namespace
}  // namespace device
