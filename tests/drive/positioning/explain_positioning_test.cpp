// Every reason why an axis with the positioner does not move, by a unit that is brought into it.
#include <string>

#include <gtest/gtest.h>

#include "drive/explain/explain.hpp"
#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

struct ExplainedUnit : PositioningUnit {
  explicit ExplainedUnit(bool referenced = true, const AxisConfiguration& axis = axis_configuration())
      : PositioningUnit{axis} {
    enable();
    if (referenced) set_reference();
  }
  std::string told() {
    std::string lines;
    for (const std::string& sentence : explain(axis())) lines += sentence + "\n";
    return lines;
  }
  bool tells(std::string_view part) { return told().find(part) != std::string::npos; }
  bool comes_to_tell(std::string_view part) {
    return run_until([&] { return tells(part); }, 5000);
  }
};

TEST(ExplainPositioning, WithoutATask) {
  ExplainedUnit unit;
  EXPECT_EQ(unit.told().find("The positioner has no task (r2669 = 0): start a block ("), 0U) << unit.told();
}

TEST(ExplainPositioning, WithoutAReferencePoint) {
  ExplainedUnit unit{false};
  EXPECT_TRUE(unit.tells("The reference point is not set (r2684.11 = 0), which blocks and absolute targets need"));
}

TEST(ExplainPositioning, WithoutAValidPosition) {
  ExplainedUnit unit;
  unit.set(2658, 0.0);
  unit.run(3);
  EXPECT_TRUE(unit.tells("The actual position is not valid (r2526.0 = 0, ")) << unit.told();
}

TEST(ExplainPositioning, WithoutTheEnableOfThePositioner) {
  ExplainedUnit unit;
  unit.set(2656, 0.0);
  unit.run(3);
  EXPECT_TRUE(unit.tells("The positioner is not enabled (r2526.3 = 0, ")) << unit.told();
  EXPECT_TRUE(unit.tells(": enable position control.")) << unit.told();
}

TEST(ExplainPositioning, WithMdiThatHasTakenNothingOver) {
  ExplainedUnit unit;
  unit.set(2647, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.tells("MDI is selected (p2647 = 1) and no setpoint was taken over since: ")) << unit.told();
}

TEST(ExplainPositioning, WithTasksThatAreRejected) {
  ExplainedUnit unit;
  unit.set(2641, 0.0);
  unit.run(2);
  EXPECT_TRUE(unit.tells("Tasks are rejected (p2641 = 0): ")) << unit.told();
}

TEST(ExplainPositioning, InAnIntermediateStop) {
  ExplainedUnit unit;
  unit.block(0, {.number = 3, .position = 1e6});
  unit.start_block(3);
  unit.run(100);
  unit.set(2640, 0.0);
  EXPECT_TRUE(unit.comes_to_tell("An intermediate stop holds traversing block 3 (p2640 = 0): ")) << unit.told();
}

TEST(ExplainPositioning, WithAnOverrideOfNothing) {
  ExplainedUnit unit;
  unit.block(0, {.number = 3, .position = 1e6});
  unit.start_block(3);
  unit.run(100);
  unit.set(2646, 0.0);
  EXPECT_TRUE(unit.comes_to_tell("The velocity override is 0 % (p2646 = 0): raise it; traversing block 3 goes on"))
      << unit.told();
}

TEST(ExplainPositioning, WithAVelocityOfNothing) {
  ExplainedUnit unit;
  unit.set(2643, 0.0);
  unit.move(20000.0);
  unit.run(20);
  EXPECT_TRUE(unit.tells("The velocity of ")) << unit.told();
  EXPECT_TRUE(unit.tells(" is 0 (r2672; MDI: p2643 = 0).")) << unit.told();
}

TEST(ExplainPositioning, AtTheLimitsOfItsWay) {
  for (const bool forward : {true, false}) {
    ExplainedUnit unit;
    unit.set(2580, -5000.0);
    unit.set(2581, 5000.0);
    unit.set(2582, 1.0);
    unit.set(forward ? 2590 : 2589, 1.0);
    EXPECT_TRUE(unit.comes_to_tell(forward ? "The setpoint is at the limit of the positive direction, 5000 LU ("
                                           : "The setpoint is at the limit of the negative direction, -5000 LU ("))
        << unit.told();
    EXPECT_TRUE(unit.tells(forward ? "only travel in the negative one" : "only travel in the positive one"));
  }
}

TEST(ExplainPositioning, OnAStopCam) {
  AxisConfiguration axis = PositioningUnit::axis_configuration();
  axis.switches.add({.input = 0, .from = -1000.0, .to = -3.0, .inverted = true});
  axis.switches.add({.input = 1, .from = 3.0, .to = 1000.0, .inverted = true});
  for (const bool forward : {true, false}) {
    ExplainedUnit unit{true, axis};
    unit.wire(2569, {722, kControlUnitNumber, 0});
    unit.wire(2570, {722, kControlUnitNumber, 1});
    unit.set(2568, 1.0);
    const std::uint16_t jog = forward ? 2590 : 2589;
    unit.set(jog, 1.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.has(forward ? 7492 : 7491); }));
    unit.set(jog, 0.0);
    unit.run(1500);
    unit.acknowledge();
    unit.enable();
    EXPECT_TRUE(unit.tells(forward ? "The axis is on the STOP cam of the positive direction ("
                                   : "The axis is on the STOP cam of the negative direction ("))
        << unit.told();
    EXPECT_TRUE(unit.tells(forward ? "move it in the negative direction." : "move it in the positive direction."));
  }
}

TEST(ExplainPositioning, InABlockThatWaits) {
  ExplainedUnit unit;
  unit.block(0, {.number = 1, .task = 5, .parameter = 500.0});
  unit.start_block(1);
  EXPECT_TRUE(unit.comes_to_tell("Traversing block 1 waits ")) << unit.told();
  EXPECT_TRUE(unit.tells(" ms more.")) << unit.told();
}

TEST(ExplainPositioning, InABlockThatWaitsForItsSignal) {
  ExplainedUnit unit;
  unit.set(2632, 1.0);
  unit.block(0, {.number = 1, .position = 1000.0, .mode = 0x40});
  unit.block(1, {.number = 2, .position = 2000.0});
  unit.start_block(1);
  EXPECT_TRUE(unit.comes_to_tell("Traversing block 1 waits for its signal (p2633 = 0).")) << unit.told();
}

TEST(ExplainPositioning, OfAnAxisThatMoves) {
  ExplainedUnit unit;
  unit.block(0, {.number = 3, .position = 1e6});
  unit.start_block(3);
  unit.run(300);
  EXPECT_TRUE(unit.tells("; traversing block 3 to 1000000 LU, ")) << unit.told();
  EXPECT_TRUE(unit.tells(" LU to go, at ")) << unit.told();
  EXPECT_TRUE(unit.tells(" LU, override 100 %)")) << unit.told();
}

TEST(ExplainPositioning, OfAnAxisThatMovesWithoutAnEnd) {
  ExplainedUnit unit;
  unit.set(2590, 1.0);
  unit.run(300);
  EXPECT_TRUE(unit.tells(", endless, at ")) << unit.told();
}

}  // namespace
}  // namespace drive
