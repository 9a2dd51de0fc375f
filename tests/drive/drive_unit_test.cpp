#include <gtest/gtest.h>

#include "tests/drive/test_drive_unit.hpp"

namespace drive {
namespace {

TEST(DriveUnit, ReachesEveryDriveObjectByItsNumber) {
  TestUnit test;

  EXPECT_FALSE(test.write(kX, 1120, 2.5));
  EXPECT_EQ(test.read(kX, 1120), 2.5);
  EXPECT_EQ(test.read(kY, 1120), 10.0);
  EXPECT_EQ(test.read(kUnit, 8848), 4.0);
  EXPECT_EQ(test.unit.read(0, 2, 0).error().reason, Refusal::NoDriveObject);
  EXPECT_EQ(test.unit.read(4, 2, 0).error().reason, Refusal::NoDriveObject);
  EXPECT_EQ(test.unit.read(kUnit, 1120, 0).error().reason, Refusal::NoParameter);
  EXPECT_EQ(test.unit.read(kX, 8630, 0).error().reason, Refusal::NoParameter);
}

TEST(DriveUnit, TakesOnlyValuesOfTheParametersType) {
  TestUnit test;

  EXPECT_EQ(test.unit.write(kX, 1120, 0, {DataType::U32, 2}).error().reason, Refusal::WrongType);
  EXPECT_EQ(test.unit.write(kX, 8641, 0, {DataType::I16, 0xFFFF}).error().reason, Refusal::BelowMinimum);
  EXPECT_EQ(test.unit.write(kX, 8641, 0, {DataType::I16, 4}).error().reason, Refusal::AboveMaximum);
  EXPECT_EQ(test.unit.write(kX, 1120, 0, {DataType::F32, 0x7FC00000}).error().reason, Refusal::BelowMinimum);
  EXPECT_TRUE(test.unit.write(kX, 8791, 0, {DataType::I16, 0xFFFF}));
  EXPECT_EQ(test.unit.read(kX, 8791, 0).value(), (ParameterValue{DataType::I16, 0xFFFFFFFF}));
}

TEST(DriveUnit, RefusesAWriteInTheWrongStateWithTheReason) {
  TestUnit test;

  EXPECT_EQ(test.write(kX, 311, 1500.0), Refusal::OnlyInMotorCommissioning);
  EXPECT_EQ(test.write(kX, 408, 1024.0), Refusal::OnlyInEncoderCommissioning);
  EXPECT_EQ(test.write(kX, 970, 1.0), Refusal::OnlyInParameterReset);
  EXPECT_EQ(test.write(kUnit, 8848, 2.0), Refusal::OnlyInDriveConfiguration);
  EXPECT_EQ(test.write(kUnit, 976, 1.0), Refusal::OnlyInDeviceReset);
  EXPECT_EQ(test.write(kUnit, 107, 12.0, 1), Refusal::OnlyInDeviceCommissioning);

  EXPECT_FALSE(test.write(kX, 10, 3.0));
  EXPECT_FALSE(test.write(kX, 311, 1500.0));
  EXPECT_EQ(test.write(kX, 408, 1024.0), Refusal::OnlyInEncoderCommissioning);
  EXPECT_EQ(test.write(kX, 1082, 3000.0), Refusal::OnlyInQuickCommissioning);
  EXPECT_FALSE(test.write(kX, 10, 4.0));
  EXPECT_FALSE(test.write(kX, 408, 1024.0));
  EXPECT_FALSE(test.write(kUnit, 9, 3.0));
  EXPECT_FALSE(test.write(kUnit, 8848, 2.0));
  EXPECT_EQ(test.write(kX, 10, 6.0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kUnit, 9, 5.0), Refusal::IllegalValue);
}

TEST(DriveUnit, TakesOnlySomeParametersWhileTheMotorRuns) {
  TestUnit test;
  test.enable(kX);
  ASSERT_EQ(test.state(kX), State::OperationEnabled);

  EXPECT_EQ(test.write(kX, 10, 1.0), Refusal::PulsesEnabled);
  EXPECT_EQ(test.write(kX, 1082, 3000.0), Refusal::PulsesEnabled);
  EXPECT_EQ(test.write(kX, 8641, 1.0), Refusal::PulsesEnabled);
  EXPECT_EQ(test.write(kX, 2, 1.0), Refusal::ReadOnly);
  EXPECT_FALSE(test.write(kX, 1120, 1.0));
  EXPECT_FALSE(test.write(kX, 640, 1.0));
  EXPECT_FALSE(test.write(kY, 1082, 3000.0));
}

TEST(DriveUnit, CannotBeSwitchedOnInCommissioning) {
  TestUnit test;
  ASSERT_FALSE(test.write(kX, 10, 1.0));
  test.enable(kX);
  EXPECT_EQ(test.state(kX), State::SwitchOnDisabled);
  EXPECT_EQ(test.read(kX, 2), 46.0);

  ASSERT_FALSE(test.write(kX, 10, 0.0));
  ASSERT_FALSE(test.write(kUnit, 9, 1.0));
  test.enable(kX);
  EXPECT_EQ(test.state(kX), State::SwitchOnDisabled);
  EXPECT_EQ(test.read(kUnit, 2), 34.0);

  ASSERT_FALSE(test.write(kUnit, 9, 0.0));
  test.enable(kX);
  EXPECT_EQ(test.state(kX), State::OperationEnabled);
  EXPECT_EQ(test.read(kX, 2), 0.0);
}

TEST(DriveUnit, LetsHeartbeatAndLifeGuardingExcludeEachOther) {
  TestUnit test;

  EXPECT_FALSE(test.write(kUnit, 8606, 100.0));
  EXPECT_EQ(test.write(kUnit, 8604, 200.0, 0), Refusal::NotNow);
  EXPECT_FALSE(test.write(kUnit, 8606, 0.0));
  EXPECT_FALSE(test.write(kUnit, 8604, 200.0, 0));
  EXPECT_FALSE(test.write(kUnit, 8606, 100.0));
  EXPECT_FALSE(test.write(kUnit, 8606, 0.0));
  EXPECT_FALSE(test.write(kUnit, 8604, 3.0, 1));
  EXPECT_EQ(test.write(kUnit, 8606, 100.0), Refusal::NotNow);
}

TEST(DriveUnit, ChecksCobIdsAndTransmissionTypes) {
  TestUnit test;

  EXPECT_FALSE(test.write(kX, 8700, 0xC00006E0, 0));
  EXPECT_FALSE(test.write(kX, 8700, 0x6DF, 0));
  EXPECT_EQ(test.write(kX, 8700, 0x6E0, 0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kX, 8700, 0, 0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kX, 8700, 0x40000205, 0), Refusal::IllegalValue);
  EXPECT_FALSE(test.write(kX, 8720, 0x40000185, 0));
  EXPECT_EQ(test.write(kX, 8720, 0x20000185, 0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kX, 8720, 0xF1, 1), Refusal::IllegalValue);
  EXPECT_FALSE(test.write(kX, 8720, 0xFF, 1));
  EXPECT_EQ(test.write(kX, 8720, 65536, 2), Refusal::AboveMaximum);
  EXPECT_FALSE(test.write(kX, 8612, 0x601, 0));
  EXPECT_EQ(test.write(kX, 8612, 0x680, 0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kX, 8612, 0x601, 1), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kUnit, 8630, 4, 1), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kUnit, 8603, 0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kUnit, 8620, 7), Refusal::Deactivated);
}

TEST(DriveUnit, TakesOnlyBicoSourcesThatExist) {
  TestUnit test;
  const auto source = [](std::uint16_t number, std::uint8_t object, std::uint16_t position) {
    return static_cast<double>(pack({number, object, position}));
  };

  EXPECT_FALSE(test.write(kX, 1070, 0));
  EXPECT_FALSE(test.write(kX, 1070, 1));
  EXPECT_FALSE(test.write(kX, 1070, source(8860, kOwnObject, 18)));
  EXPECT_FALSE(test.write(kX, 1070, source(8860, kY, 1)));
  EXPECT_FALSE(test.write(kX, 840, source(8890, kUnit, 15)));
  EXPECT_EQ(test.write(kX, 1070, 2), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 1070, source(8860, kOwnObject, 19)), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 1070, source(8860, 9, 1)), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 1070, source(1120, kOwnObject, 0)), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 840, source(8890, kOwnObject, 16)), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 840, source(8860, kOwnObject, 0)), Refusal::IllegalSource);
  EXPECT_EQ(test.write(kX, 2200, 4294967295.0), Refusal::IllegalSource);
  EXPECT_EQ(test.read(kX, 1070), source(8860, kY, 1));
}

TEST(DriveUnit, CommandsTheNmtStateByItsCodesOnly) {
  TestUnit test;

  for (const double value : {4.0, 5.0, 127.0}) {
    EXPECT_FALSE(test.write(kUnit, 8684, value));
    EXPECT_FALSE(test.write(kUnit, 8685, value));
  }
  EXPECT_EQ(test.write(kUnit, 8684, 6.0), Refusal::IllegalValue);
  EXPECT_EQ(test.write(kUnit, 8685, 0.0), Refusal::IllegalValue);
}

TEST(DriveUnit, ReturnsToTheStateOfANewUnitExceptForItsAddressAndBitRate) {
  TestUnit test;
  ASSERT_FALSE(test.write(kX, 1120, 1.0));
  ASSERT_FALSE(test.write(kX, 2100, 8702, 3));
  ASSERT_FALSE(test.write(kX, 2691, 700));
  ASSERT_FALSE(test.write(kUnit, 8622, 3));
  ASSERT_FALSE(test.write(kUnit, 9, 30));

  test.unit.restore_parameters();

  EXPECT_EQ(test.read(kX, 1120), 10.0);
  EXPECT_EQ(test.read(kX, 2100, 3), 0.0);
  EXPECT_EQ(test.read(kX, 2691), 600.0);
  EXPECT_EQ(test.read(kUnit, 8622), 3.0);
  EXPECT_EQ(test.read(kUnit, 9), 0.0);
  test.enable(kX);
  EXPECT_EQ(test.state(kX), State::OperationEnabled);
}

TEST(DriveUnit, ResetsOneDriveObjectByItsOwnParameter) {
  TestUnit test;
  ASSERT_FALSE(test.write(kX, 1120, 1.0));
  ASSERT_FALSE(test.write(kY, 1120, 1.0));
  ASSERT_FALSE(test.write(kX, 10, 30));

  EXPECT_FALSE(test.write(kX, 970, 1));

  EXPECT_EQ(test.read(kX, 1120), 10.0);
  EXPECT_EQ(test.read(kX, 10), 0.0);
  EXPECT_EQ(test.read(kY, 1120), 1.0);
}

TEST(DriveUnit, ComputesControlParametersAnew) {
  TestUnit test;
  const double gain = test.read(kX, 1460);
  ASSERT_FALSE(test.write(kX, 1460, 7.0));
  ASSERT_FALSE(test.write(kX, 1520, 1.0));

  EXPECT_FALSE(test.write(kX, 340, 4));
  EXPECT_EQ(test.read(kX, 1460), gain);
  EXPECT_EQ(test.read(kX, 1520), 1.0);
  EXPECT_FALSE(test.write(kX, 340, 5));
  EXPECT_EQ(test.read(kX, 1520), 35.0);
  EXPECT_EQ(test.read(kX, 340), 0.0);
}

TEST(DriveUnit, ShowsWhatATurningAxisDoes) {
  TestUnit test;
  ASSERT_FALSE(test.write(kX, 1120, 0.0));
  test.enable(kX);
  Axis& axis = test.unit.axes()[0];
  for (int i = 0; i < 500; ++i) axis.cycle(Setpoints{.controlword = 0x000F, .speed = 1000.0 * kRpm}, kCycle);

  EXPECT_NEAR(test.read(kX, 21), 1000.0, 1.0);
  EXPECT_NEAR(test.read(kX, 1119), 1000.0, 0.01);
  EXPECT_NEAR(test.read(kX, 1170), 1000.0, 0.01);
  EXPECT_NEAR(test.read(kX, 32), test.read(kX, 31) * 1000.0 * kRpm / 1000.0, 1e-3);
  EXPECT_GT(test.read(kX, 39, 1), 0.0);
  EXPECT_NEAR(test.read(kX, 2522), 10000.0, 20.0);
  EXPECT_EQ(test.read(kX, 2), 0.0);
  EXPECT_EQ(test.read(kX, 46), 0.0);
  EXPECT_EQ(test.read(kX, 8784), 0x0637);
  EXPECT_EQ(test.read(kX, 899), 0x0BB7);
  EXPECT_EQ(test.read(kX, 8762), 3.0);
  EXPECT_EQ(test.read(kX, 482), static_cast<std::uint32_t>(axis.actual().encoder_position));
  EXPECT_EQ(test.read(kX, 2197), 0x0088);
}

}  // namespace
}  // namespace drive
