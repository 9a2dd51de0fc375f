// MDI of the basic positioner: p2640 to p2654, p2690 to p2693.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kPositioning = 8.0;  // r2669
constexpr double kSettingUp = 16.0;

struct MdiUnit : PositioningUnit {
  MdiUnit() {
    enable();
    set_reference();
    set(2691, 600.0);
    run(1);
  }
  void transfer() { pulse(2650, 2); }
  bool arrives() {
    return run_until([&] { return is_done(); }, 20000);
  }
  /// A connector input gets the double word that comes as PZD 5 and 6.
  void receive(std::uint16_t input, std::int32_t value) {
    wire(input, {8860, kOwnObject, 4});
    ProcessDataImage::set_double_word(axis().process_data().received, 4, static_cast<std::uint32_t>(value));
    run(1);
  }
};

TEST(PositionerMdi, AbsoluteTargetIsShownAndReached) {
  MdiUnit unit;
  unit.set(2690, 20000.0);
  unit.set(2648, 1.0);
  unit.set(2647, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), 0.0) << "no transfer yet";
  unit.set(2650, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), kPositioning);
  EXPECT_EQ(unit.read(2670), 32768.0);
  EXPECT_EQ(unit.read(2671), 20000.0);
  EXPECT_EQ(unit.read(2672), 600.0);
  EXPECT_EQ(unit.read(2673), 100.0);
  EXPECT_EQ(unit.read(2674), 100.0);
  EXPECT_EQ(unit.read(2675), 0.0);
  EXPECT_NEAR(unit.read(2682), 20000.0 - unit.read(2665), 1.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_TRUE(unit.bit(2684, 4));
  EXPECT_TRUE(unit.bit(2684, 12));
  EXPECT_FALSE(unit.bit(2683, 2));
  EXPECT_FALSE(unit.bit(2683, 3));
  EXPECT_FALSE(unit.bit(2684, 10));
  unit.run(500);
  EXPECT_TRUE(unit.bit(2684, 12)) << "until p2650 is 0";
  unit.set(2650, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.bit(2684, 12));
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 20000.0);
  EXPECT_TRUE(unit.bit(2683, 2));
  EXPECT_TRUE(unit.bit(2683, 3));
  EXPECT_EQ(unit.read(2669), kPositioning) << "the mode stays";
  unit.set(2690, 5000.0);
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 5000.0);
  ASSERT_TRUE(unit.arrives());
  unit.set(2647, 0.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_EQ(unit.read(2670), 0.0);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerMdi, RelativeCountsFromTheTargetInMotionAndFromTheSetpointAtRest) {
  MdiUnit unit;
  unit.move(3000.0, 600.0, false);
  EXPECT_EQ(unit.read(2671), 3000.0);
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 6000.0) << "a repeated edge adds again";
  unit.set(2690, -1000.0);
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 5000.0);
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 5000.0);
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 4000.0);
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 4000.0);
}

TEST(PositionerMdi, RelativeAndSettingUpNeedNoReference) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2648, 1.0);
  unit.set(2647, 1.0);
  unit.set(2650, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), 0.0);
  unit.run(3);
  EXPECT_TRUE(unit.has(7461)) << "as long as p2650 is 1";
  unit.set(2650, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7461));
  unit.move(3000.0, 600.0, false);
  EXPECT_EQ(unit.read(2669), kPositioning);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.set(2653, 1.0);
  unit.set(2651, 1.0);
  unit.pulse(2650, 2);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerMdi, ContinuousTakesEveryChange) {
  MdiUnit unit;
  unit.set(2649, 1.0);
  unit.set(2648, 1.0);
  unit.set(2690, 50000.0);
  unit.set(2647, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), kPositioning);
  EXPECT_TRUE(unit.bit(2684, 12));
  unit.run(300);
  unit.set(2691, 1200.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 1200.0);
  unit.set(2690, 1000.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2671), 1000.0);
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 1000.0);
  EXPECT_TRUE(unit.bit(2684, 12));
  unit.set(2690, 2000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2684, 15); }, 3));
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 2000.0);
}

TEST(PositionerMdi, ContinuousRelativeIsAFault) {
  for (const bool in_motion : {false, true}) {
    MdiUnit unit;
    unit.set(2649, 1.0);
    unit.set(2648, in_motion ? 1.0 : 0.0);
    unit.set(2690, 50000.0);
    unit.set(2647, 1.0);
    unit.run(100);
    unit.set(2648, 0.0);
    unit.run(3);
    EXPECT_TRUE(unit.has(7488)) << in_motion;
    EXPECT_TRUE(unit.run_until([&] { return std::abs(unit.read(21)) < 0.5 && unit.read(2669) == 0.0; }, 3000));
    unit.set(2647, 0.0);
    unit.acknowledge();
    EXPECT_EQ(unit.messages(), std::vector<int>{});
  }
}

TEST(PositionerMdi, SettingUpFollowsItsDirections) {
  MdiUnit unit;
  unit.set(2653, 1.0);
  unit.set(2649, 1.0);
  unit.set(2647, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  EXPECT_EQ(unit.read(2666), 0.0) << "no direction";
  EXPECT_TRUE(unit.bit(2684, 15));
  unit.set(2651, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 600.0);
  EXPECT_EQ(unit.read(2671), 0.0);
  unit.set(2652, 1.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), 0.0) << "both";
  EXPECT_TRUE(unit.bit(2684, 15));
  unit.set(2651, 0.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), -600.0);
  unit.set(2691, 1200.0);
  unit.run(300);
  EXPECT_EQ(unit.read(2666), -1200.0);
  unit.set(2647, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 1000));
}

TEST(PositionerMdi, KindChangesInMotion) {
  MdiUnit unit;
  unit.set(2649, 1.0);
  unit.set(2648, 1.0);
  unit.set(2690, 50000.0);
  unit.set(2647, 1.0);
  unit.run(300);
  unit.set(2651, 1.0);
  unit.set(2653, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  unit.set(2653, 0.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), kPositioning) << "continuous: at once";
  EXPECT_EQ(unit.read(2671), 50000.0);
  unit.set(2649, 0.0);
  unit.set(2653, 1.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), kPositioning) << "by edge: with the next one";
  unit.transfer();
  EXPECT_EQ(unit.read(2669), kSettingUp);
  unit.set(2653, 0.0);
  unit.run(50);
  EXPECT_EQ(unit.read(2669), kSettingUp);
  unit.set(2648, 0.0);
  unit.set(2690, 20000.0);
  const double place = unit.read(2665);
  unit.transfer();
  EXPECT_EQ(unit.read(2669), kPositioning);
  EXPECT_NEAR(unit.read(2671), place + 20000.0, 50.0) << "relative to the setpoint, there is no target";
  ASSERT_TRUE(unit.arrives());
}

TEST(PositionerMdi, SharesOfTheRampsAreBounded) {
  MdiUnit unit;
  unit.set(2692, 50.0);
  unit.set(2693, 25.0);
  unit.move(100000.0, 600.0);
  EXPECT_EQ(unit.read(2673), 50.0);
  EXPECT_EQ(unit.read(2674), 25.0);
  const double before = unit.positioner().velocity();
  unit.run(10);
  EXPECT_NEAR(unit.positioner().velocity() - before, 0.01 * 50000.0, 1e-6);
  unit.set(2644, 0.0);
  unit.receive(2645, 0x7FFFFFFF);
  unit.transfer();
  EXPECT_NEAR(unit.read(2673), 0.1, 1e-6);
  EXPECT_EQ(unit.read(2674), 100.0);
}

TEST(PositionerMdi, ModeConnectorReplacesTheBits) {
  MdiUnit unit;
  unit.set(2648, 0.0);
  unit.set(2690, 4000.0);
  unit.set(2647, 1.0);
  unit.set_reference(10000.0);
  unit.receive(2654, 0x101);  // xx0x absolute
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 4000.0);
  ASSERT_TRUE(unit.arrives());
  unit.set(2648, 1.0);
  unit.receive(2654, 0x010);  // xx1x relative
  unit.transfer();
  EXPECT_EQ(unit.read(2671), 8000.0);
  ASSERT_TRUE(unit.arrives());
}

TEST(PositionerMdi, WithoutVelocityTheAxisWaits) {
  MdiUnit unit;
  unit.set(2643, 0.0);
  unit.set(2648, 1.0);
  unit.set(2690, 4000.0);
  unit.set(2647, 1.0);
  unit.transfer();
  unit.run(100);
  EXPECT_EQ(unit.read(2665), 0.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  EXPECT_FALSE(unit.bit(2683, 2));
  EXPECT_FALSE(unit.bit(2684, 10));
  unit.receive(2643, -600);
  unit.transfer();
  unit.run(200);
  EXPECT_EQ(unit.read(2672), 600.0) << "of a negative one the magnitude counts";
  EXPECT_EQ(unit.read(2666), 600.0);
  ASSERT_TRUE(unit.arrives());
  EXPECT_EQ(unit.read(2665), 4000.0);
}

TEST(PositionerMdi, TargetsBeyondTheNumberRangeAreFaults) {
  for (const bool above : {false, true}) {
    MdiUnit unit;
    unit.set_reference(above ? 100000.0 : -100000.0);
    unit.move(above ? 2147482647.0 : -2147482648.0, 600.0, false);
    EXPECT_TRUE(unit.has(above ? 7476 : 7475));
    EXPECT_EQ(unit.read(2666), 0.0);
  }
}

}  // namespace
}  // namespace drive
