// STOP cams over a whole unit.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

/// STOP cams at 3 and -3 revolutions, at DI 0 (minus) and DI 1 (plus).
struct CamUnit : PositioningUnit {
  explicit CamUnit(double length = 1e3) : PositioningUnit{configuration(length)} {
    wire(2569, {722, kControlUnitNumber, 0});
    wire(2570, {722, kControlUnitNumber, 1});
    set(2568, 1.0);
    set(2585, -6000.0);
    set(2586, 6000.0);
    enable();
  }
  static AxisConfiguration configuration(double length) {
    AxisConfiguration axis = axis_configuration();
    axis.switches.add({.input = 0, .from = -3.0 - length, .to = -3.0, .inverted = true});
    axis.switches.add({.input = 1, .from = 3.0, .to = 3.0 + length, .inverted = true});
    return axis;
  }
};

/// A cam, its signal in r2684, and the jog inputs towards it and away from it.
struct CamCase {
  int fault;
  unsigned bit;
  std::uint16_t towards, away;
};

TEST(StopCams, StopTheAxisAndLetItGoBackOnly) {
  for (const CamCase& row : {CamCase{7491, 13, 2589, 2590}, CamCase{7492, 14, 2590, 2589}})
    for (const double length : {1e3, 0.01}) {
      SCOPED_TRACE(testing::Message() << row.fault << " " << length);
      CamUnit unit{length};
      unit.set(row.towards, 1.0);
      ASSERT_TRUE(unit.run_until([&] { return unit.has(row.fault); }));
      unit.set(row.towards, 0.0);
      unit.run(1500);
      EXPECT_EQ(unit.messages(), std::vector{row.fault});
      EXPECT_TRUE(unit.bit(2684, row.bit));
      unit.acknowledge();
      unit.enable();
      EXPECT_TRUE(unit.messages().empty());
      const double place = unit.read(2665);
      unit.pulse(row.towards, 100);
      EXPECT_EQ(unit.read(2665), place);
      EXPECT_TRUE(unit.bit(2684, row.bit));
      unit.set(row.away, 1.0);
      ASSERT_TRUE(unit.run_until([&] { return !unit.bit(2684, row.bit); }));
      EXPECT_LT(std::abs(unit.read(2521)), 30000.0);
      unit.set(row.away, 0.0);
      unit.run(1500);
      EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
    }
}

TEST(StopCams, TellOfTheWrongSideAndGoOn) {
  PositioningUnit unit;
  unit.set(2568, 1.0);
  unit.enable();
  unit.set(2590, 1.0);
  unit.run(300);
  unit.set(2569, 0.0);
  unit.run(3);
  EXPECT_EQ(unit.messages(), std::vector{7503});
  EXPECT_GT(unit.read(2666), 0.0);
}

TEST(StopCams, AreIgnoredUntilTheyAreActivated) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2569, 0.0);
  unit.run(5);
  EXPECT_TRUE(unit.messages().empty());
  unit.set(2568, 1.0);
  unit.run(3);
  EXPECT_TRUE(unit.has(7491));
}

}  // namespace
}  // namespace drive
