// The adjustment of absolute encoders over a whole unit.
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

struct AbsoluteUnit : PositioningUnit {
  explicit AbsoluteUnit(double revolutions = 16) : PositioningUnit{configuration(revolutions)} {}
  static AxisConfiguration configuration(double revolutions) {
    AxisConfiguration axis = axis_configuration();
    axis.machine.encoder.type = motor::EncoderType::Absolute;
    axis.machine.encoder.revolutions = static_cast<std::uint32_t>(revolutions);
    axis.machine.encoder.start_position = 3.25;
    return axis;
  }
};

TEST(AbsoluteEncoder, IsAdjustedAndKeepsThatOverPowerOff) {
  AbsoluteUnit unit;
  unit.run(3);
  EXPECT_EQ(unit.read(2521), 32500.0);
  EXPECT_FALSE(unit.bit(2684, 11));
  unit.set(2599, 1000.0);
  unit.set(2507, 2.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2507), 3.0);
  EXPECT_EQ(unit.read(2521), 1000.0);
  EXPECT_TRUE(unit.bit(2526, 9));
  EXPECT_TRUE(unit.bit(2684, 11));
  EXPECT_TRUE(unit.has(7441));
  unit.axis().block<ActualPosition>().on_saved();
  unit.run(3);
  EXPECT_FALSE(unit.has(7441));
  unit.unit.power_off();
  unit.run(3);
  EXPECT_EQ(unit.read(2521), 1000.0);
  EXPECT_TRUE(unit.bit(2684, 11));
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(AbsoluteEncoder, RefusesACoordinateBeyondItsRange) {
  AbsoluteUnit unit;
  unit.set(2599, 160000.0);
  unit.set(2507, 2.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7443));
  EXPECT_EQ(unit.value_of(7443), 159999);
  EXPECT_EQ(unit.read(2507), 1.0);
  EXPECT_FALSE(unit.bit(2684, 11));
}

TEST(AbsoluteEncoder, LosesItsAdjustmentWithTheMechanics) {
  AbsoluteUnit unit;
  unit.set(2507, 2.0);
  unit.run(2);
  EXPECT_TRUE(unit.bit(2684, 11));
  unit.set(2506, 20000.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2507), 1.0);
  EXPECT_FALSE(unit.bit(2684, 11));
}

}  // namespace
}  // namespace drive
