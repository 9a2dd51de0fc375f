#include <array>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint32_t kTooHigh = 0x06090031;
constexpr std::uint32_t kTooLow = 0x06090032;
constexpr std::uint32_t kDeviceState = 0x08000022;

/// A ramp object, its parameter and the longest time of it.
struct Ramp {
  std::uint16_t index, parameter;
  double longest;
};
constexpr std::array kRamps{Ramp{0x6083, 1120, 999999.0}, Ramp{0x6084, 1121, 999999.0}, Ramp{0x6085, 1135, 600.0}};

TEST(RampObjects, ShowTheRampTimesAsSlopes) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 10.0}, {1121, 1.0}, {1135, 0.5}})};
  unit.start();

  EXPECT_EQ(unit.upload(0x6083).number(), 20971520U);
  EXPECT_EQ(unit.upload(0x6084).number(), 209715200U);
  EXPECT_EQ(unit.upload(0x6085).number(), 419430400U);
}

TEST(RampObjects, SetTheRampTimesFromSlopes) {
  TestUnit unit{unit_with({{1082, 3000.0}})};
  unit.start();

  for (const Ramp& ramp : kRamps) {
    EXPECT_EQ(unit.download(ramp.index, 0, 104857600, 4), 0U);
    EXPECT_DOUBLE_EQ(unit.device.axis().read(ramp.parameter).value(), 2.0);
    EXPECT_EQ(unit.upload(ramp.index).number(), 104857600U);
  }
}

TEST(RampObjects, ShowARampOfNoTimeAsTheHighestSlope) {
  TestUnit unit{unit_with({{1120, 0.0}, {1121, 0.0}, {1135, 0.0}})};
  unit.start();

  for (const Ramp& ramp : kRamps) {
    EXPECT_EQ(unit.upload(ramp.index).number(), 0xFFFFFFFF);
    EXPECT_EQ(unit.download(ramp.index, 0, 0xFFFFFFFF, 4), 0U);
    EXPECT_EQ(unit.device.axis().read(ramp.parameter).value(), 0.0);
  }
}

TEST(RampObjects, RefuseASlopeOfZero) {
  TestUnit unit{unit_with({{1120, 3.0}, {1121, 3.0}, {1135, 3.0}})};
  unit.start();

  for (const Ramp& ramp : kRamps) {
    EXPECT_EQ(unit.download(ramp.index, 0, 0, 4), kTooLow);
    EXPECT_EQ(unit.device.axis().read(ramp.parameter).value(), 3.0);
  }
}

TEST(RampObjects, ClipASlopeThatWouldTakeLongerThanTheLongestTime) {
  TestUnit unit;
  unit.start();

  for (const Ramp& ramp : kRamps) {
    EXPECT_EQ(unit.download(ramp.index, 0, 1, 4), 0U);
    EXPECT_EQ(unit.device.axis().read(ramp.parameter).value(), ramp.longest);
  }
}

TEST(RampObjects, CanBeWrittenWhileTheMotorTurns) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(1000, 1s);

  for (const Ramp& ramp : kRamps) EXPECT_EQ(unit.download(ramp.index, 0, 104857600, 4), 0U);
}

TEST(AbortConnectionOption, IsParameter8641WithItsLimits) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x6007).number(), 3U);
  for (std::uint32_t value = 0; value <= 3; ++value) {
    EXPECT_EQ(unit.download(0x6007, 0, value, 2), 0U);
    EXPECT_EQ(unit.upload(0x6007).number(), value);
    EXPECT_EQ(unit.device.axis().read(8641).value(), value);
  }
  EXPECT_EQ(unit.download(0x6007, 0, 4, 2), kTooHigh);
  EXPECT_EQ(unit.download(0x6007, 0, 0xFFFF, 2), kTooLow);
  EXPECT_EQ(unit.upload(0x6007).number(), 3U);
}

TEST(AbortConnectionOption, CannotBeWrittenWithThePulsesEnabled) {
  TestUnit unit;
  unit.enable();

  EXPECT_EQ(unit.download(0x6007, 0, 1, 2), kDeviceState);
  EXPECT_EQ(unit.upload(0x6007).number(), 3U);
}

TEST(HaltOption, IsParameter8791WithItsLimits) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x605D).number(), 0xFFFFU);
  for (const std::uint32_t value : {0x0000U, 0x0001U, 0x0002U, 0x0003U, 0xFFFFU}) {
    EXPECT_EQ(unit.download(0x605D, 0, value, 2), 0U);
    EXPECT_EQ(unit.upload(0x605D).number(), value);
  }
  EXPECT_EQ(unit.download(0x605D, 0, 4, 2), kTooHigh);
  EXPECT_EQ(unit.download(0x605D, 0, 0xFFFE, 2), kTooLow);
  EXPECT_EQ(unit.device.axis().read(8791).value(), -1.0);
}

TEST(ModesOfOperation, KeepAnyRequestAndStayInProfileVelocity) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x6060).number(), 3U);
  for (std::uint32_t mode = 0; mode <= 0xFF; ++mode) {
    EXPECT_EQ(unit.download(0x6060, 0, mode, 1), 0U);
    EXPECT_EQ(unit.upload(0x6060).number(), mode);
    EXPECT_EQ(unit.upload(0x6061).number(), 3U);
  }
}

/// An object in rpm or s, its parameter and a value for both.
struct Plain {
  std::uint16_t index;
  std::uint8_t sub_index;
  unsigned size;
  std::uint16_t parameter;
};
constexpr std::array kPlain{Plain{0x6046, 1, 4, 1080}, Plain{0x6046, 2, 4, 1082}, Plain{0x6048, 1, 4, 1082},
                            Plain{0x6048, 2, 2, 1120}};

TEST(VelocityObjects, AreTheLimitsAndTheRampOfTheSetpointChannel) {
  TestUnit unit{unit_with({{1080, 10.0}, {1082, 2999.6}, {1120, 2.4}})};
  unit.start();

  EXPECT_EQ(unit.upload(0x6046, 1).number(), 10U);
  EXPECT_EQ(unit.upload(0x6046, 2).number(), 3000U);
  EXPECT_EQ(unit.upload(0x6048, 1).number(), 3000U);
  EXPECT_EQ(unit.upload(0x6048, 2).number(), 2U);
  for (const Plain& object : kPlain) {
    EXPECT_EQ(unit.download(object.index, object.sub_index, 1500, object.size), 0U);
    EXPECT_EQ(unit.device.axis().read(object.parameter).value(), 1500.0);
  }
}

TEST(VelocityObjects, ShowTheLongestTimeThatTheyCan) {
  TestUnit unit{unit_with({{1120, 999999.0}})};
  unit.start();

  EXPECT_EQ(unit.upload(0x6048, 2).number(), 0xFFFFU);
}

TEST(VelocityObjects, ShowTheSpeedInRpm) {
  TestUnit unit{unit_with({{1120, 0.5}})};
  unit.turn_at(1500.0, 2s);

  EXPECT_NEAR(static_cast<double>(unit.upload(0x6043).number()), 1500.0, 2.0);
  EXPECT_NEAR(static_cast<double>(unit.upload(0x6044).number()), 1500.0, 2.0);
  EXPECT_NEAR(static_cast<double>(unit.upload(0x6069).number()), bus_speed(1500.0), bus_speed(2.0));
}

TEST(MotionProfileType, IsTheKindOfRamp) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x6086).number(), 0U);
  EXPECT_EQ(unit.download(0x6086, 0, 3, 2), 0U);
  EXPECT_EQ(unit.device.axis().read(1115).value(), 1.0);
  EXPECT_EQ(unit.upload(0x6086).number(), 3U);
  EXPECT_EQ(unit.download(0x6086, 0, 1, 2), 0x06090030U);
  EXPECT_EQ(unit.download(0x6086, 0, 2, 2), 0x06090030U);
  EXPECT_EQ(unit.download(0x6086, 0, 0, 2), 0U);
  EXPECT_EQ(unit.device.axis().read(1115).value(), 0.0);
}

TEST(MotionProfileType, OfLimitedJerkRoundsWithoutJumpsOfTheSlope) {
  TestUnit unit{unit_with({{1134, 1.0}})};
  unit.start();

  EXPECT_EQ(unit.download(0x6086, 0, 0, 2), 0U);
  EXPECT_EQ(unit.device.axis().read(1134).value(), 1.0) << "a linear ramp has no rounding";
  EXPECT_EQ(unit.download(0x6086, 0, 3, 2), 0U);
  EXPECT_EQ(unit.device.axis().read(1115).value(), 1.0);
  EXPECT_EQ(unit.device.axis().read(1134).value(), 0.0);
  EXPECT_EQ(unit.upload(0x6086).number(), 3U);
}

}  // namespace
}  // namespace device
