#include "drive/base/scaling.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "drive/axis/axis.hpp"
#include "drive/base/units.hpp"

namespace drive {
namespace {

References references() {
  return Axis{AxisConfiguration{}}.references();
}

TEST(BusScaling, ShowsSpeedsInIncrementsASecond) {
  const BusScaling scaling{references()};

  EXPECT_EQ(scaling.speed_to_bus(3000.0 * kRpm), 0x0C800000);
  EXPECT_EQ(scaling.speed_to_bus(1500.0 * kRpm), 0x06400000);
  EXPECT_EQ(scaling.speed_to_bus(60.0 * kRpm), 0x00400000);
  EXPECT_EQ(scaling.speed_to_bus(-60.0 * kRpm), -0x00400000);
  EXPECT_EQ(scaling.speed_to_bus(1.0 * kRpm), 69905);
}

TEST(BusScaling, SaturatesSpeedsAtTheEndsOfTheObject) {
  const BusScaling scaling{references()};

  EXPECT_EQ(scaling.speed_to_bus(30719.0 * kRpm), 2147413743);
  EXPECT_EQ(scaling.speed_to_bus(30721.0 * kRpm), INT32_MAX);
  EXPECT_EQ(scaling.speed_to_bus(-40000.0 * kRpm), INT32_MIN);
}

TEST(BusScaling, ReadsEverySpeedBackAsItWasSent) {
  const BusScaling scaling{references()};

  for (const std::int32_t bus : {0, 1, -1, 69905, 209715200, -209715200, INT32_MAX, INT32_MIN})
    EXPECT_EQ(scaling.speed_to_bus(scaling.speed_from_bus(bus)), bus);
}

TEST(BusScaling, TheFactorsCanTurnTheUnitIntoRevolutionsAMinute) {
  const BusScaling scaling{references(), {.numerator = 4194304.0, .denominator = 60.0}};

  EXPECT_EQ(scaling.speed_to_bus(3000.0 * kRpm), 3000);
  EXPECT_NEAR(scaling.speed_from_bus(1500), 1500.0 * kRpm, 1e-9);
}

TEST(BusScaling, ShowsTorquesInPerMilleOfTheRatedTorqueAndSaturates) {
  const BusScaling scaling{references()};

  EXPECT_EQ(scaling.torque_to_bus(7.3), 1000);
  EXPECT_EQ(scaling.torque_to_bus(-3.65), -500);
  EXPECT_NEAR(scaling.torque_from_bus(500), 3.65, 1e-12);
  EXPECT_EQ(scaling.torque_to_bus(1000.0), INT16_MAX);
  EXPECT_EQ(scaling.torque_to_bus(-1000.0), INT16_MIN);
}

TEST(BusScaling, ShowsRampsInIncrementsASecondSquared) {
  const BusScaling scaling{references()};

  EXPECT_EQ(scaling.slope_to_bus(3000.0 * kRpm, 10.0), 20971520u);
  EXPECT_EQ(scaling.slope_to_bus(3000.0 * kRpm, 0.0), 0xFFFFFFFFu);
  EXPECT_EQ(scaling.slope_to_bus(3000.0 * kRpm, 0.001), 0xFFFFFFFFu);
}

TEST(BusScaling, ComputesTheRampTimeFromAWrittenSlopeWithinItsRange) {
  const BusScaling scaling{references()};
  const double maximum_speed = 3000.0 * kRpm;

  EXPECT_NEAR(scaling.ramp_time_from_bus(20971520, maximum_speed, 999999.0).value(), 10.0, 1e-12);
  EXPECT_EQ(scaling.ramp_time_from_bus(1, maximum_speed, 600.0).value(), 600.0);
  EXPECT_EQ(scaling.ramp_time_from_bus(0xFFFFFFFF, maximum_speed, 600.0).value(), 0.0);
  EXPECT_FALSE(scaling.ramp_time_from_bus(0, maximum_speed, 600.0).has_value());
}

}  // namespace
}  // namespace drive
