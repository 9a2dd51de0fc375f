#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

TEST(PositionerMotion, MdiReachesItsTargetExactly) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference();
  unit.move(100000.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_EQ(unit.read(2669), 8.0);
  EXPECT_EQ(unit.read(2671), 100000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 100000.0);
  unit.run(500);
  EXPECT_NEAR(unit.read(2521), 100000.0, 2.0);
  EXPECT_TRUE(unit.messages().empty()) << unit.messages().front();
}

TEST(PositionerMotion, JogRunsWhileItsBitIsSet) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2590, 1.0);
  unit.run(500);
  EXPECT_EQ(unit.read(2669), 1.0);
  EXPECT_EQ(unit.read(2666), 300.0);
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
  EXPECT_TRUE(unit.bit(2683, 2));
}

TEST(PositionerMotion, BlocksFollowEachOther) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference();
  unit.block(0, {.number = 1, .position = 20000.0, .mode = 0x20});
  unit.block(1, {.number = 5, .position = 30000.0, .velocity = 3000.0, .mode = 0x10});
  unit.block(2, {.number = 7, .task = 5, .parameter = 100.0, .mode = 0x10});
  unit.block(3, {.number = 9, .position = -5000.0, .mode = 0x100});
  unit.start_block(1);
  EXPECT_EQ(unit.read(2669), 4.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2670) == 5.0; }));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2670) == 7.0; }));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2670) == 9.0; }));
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 25000.0);
  EXPECT_TRUE(unit.messages().empty()) << unit.messages().front();
}

TEST(PositionerMotion, StopsExactlyAtASoftwareLimit) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference(10000.0);
  unit.set(2581, 40000.0);
  unit.set(2582, 1.0);
  unit.set(2586, 1800.0);
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2683, 7); }));
  EXPECT_EQ(unit.read(2665), 40000.0);
  EXPECT_TRUE(unit.has(7480));
  unit.run(300);
  EXPECT_EQ(unit.read(2665), 40000.0);
  unit.set(2590, 0.0);
  unit.run(2);
  unit.pulse(2589, 50);
  EXPECT_FALSE(unit.has(7480));
  EXPECT_LT(unit.read(2665), 40000.0);
}

}  // namespace
}  // namespace drive
