// What a reset of the communication and what a new start of the unit leave of a position.
#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

/// Referenced, switched off at 20000 LU.
struct MovedUnit : PositioningUnit {
  MovedUnit() {
    enable();
    set_reference();
    move(20000.0);
    EXPECT_TRUE(run_until([this] { return is_done(); }));
    run(500);
    control(0x0006);
    run(200);
  }
};

TEST(PositionerPower, KeepsPlaceAndReferenceOverAReset) {
  MovedUnit unit;
  const double place = unit.read(2521);
  unit.unit.power_off();
  unit.run(5);
  EXPECT_EQ(unit.read(2521), place);
  EXPECT_TRUE(unit.bit(2684, 11));
  EXPECT_EQ(unit.read(2669), 0.0);
}

TEST(PositionerPower, LosesPlaceAndReferenceWithItsElectronics) {
  MovedUnit unit;
  unit.unit.power_off();
  unit.unit.lose_positions();
  unit.run(5);
  EXPECT_EQ(unit.read(2521), 0.0);
  EXPECT_FALSE(unit.bit(2684, 11));
  EXPECT_TRUE(unit.bit(2526, 0));
}

}  // namespace
}  // namespace drive
