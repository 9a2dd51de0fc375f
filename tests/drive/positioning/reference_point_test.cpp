// Setting the reference point and flying referencing over a whole unit.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

TEST(SetReference, SetsActualValueAndSetpointAtRest) {
  PositioningUnit unit;
  unit.enable();
  EXPECT_FALSE(unit.bit(2684, 11));
  unit.set_reference(12345.0);
  EXPECT_EQ(unit.read(2665), 12345.0);
  EXPECT_EQ(unit.read(2521), 12345.0);
  unit.run(100);
  EXPECT_EQ(unit.read(2521), 12345.0);
}

TEST(SetReference, NeedsNoEnable) {
  PositioningUnit unit;
  unit.set_reference(-700.0);
  EXPECT_EQ(unit.read(2521), -700.0);
  EXPECT_EQ(unit.read(2665), -700.0);
  unit.enable();
  EXPECT_TRUE(unit.bit(2684, 11));
  unit.disable();
  unit.run(1000);
  EXPECT_TRUE(unit.bit(2684, 11)) << "OFF does not take it";
}

TEST(SetReference, IsIgnoredInMotionAndInMdi) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2590, 1.0);
  unit.run(100);
  unit.pulse(2596);
  EXPECT_FALSE(unit.bit(2684, 11));
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
  unit.move(500.0, 600.0, false);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.pulse(2596);
  EXPECT_FALSE(unit.bit(2684, 11));
}

TEST(SetReference, RefusesWhatIsOutsideTheRange) {
  PositioningUnit unit;
  unit.set(2576, 360000.0);
  unit.set(2577, 1.0);
  unit.run(2);
  unit.set(2599, 360000.0);
  unit.set(2596, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7557));
  EXPECT_FALSE(unit.bit(2684, 11));
  unit.set(2596, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7557));
  unit.set_reference(359999.0);
  EXPECT_EQ(unit.read(2521), 359999.0);
}

/// Runs block 1 to its middle, interrupts it there, sets the reference and lets it go on.
void interrupt_and_set_reference(PositioningUnit& unit, int mode) {
  unit.enable();
  unit.set_reference();
  unit.block(0, {.number = 1, .position = 50000.0, .mode = mode});
  unit.start_block(1);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2665) > 20000.0; }));
  unit.set(2640, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2683, 4) == false; }));
  unit.run(200);
}

TEST(SetReference, LetsAnInterruptedBlockGoToItsOldTarget) {
  PositioningUnit unit;
  interrupt_and_set_reference(unit, 0x000);
  unit.set(2599, 1000.0);
  unit.pulse(2596);
  EXPECT_EQ(unit.read(2665), 1000.0);
  unit.set(2640, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 50000.0);
}

TEST(SetReference, LetsAnInterruptedBlockGoTheRestOfItsWay) {
  PositioningUnit unit;
  interrupt_and_set_reference(unit, 0x100);
  const double rest = unit.read(2682);
  unit.set(2599, 1000.0);
  unit.pulse(2596);
  EXPECT_EQ(unit.read(2682), rest);
  unit.set(2640, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 1000.0 + rest);
}

/// A probe at DI 3 that the load comes past at 1.5 and 3.5 revolutions, 15000 LU and 35000 LU from power-on.
struct FlyingUnit : PositioningUnit {
  FlyingUnit() : PositioningUnit{configuration()} {
    set(488, 4.0);
    set(2597, 1.0);
    enable();
  }
  static AxisConfiguration configuration() {
    AxisConfiguration axis = axis_configuration();
    axis.switches.add({.input = 3, .from = 1.5, .to = 1.7});
    return axis;
  }
  void arm() {
    set(2595, 1.0);
    run(2);
  }
  bool corrects() {
    return run_until([&] { return bit(2684, 7); }, 5000);
  }
};

TEST(FlyingReferencing, SetsTheReferenceUnderAJog) {
  FlyingUnit unit;
  unit.set(2599, 20000.0);
  unit.arm();
  EXPECT_TRUE(unit.bit(2684, 1));
  EXPECT_TRUE(unit.bit(2684, 2));
  EXPECT_EQ(unit.read(2669), 32.0);
  unit.set(2586, 6000.0);
  unit.set(2590, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), 33.0);
  ASSERT_TRUE(unit.corrects());
  EXPECT_TRUE(unit.bit(2684, 11));
  EXPECT_EQ(unit.read(2685), 5000.0);
  EXPECT_EQ(unit.read(2523), 15000.0);
  unit.run(1);
  EXPECT_FALSE(unit.bit(2684, 7)) << "a pulse";
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2683, 2); }));
  unit.run(300);
  EXPECT_NEAR(unit.read(2521), unit.read(2521, 1) + 5000.0, 1.0);
  EXPECT_NEAR(unit.read(2521), unit.read(2665), 1.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
  unit.set(2595, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.bit(2684, 1));
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_TRUE(unit.bit(2684, 11));
}

/// Windows around a difference of 5000 LU.
struct WindowCase {
  double inner, outer;
  bool corrects, outside;
};

TEST(FlyingReferencing, CorrectsBetweenItsWindows) {
  for (const WindowCase& row : {WindowCase{0.0, 0.0, true, false}, WindowCase{5001.0, 0.0, false, false},
                                WindowCase{5000.0, 0.0, true, false}, WindowCase{0.0, 4999.0, false, true},
                                WindowCase{0.0, 5000.0, true, false}}) {
    SCOPED_TRACE(testing::Message() << row.inner << " " << row.outer);
    FlyingUnit unit;
    unit.set_reference();
    unit.set(2599, 20000.0);
    unit.set(2601, row.inner);
    unit.set(2602, row.outer);
    unit.arm();
    unit.move(40000.0);
    EXPECT_EQ(unit.corrects(), row.corrects);
    EXPECT_EQ(unit.bit(2684, 3), row.outside);
    EXPECT_EQ(unit.has(7489), row.outside);
    ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
    EXPECT_EQ(unit.read(2665), 40000.0);
    unit.run(300);
    EXPECT_NEAR(unit.read(2521, 1), row.corrects ? 35000.0 : 40000.0, 1.0);
    EXPECT_EQ(unit.bit(2684, 3), row.outside) << "until the next accepted mark or arming";
    unit.set(2595, 0.0);
    unit.run(2);
    unit.arm();
    unit.run(1);
    EXPECT_FALSE(unit.bit(2684, 3));
    EXPECT_FALSE(unit.has(7489));
  }
}

/// The target of a relative task is one of the setpoint too.
TEST(FlyingReferencing, KeepsTheTargetOfARelativeTask) {
  FlyingUnit unit;
  unit.set_reference(500.0);
  unit.set(2599, 15502.0);
  unit.arm();
  unit.block(0, {.number = 1, .position = 30000.0, .mode = 0x100});
  unit.start_block(1);
  ASSERT_TRUE(unit.corrects());
  EXPECT_EQ(unit.read(2685), 2.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 30500.0);
}

TEST(FlyingReferencing, GoesTheShortWayOnAModuloAxis) {
  FlyingUnit unit;
  unit.disable();
  unit.run(1000);  // the pulses go off
  unit.set(2576, 20000.0);
  unit.set(2577, 1.0);
  unit.enable();
  unit.set_reference();
  unit.set(2599, 100.0);
  unit.arm();
  unit.set(2586, 6000.0);
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.corrects());
  EXPECT_EQ(unit.read(2685), 5100.0);
  EXPECT_EQ(unit.read(2523), 15000.0);
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.bit(2683, 2); }));
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(FlyingReferencing, NeedsAProbe) {
  FlyingUnit unit;
  unit.set(488, 0.0);
  unit.arm();
  unit.run(2);
  EXPECT_TRUE(unit.has(7498));
  EXPECT_EQ(unit.value_of(7498), 6);
  unit.set(2595, 0.0);
  unit.run(3);
  EXPECT_FALSE(unit.has(7498));
}

TEST(FlyingReferencing, SeesOneMarkAfterTheOther) {
  FlyingUnit unit;
  unit.set(2599, 15000.0);
  unit.arm();
  unit.set(2585, -6000.0);
  unit.set(2586, 6000.0);
  for (const int jog : {2590, 2589, 2590}) {
    const auto input = static_cast<std::uint16_t>(jog);
    unit.set(input, 1.0);
    if (jog == 2590) {
      EXPECT_TRUE(unit.corrects());
    }
    unit.run(jog == 2589 ? 2500 : 500);
    unit.set(input, 0.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 32.0; }));
  }
  EXPECT_EQ(unit.read(2685), 2000.0) << "back by the edge at 17000 LU, and forth by that at 15000 LU";
}

}  // namespace
}  // namespace drive
