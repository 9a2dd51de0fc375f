// What the checks of traversing blocks find: A07465 to A07472, and F07464 where such a block is started.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

using Block = PositioningUnit::Block;

struct Finding {
  const char* name;
  int alarm;
  int value;      // block number
  bool is_fault;  // F07464 when it is started
  bool modulo;    // p2577
  std::vector<Block> blocks;
};

const std::vector<Finding> kFindings{
    {"no block follows", 7465, 5, true, false, {{.number = 5, .position = 10.0, .mode = 0x10}}},
    {"only a hidden block follows",
     7465,
     5,
     true,
     false,
     {{.number = 5, .mode = 0x20}, {.number = 6, .mode = 0x1}}},
    {"number given twice", 7466, 5, true, false, {{.number = 5}, {.number = 5}}},
    {"clamping torque", 7467, 5, true, false, {{.number = 5, .task = 2, .parameter = 65537.0}}},
    {"negative waiting time", 7467, 5, true, false, {{.number = 5, .task = 5, .parameter = -1.0}}},
    {"output 3 and 4", 7467, 5, true, false, {{.number = 5, .task = 7, .parameter = 4.0}}},
    {"no output", 7467, 5, true, false, {{.number = 5, .task = 8, .parameter = 0.0}}},
    {"jerk 2", 7467, 5, true, false, {{.number = 5, .task = 9, .parameter = 2.0}}},
    {"jump to nowhere", 7468, 5, true, false, {{.number = 5, .task = 6, .parameter = 7.0}}},
    {"jump to a hidden block",
     7468,
     5,
     true,
     false,
     {{.number = 5, .task = 6, .parameter = 7.0}, {.number = 7, .mode = 0x1}}},
    {"below the limit", 7469, 5, false, false, {{.number = 5, .position = -50001.0}}},
    {"above the limit", 7470, 5, false, false, {{.number = 5, .position = 50001.0}}},
    {"outside the modulo range", 7471, 5, true, true, {{.number = 5, .position = 360000.0}}},
    {"below the modulo range", 7471, 5, true, true, {{.number = 5, .position = -1.0}}},
    {"positive without modulo", 7472, 5, true, false, {{.number = 5, .mode = 0x200}}},
    {"negative without modulo", 7472, 5, true, false, {{.number = 5, .mode = 0x300}}},
};

void prepare(PositioningUnit& unit, const Finding& finding) {
  unit.set(2577, finding.modulo ? 1.0 : 0.0);
  unit.set(2580, -50000.0);
  unit.set(2581, 50000.0);
  unit.set(2582, 1.0);
  unit.run(5);
  unit.enable();
  unit.set_reference();
  std::size_t entry = 0;
  for (const Block& block : finding.blocks) unit.block(entry++, block);
  unit.run(3);
}

TEST(PositionerBlockChecks, EveryFindingHasItsAlarm) {
  for (const Finding& finding : kFindings) {
    SCOPED_TRACE(finding.name);
    PositioningUnit unit;
    prepare(unit, finding);
    EXPECT_EQ(unit.messages(), std::vector{finding.alarm});
    EXPECT_EQ(unit.value_of(finding.alarm), finding.value);
    unit.start_block(5);
    EXPECT_EQ(unit.value_of(7464), finding.is_fault ? 5 : -1);
    EXPECT_TRUE(!finding.is_fault || unit.read(2666) == 0.0);
    for (std::size_t entry = 0; entry < finding.blocks.size(); ++entry) unit.set(2616, -1.0, entry);
    unit.run(3);
    EXPECT_FALSE(unit.has(finding.alarm)) << "gone with its cause";
  }
}

TEST(PositionerBlockChecks, TheLowestBlockOfEachReasonIsNamed) {
  PositioningUnit unit;
  unit.block(0, {.number = 9, .task = 7, .parameter = 4.0});
  unit.block(1, {.number = 3, .task = 9, .parameter = 4.0});
  unit.block(2, {.number = 4, .task = 6, .parameter = 60.0});
  unit.run(3);
  EXPECT_EQ(unit.value_of(7467), 3);
  EXPECT_EQ(unit.value_of(7468), 4);
  unit.set(2616, -1.0, 1);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7467), 9);
}

TEST(PositionerBlockChecks, HiddenAndUnusedEntriesAreNotChecked) {
  PositioningUnit unit;
  unit.block(0, {.number = 9, .task = 7, .parameter = 4.0, .mode = 0x1});
  unit.block(1, {.number = -1, .task = 9, .parameter = 4.0});
  unit.run(3);
  EXPECT_TRUE(unit.messages().empty());
}

TEST(PositionerBlockChecks, LimitsAreCheckedAgainWhenTheyChange) {
  PositioningUnit unit;
  unit.block(0, {.number = 1, .position = 20000.0});
  unit.run(3);
  EXPECT_FALSE(unit.has(7470));
  unit.set(2581, 10000.0);
  unit.set(2582, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.value_of(7470), 1);
  unit.set(2581, 30000.0);
  unit.run(3);
  EXPECT_FALSE(unit.has(7470));
}

TEST(PositionerBlockChecks, AnInvalidBlockInTheChainIsAFault) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference();
  unit.block(0, {.number = 1, .position = 2000.0, .velocity = 600.0, .mode = 0x10});
  unit.block(1, {.number = 2, .task = 7, .parameter = 4.0});
  unit.start_block(1);
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7464); }, 2000));
  EXPECT_EQ(unit.value_of(7464), 2);
  EXPECT_NEAR(unit.read(2665), 2000.0, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 100));
  EXPECT_FALSE(unit.has(7490)) << "the fault has its cause already";
}

TEST(PositionerBlockChecks, ARelativeTargetBeyondTheNumberRangeIsAFault) {
  for (const bool above : {false, true}) {
    PositioningUnit unit;
    unit.enable();
    unit.set_reference(above ? 1000000.0 : -1000000.0);
    unit.block(0, {.number = 1, .position = above ? 2147482647.0 : -2147482648.0, .mode = 0x100});
    unit.start_block(1);
    EXPECT_TRUE(unit.has(above ? 7476 : 7475));
    EXPECT_EQ(unit.read(2666), 0.0);
  }
}

TEST(PositionerBlockChecks, ATargetBeyondALimitEndsAtIt) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference();
  unit.set(2581, 10000.0);
  unit.set(2582, 1.0);
  unit.block(0, {.number = 1, .position = 20000.0, .velocity = 600.0, .mode = 0x10});
  unit.block(1, {.number = 2, .position = 0.0});
  unit.start_block(1);
  EXPECT_TRUE(unit.has(7478));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 3000));
  EXPECT_EQ(unit.read(2665), 10000.0);
  EXPECT_TRUE(unit.has(7480));
  EXPECT_TRUE(unit.bit(2683, 7));
  EXPECT_FALSE(unit.bit(2683, 3));
}

}  // namespace
}  // namespace drive
