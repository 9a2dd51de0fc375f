// Traversing blocks of the basic positioner: every task with every continuation.
#include <array>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

/// What becomes of a block.
enum class Outcome : std::uint8_t {
  Ends,          ///< at its target or after its time, mode 0
  GoesOn,        ///< the next block follows when the task is done
  Changes,       ///< the next block follows with the signal
  Waits,         ///< the task is done, and the block stays
  Runs,          ///< without end
  Alarms,        ///< A07463, mode 0
  Inconsistent,  ///< F07464
  Misses,        ///< F07485
};
using enum Outcome;

struct Row {
  const char* name;
  int task;
  double parameter;
  /// By continuation: END, WITH_STOP, FLYING, EXTERNAL, EXTERNAL_WAIT, EXTERNAL_ALARM; without and with a signal.
  std::array<std::array<Outcome, 6>, 2> outcomes;
};

constexpr std::array<Outcome, 6> kNoMotion{Ends, GoesOn, GoesOn, Inconsistent, Inconsistent, Inconsistent};
constexpr std::array<Outcome, 6> kAlwaysOn{GoesOn, GoesOn, GoesOn, GoesOn, GoesOn, GoesOn};
constexpr std::array<Outcome, 6> kEndless{Runs, Runs, Inconsistent, Runs, Runs, Runs};
constexpr std::array<Outcome, 6> kEndlessChanged{Runs, Runs, Inconsistent, Changes, Changes, Changes};

const std::array kRows{
    Row{"POSITIONING",
        1,
        0.0,
        {{{Ends, GoesOn, GoesOn, GoesOn, Waits, Alarms}, {Ends, GoesOn, GoesOn, Changes, Changes, Changes}}}},
    Row{"FIXED STOP",
        2,
        1000.0,
        {{{Misses, Misses, Inconsistent, Misses, Misses, Inconsistent},
          {Misses, Misses, Inconsistent, Changes, Changes, Inconsistent}}}},
    Row{"ENDLESS_POS", 3, 0.0, {{kEndless, kEndlessChanged}}},
    Row{"ENDLESS_NEG", 4, 0.0, {{kEndless, kEndlessChanged}}},
    Row{"WAIT",
        5,
        1000.0,
        {{{Ends, GoesOn, Inconsistent, GoesOn, Waits, Alarms},
          {Ends, GoesOn, Inconsistent, Changes, Changes, Changes}}}},
    Row{"GOTO", 6, 2.0, {{kAlwaysOn, kAlwaysOn}}},
    Row{"SET_O", 7, 1.0, {{kNoMotion, kNoMotion}}},
    Row{"RESET_O", 8, 1.0, {{kNoMotion, kNoMotion}}},
    Row{"JERK", 9, 0.0, {{kNoMotion, kNoMotion}}},
};

struct BlockUnit : PositioningUnit {
  BlockUnit() {
    enable();
    set_reference();
    set(2632, 1.0);
    run(1);
  }
  /// Block 1 has @p task, block 2 follows with a way to 30000.
  void lay(const Row& row, int continuation) {
    block(0, {.number = 1,
              .task = row.task,
              .position = 10000.0,
              .velocity = 600.0,
              .parameter = row.parameter,
              .mode = continuation << 4});
    block(1, {.number = 2, .position = 30000.0, .velocity = 600.0});
    run(2);
  }
  /// When block 2 comes (ms from now), at most @p limit.
  int time_to_next(int limit) {
    for (int i = 0; i < limit; ++i) {
      if (read(2670) == 2.0) return i;
      run(1);
    }
    return limit;
  }
};

constexpr int kSignalAfter = 200;  // ms
constexpr int kDone = 1400;        // ms, when POSITIONING and WAIT are over

void expect_shown(BlockUnit& unit, const Row& row, int continuation) {
  EXPECT_EQ(unit.read(2669), 4.0);
  EXPECT_EQ(unit.read(2670), 1.0);
  EXPECT_EQ(unit.read(2675), row.task);
  EXPECT_EQ(unit.read(2676), row.parameter);
  EXPECT_EQ(unit.read(2677), continuation << 4);
  EXPECT_TRUE(unit.bit(2684, 15));
}

void expect_outcome(BlockUnit& unit, Outcome outcome, bool lasts, int passed) {
  switch (outcome) {
    case Ends:
      unit.run(kDone);
      EXPECT_EQ(unit.read(2669), 0.0);
      EXPECT_EQ(unit.read(2670), 0.0);
      EXPECT_EQ(unit.read(2675), 0.0);
      EXPECT_FALSE(unit.bit(2684, 15));
      EXPECT_TRUE(unit.messages().empty());
      return;
    case GoesOn: {
      const int time = unit.time_to_next(kDone) + passed;
      EXPECT_LT(time, kDone);
      EXPECT_GT(time, lasts ? 900 : -1);
      return;
    }
    case Changes:
      EXPECT_LE(unit.time_to_next(5), 2);
      return;
    case Waits:
      unit.run(kDone);
      EXPECT_EQ(unit.read(2670), 1.0);
      EXPECT_EQ(unit.read(2666), 0.0);
      EXPECT_TRUE(unit.bit(2684, 15));
      EXPECT_TRUE(unit.messages().empty());
      return;
    case Runs:
      unit.run(kDone);
      EXPECT_EQ(unit.read(2670), 1.0);
      EXPECT_EQ(std::abs(unit.read(2666)), 600.0);
      return;
    case Alarms:
      unit.run(kDone);
      EXPECT_EQ(unit.read(2669), 0.0);
      EXPECT_EQ(unit.value_of(7463), 1);
      unit.start_block(2);
      EXPECT_FALSE(unit.has(7463)) << "gone with the next start";
      return;
    case Misses:
      unit.run(kDone);
      EXPECT_TRUE(unit.has(7485));
      EXPECT_EQ(unit.read(2669), 0.0);
      return;
    case Inconsistent:
      EXPECT_EQ(unit.value_of(7464), 1);
      EXPECT_EQ(unit.value_of(7467), 1);
      EXPECT_EQ(unit.read(2666), 0.0);
      return;
  }
}

TEST(PositionerBlocks, EveryTaskWithEveryContinuation) {
  for (const Row& row : kRows) {
    for (int continuation = 0; continuation < 6; ++continuation) {
      for (const bool signal : {false, true}) {
        SCOPED_TRACE(std::string{row.name} + " continuation " + std::to_string(continuation) +
                     (signal ? " with signal" : " without signal"));
        const Outcome outcome = row.outcomes[signal ? 1 : 0][static_cast<std::size_t>(continuation)];
        const bool lasts = row.task <= 5;
        BlockUnit unit;
        unit.lay(row, continuation);
        unit.start_block(1);
        if (lasts && outcome != Inconsistent) expect_shown(unit, row, continuation);
        int passed = 0;
        if (signal) {
          unit.run(kSignalAfter);
          unit.pulse(2633, 1);
          passed = kSignalAfter;
        }
        expect_outcome(unit, outcome, lasts, passed);
      }
    }
  }
}

TEST(PositionerBlocks, ShowsItsTargetAndItsEnd) {
  BlockUnit unit;
  unit.block(0, {.number = 7, .position = 10000.0, .velocity = 600.0, .acceleration = 50.0, .deceleration = 25.0});
  unit.start_block(7);
  EXPECT_EQ(unit.read(2670), 7.0);
  EXPECT_EQ(unit.read(2671), 10000.0);
  EXPECT_EQ(unit.read(2672), 600.0);
  EXPECT_EQ(unit.read(2673), 50.0);
  EXPECT_EQ(unit.read(2674), 25.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
  EXPECT_EQ(unit.read(2665), 10000.0);
  EXPECT_EQ(unit.read(2669), 0.0);
  EXPECT_TRUE(unit.bit(2683, 3));
  EXPECT_TRUE(unit.bit(2684, 10));
}

TEST(PositionerBlocks, AcknowledgesAsLongAsTheEdgeIsHeld) {
  BlockUnit unit;
  unit.block(0, {.number = 0, .position = 1000.0, .velocity = 600.0});
  unit.set(2631, 1.0);
  unit.run(2);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
  EXPECT_TRUE(unit.bit(2684, 12));
  unit.set(2631, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.bit(2684, 12));
}

TEST(PositionerBlocks, OutputsKeepWhatTasksHaveSet) {
  BlockUnit unit;
  unit.block(0, {.number = 1, .task = 7, .parameter = 3.0, .mode = 0x10});
  unit.block(1, {.number = 2, .task = 5, .parameter = 50.0, .mode = 0x10});
  unit.block(2, {.number = 3, .task = 8, .parameter = 1.0});
  unit.start_block(1);
  unit.run(10);
  EXPECT_TRUE(unit.bit(2683, 10));
  EXPECT_TRUE(unit.bit(2683, 11));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 200));
  EXPECT_FALSE(unit.bit(2683, 10));
  EXPECT_TRUE(unit.bit(2683, 11));
}

TEST(PositionerBlocks, OutputsAfterAFlyingBlockDoNotDisturbTheMotion) {
  BlockUnit unit;
  unit.block(0, {.number = 1, .position = 10000.0, .velocity = 600.0, .mode = 0x20});
  unit.block(1, {.number = 2, .task = 7, .parameter = 1.0, .mode = 0x20});
  unit.block(2, {.number = 3, .position = 20000.0, .velocity = 600.0});
  unit.start_block(1);
  unit.run(300);
  ASSERT_TRUE(unit.run_until(
      [&] {
        EXPECT_EQ(unit.read(2666), 600.0);
        return unit.read(2670) == 3.0;
      },
      1500));
  EXPECT_TRUE(unit.bit(2683, 10));
  EXPECT_NEAR(unit.read(2665), 9500.0, 11.0) << "the braking point of the first";
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
}

TEST(PositionerBlocks, WaitTakesItsMilliseconds) {
  for (const int wait : {1, 7, 100, 1234}) {
    BlockUnit unit;
    unit.block(0, {.number = 1, .task = 5, .parameter = static_cast<double>(wait), .mode = 0x10});
    unit.block(1, {.number = 2, .task = 3, .velocity = 600.0});
    unit.set(2625, 1.0);
    unit.set(2631, 1.0);
    int slices = 0;
    while (unit.positioner().velocity() == 0.0 && slices < 2000) {
      unit.run(1);
      ++slices;
    }
    EXPECT_EQ(slices, wait + 1) << "the first slice of the motion follows";
  }
}

TEST(PositionerBlocks, ACircleOfJumpsDoesNotHang) {
  BlockUnit unit;
  unit.block(0, {.number = 1, .task = 6, .parameter = 2.0});
  unit.block(1, {.number = 2, .task = 6, .parameter = 1.0});
  unit.start_block(1);
  unit.run(200);
  EXPECT_EQ(unit.read(2669), 4.0);
  EXPECT_TRUE(unit.bit(2684, 15));
  unit.set(2641, 0.0);
  unit.run(2);
  EXPECT_EQ(unit.read(2669), 0.0);
}

TEST(PositionerBlocks, JerkTaskLimitsTheJerkOfWhatFollows) {
  BlockUnit unit;
  unit.set(2574, 1000.0);  // Tr = 100 ms
  unit.block(0, {.number = 1, .task = 9, .parameter = 1.0, .mode = 0x10});
  unit.block(1, {.number = 2, .position = 10000.0, .velocity = 600.0});
  unit.start_block(1);
  unit.run(20);
  EXPECT_TRUE(unit.bit(2684, 6));
  EXPECT_LT(unit.positioner().velocity(), 0.02 * 100000.0 / 2.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }, 3000));
  EXPECT_FALSE(unit.bit(2684, 6));
  EXPECT_EQ(unit.read(2665), 10000.0);
}

}  // namespace
}  // namespace drive
