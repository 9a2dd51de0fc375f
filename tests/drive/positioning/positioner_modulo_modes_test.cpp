// Directions of MDI and of traversing blocks on a modulo axis.
#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kRange = 36000.0;

struct ModuloUnit : PositioningUnit {
  ModuloUnit() {
    set(2576, kRange);
    set(2577, 1.0);
    run(5);
    enable();
    set_reference(35000.0);
    EXPECT_TRUE(bit(2684, 9));
    EXPECT_EQ(read(2665), 35000.0);
  }
};

/// A direction as each kind of order gives it, and the way from 35000 to 1000.
struct Way {
  double positive;     // p2651
  double negative;     // p2652
  std::uint32_t word;  // p2654
  int target_kind;     // cccc of p2623
  double distance;     // LU
};
constexpr Way kWays[] = {
    {0.0, 0.0, 0x101, 0x000, 2000.0},
    {1.0, 1.0, 0x101, 0x000, 2000.0},
    {1.0, 0.0, 0x120, 0x200, 2000.0},
    {0.0, 1.0, 0x130, 0x300, -34000.0},
};

TEST(PositionerModuloModes, AHalfLengthUnitIsNeverShownOutsideTheRange) {
  for (const double way : {500.0, -500.0}) {
    ModuloUnit unit;
    unit.set(2572, 1000.0);  // half a length unit in the first millisecond
    unit.set_reference(way > 0.0 ? kRange - 1.0 : 0.0);
    unit.set(2690, way);
    unit.set(2691, 600.0);
    unit.set(2647, 1.0);
    unit.set(2650, 1.0);
    for (int i = 0; i < 100; ++i) {
      unit.run(1);
      ASSERT_GE(unit.read(2665), 0.0);
      ASSERT_LE(unit.read(2665), kRange - 1.0);
    }
  }
}

TEST(PositionerModuloModes, MdiGoesTheWayOfItsBits) {
  for (const Way& way : kWays) {
    ModuloUnit unit;
    unit.set(2651, way.positive);
    unit.set(2652, way.negative);
    unit.move(1000.0, 600.0);
    EXPECT_NEAR(unit.read(2682), way.distance, 20.0);
    EXPECT_EQ(unit.read(2671), 1000.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
    EXPECT_EQ(unit.read(2665), 1000.0);
  }
}

TEST(PositionerModuloModes, MdiGoesTheWayOfItsModeWord) {
  for (const Way& way : kWays) {
    ModuloUnit unit;
    unit.wire(2654, {8850, kOwnObject, 4});
    unit.axis().process_data().received[4] = static_cast<std::uint16_t>(way.word);
    unit.set(2648, 0.0);
    unit.set(2690, 1000.0);
    unit.set(2691, 600.0);
    unit.set(2647, 1.0);
    unit.pulse(2650, 2);
    EXPECT_NEAR(unit.read(2682), way.distance, 20.0);
  }
}

TEST(PositionerModuloModes, SettingUpTakesItsDirectionFromTheModeWord) {
  ModuloUnit unit;
  unit.wire(2654, {8850, kOwnObject, 4});
  unit.axis().process_data().received[4] = 0x130;
  unit.set(2651, 1.0);  // without effect
  unit.set(2691, 600.0);
  unit.set(2653, 1.0);
  unit.set(2647, 1.0);
  unit.pulse(2650, 2);
  unit.run(200);
  EXPECT_EQ(unit.read(2666), -600.0);
}

TEST(PositionerModuloModes, BlocksGoTheWayOfTheirKind) {
  for (const Way& way : kWays) {
    ModuloUnit unit;
    unit.block(0, {.number = 1, .position = 1000.0, .velocity = 600.0, .mode = way.target_kind});
    unit.start_block(1);
    EXPECT_NEAR(unit.read(2682), way.distance, 20.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
    EXPECT_EQ(unit.read(2665), 1000.0);
  }
}

TEST(PositionerModuloModes, RelativeTargetsGoAsManyTurnsAsTheyAre) {
  ModuloUnit unit;
  unit.move(3.0 * kRange + 500.0, 6000.0, false);
  EXPECT_NEAR(unit.read(2682), 3.0 * kRange + 500.0, 600.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 35500.0);
}

TEST(PositionerModuloModes, ATargetJustPassedIsAWholeTurnAhead) {
  ModuloUnit unit;
  unit.set(2651, 1.0);
  unit.move(30000.0, 3000.0);
  unit.run(600);
  const double place = unit.read(2665);
  unit.set(2690, std::floor(place + 100.0));
  unit.pulse(2650, 2);
  EXPECT_GT(unit.read(2682), kRange - 200.0);
  bool reverses = false;
  ASSERT_TRUE(unit.run_until([&] {
    reverses = reverses || unit.bit(2683, 5);
    return unit.is_done();
  }));
  EXPECT_FALSE(reverses);
  EXPECT_EQ(unit.read(2665), std::floor(place + 100.0));
}

}  // namespace
}  // namespace drive
