#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "drive/axis/axis.hpp"
#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

double value(const DriveObject& object, std::uint16_t number) {
  return object.read(number).value();
}

TEST(AxisParameterAccess, HasTheFactoryValuesOfTheListAndTheComputedOnesOfTheMotor) {
  const Axis axis{AxisConfiguration{}};

  EXPECT_EQ(value(axis, 1120), 10.0);
  EXPECT_EQ(value(axis, 1121), 10.0);
  EXPECT_EQ(value(axis, 1135), 0.0);
  EXPECT_EQ(value(axis, 1226), 20.0);
  EXPECT_EQ(value(axis, 1227), 4.0);
  EXPECT_EQ(value(axis, 1228), 0.01);
  EXPECT_EQ(value(axis, 2161), 5.0);
  EXPECT_EQ(value(axis, 2163), 90.0);
  EXPECT_EQ(value(axis, 2164), 2.0);
  EXPECT_EQ(value(axis, 2166), 200.0);
  EXPECT_EQ(value(axis, 8641), 3.0);
  EXPECT_EQ(value(axis, 8791), -1.0);
  EXPECT_EQ(value(axis, 1082), 7200.0);
  EXPECT_EQ(value(axis, 1520), 35.0);
  EXPECT_EQ(value(axis, 1521), -35.0);
  EXPECT_EQ(value(axis, 2000), 3000.0);
  EXPECT_EQ(value(axis, 2003), 7.3);
  EXPECT_EQ(value(axis, 333), 7.3);
  EXPECT_EQ(value(axis, 408), 2048.0);
  EXPECT_EQ(value(axis, 418), 11.0);
}

TEST(AxisParameterAccess, ComputesTheSpeedControllerFromTheTotalInertia) {
  const Axis axis{AxisConfiguration{}};
  const Axis loaded{AxisConfiguration{.load = {.inertia = 0.00151}}};

  EXPECT_NEAR(value(loaded, 1460), 2.0 * value(axis, 1460), 1e-6);
  EXPECT_GT(value(axis, 1462), 5.0);
  EXPECT_LT(value(axis, 1462), 50.0);
}

TEST(AxisParameterAccess, KeepsEveryValueInSiUnits) {
  Axis axis{AxisConfiguration{}};

  ASSERT_TRUE(axis.write(1082, 3000.0));
  ASSERT_TRUE(axis.write(1462, 20.0));
  ASSERT_TRUE(axis.write(2166, 100.0));

  EXPECT_NEAR(axis.block<SetpointChannel>().settings.maximum_speed, 314.159265, 1e-6);
  EXPECT_NEAR(axis.block<SpeedControl>().settings.speed_integral_time, 0.020, 1e-12);
  EXPECT_NEAR(axis.block<SpeedMessages>().settings.target_off_delay, 0.1, 1e-12);
}

TEST(AxisParameterAccess, RefusesWhatIsNoNumber) {
  Axis axis{AxisConfiguration{}};

  EXPECT_FALSE(axis.write(1120, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(axis.write(8791, 0.5).error().reason, Refusal::WrongType);
}

TEST(AxisParameterAccess, RefusesUnknownAndReadOnlyParameters) {
  Axis axis{AxisConfiguration{}};

  EXPECT_EQ(axis.read(1118).error().reason, Refusal::NoParameter);
  EXPECT_EQ(axis.write(1118, 1.0).error().reason, Refusal::NoParameter);
  EXPECT_EQ(axis.write(333, 1.0).error().reason, Refusal::ReadOnly);
}

TEST(AxisParameterAccess, FindsParametersByTheirWrittenName) {
  const auto find = [](std::string_view text) { return find_parameter(ObjectKind::Servo, text); };

  ASSERT_NE(find("p1120"), nullptr);
  EXPECT_EQ(find("p1120")->number, 1120);
  ASSERT_NE(find("r0333"), nullptr);
  EXPECT_EQ(find("r0333")->number, 333);
  for (const char* text : {"1120", "p0333", "P1120", "p1120 ", "", "p99999", "p8630"})
    EXPECT_EQ(find(text), nullptr);
}

TEST(AxisParameterAccess, SaysWhatWasWrongAndWhatIsAllowed) {
  Axis axis{AxisConfiguration{}};

  EXPECT_EQ(message(axis.write(1120, 1e6).error()), "p1120: above the maximum of 999999 s");
  EXPECT_EQ(message(axis.write(2000, 1.0).error()), "p2000: below the minimum of 6 rpm");
  EXPECT_EQ(message(axis.write(8641, 1.5).error()), "p8641: expected an integer 0..3");
  EXPECT_EQ(message(axis.write(333, 1.0).error()), "r0333: read only");
  EXPECT_EQ(message(axis.write(1, 1.0).error()), "p0001: no such parameter");
}

}  // namespace
}  // namespace drive
