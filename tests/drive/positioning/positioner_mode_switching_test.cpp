// Which mode gives way to which request: the table of the modes of the basic positioner.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr int kIllegalSignals = 7457;
constexpr int kNone = -1;

/// A mode, how it is asked for, and how that request is taken back.
struct Mode {
  const char* name;
  double code;  // r2669
  void (*ask)(PositioningUnit&);
  void (*take_back)(PositioningUnit&);
};

void ask_for_jog(PositioningUnit& unit) {
  unit.set(2589, 1.0);
}
void ask_for_search(PositioningUnit& unit) {
  unit.set(2595, 1.0);
}
void ask_for_block(PositioningUnit& unit) {
  unit.set(2625, 1.0);
  unit.set(2631, 1.0);
}
void ask_for_mdi(PositioningUnit& unit) {
  unit.set(2690, 500000.0);
  unit.set(2647, 1.0);
  unit.set(2650, 1.0);
}

const std::array kModes{
    Mode{"jog", 1.0, &ask_for_jog, [](PositioningUnit& unit) { unit.set(2589, 0.0); }},
    Mode{"search", 2.0, &ask_for_search, [](PositioningUnit& unit) { unit.set(2595, 0.0); }},
    Mode{"block", 4.0, &ask_for_block, [](PositioningUnit& unit) { unit.set(2631, 0.0); }},
    Mode{"MDI", 8.0, &ask_for_mdi,
         [](PositioningUnit& unit) {
           unit.set(2647, 0.0);
           unit.set(2650, 0.0);
         }},
};
constexpr std::size_t kJog = 0;
constexpr std::size_t kSearch = 1;
constexpr std::size_t kBlock = 2;
constexpr std::size_t kMdi = 3;

/// Value of A07457 by request (rows) and active mode (columns).
constexpr std::array<std::array<int, 4>, 4> kValues{{
    {kNone, 2, 3, 1},
    {2, kNone, 6, 4},
    {3, 6, kNone, 5},
    {1, 4, 5, kNone},
}};

/// Referenced, enabled, block 1 endless positive.
void prepare(PositioningUnit& unit) {
  unit.enable();
  unit.set_reference();
  unit.block(0, {.number = 1, .task = 3, .velocity = 300.0});
  unit.set(2648, 1.0);
  unit.set(2691, 600.0);
  unit.set(2605, 300.0);  // of the search
  unit.run(2);
}

void reject(PositioningUnit& unit) {
  for (const std::uint16_t signal : std::initializer_list<std::uint16_t>{2589, 2595, 2631, 2647, 2650})
    unit.set(signal, 0.0);
  unit.set(2641, 0.0);
  EXPECT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 2000));
  unit.set(2641, 1.0);
  unit.run(2);
}

TEST(PositionerModes, RefuseOneAnotherByTheTable) {
  for (std::size_t active = 0; active < kModes.size(); ++active) {
    for (std::size_t request = 0; request < kModes.size(); ++request) {
      if (request == active) continue;
      SCOPED_TRACE(std::string{kModes[request].name} + " while " + kModes[active].name);
      PositioningUnit unit;
      prepare(unit);
      kModes[active].ask(unit);
      unit.run(200);
      ASSERT_EQ(unit.read(2669), kModes[active].code);
      if (active == kBlock) unit.set(2631, 0.0);
      unit.run(2);
      const double velocity = unit.read(2666);
      kModes[request].ask(unit);
      unit.run(100);
      EXPECT_EQ(unit.read(2669), kModes[active].code);
      EXPECT_EQ(unit.read(2666), velocity);
      EXPECT_EQ(unit.value_of(kIllegalSignals), kValues[request][active]);
      kModes[request].take_back(unit);
      unit.run(2);
      EXPECT_EQ(unit.value_of(kIllegalSignals), kNone);
    }
  }
}

TEST(PositionerModes, OfSimultaneousRequestsNoneStarts) {
  for (std::size_t first = 0; first < kModes.size(); ++first) {
    for (std::size_t second = first + 1; second < kModes.size(); ++second) {
      if (first == kBlock) continue;  // p2647 says whom the edge belongs to
      SCOPED_TRACE(std::string{kModes[first].name} + " and " + kModes[second].name);
      PositioningUnit unit;
      prepare(unit);
      kModes[first].ask(unit);
      kModes[second].ask(unit);
      unit.run(50);
      EXPECT_EQ(unit.read(2669), 0.0);
      EXPECT_EQ(unit.read(2666), 0.0);
      EXPECT_EQ(unit.value_of(kIllegalSignals), kValues[second][first]);
      kModes[second].take_back(unit);
      unit.run(5);
      EXPECT_EQ(unit.value_of(kIllegalSignals), kNone);
      EXPECT_EQ(unit.read(2669), 0.0) << "a level acts with its edge";
    }
  }
}

TEST(PositionerModes, ARefusedLevelNeedsANewEdge) {
  for (const std::size_t request : {kJog, kSearch}) {
    SCOPED_TRACE(kModes[request].name);
    PositioningUnit unit;
    prepare(unit);
    unit.move(500000.0, 600.0);
    unit.run(100);
    kModes[request].ask(unit);
    unit.run(5);
    unit.set(2647, 0.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 2000));
    unit.run(50);
    EXPECT_EQ(unit.read(2669), 0.0);
    EXPECT_FALSE(unit.has(kIllegalSignals));
    kModes[request].take_back(unit);
    unit.run(2);
    kModes[request].ask(unit);
    unit.run(2);
    EXPECT_EQ(unit.read(2669), kModes[request].code);
  }
}

TEST(PositionerModes, ARefusedContinuousMdiStartsByItself) {
  for (const std::size_t active : {kJog, kSearch, kBlock}) {
    SCOPED_TRACE(kModes[active].name);
    PositioningUnit unit;
    prepare(unit);
    kModes[active].ask(unit);
    unit.run(100);
    unit.set(2653, 1.0);  // setting-up, for the search has taken the reference
    unit.set(2651, 1.0);
    unit.set(2649, 1.0);
    unit.set(2647, 1.0);
    unit.run(5);
    EXPECT_EQ(unit.value_of(kIllegalSignals), kValues[kMdi][active]);
    kModes[active].take_back(unit);
    if (active == kBlock) unit.set(2641, 0.0);
    unit.run(5);
    unit.set(2641, 1.0);
    ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 16.0; }, 2000));
    unit.run(2);
    EXPECT_FALSE(unit.has(kIllegalSignals));
    unit.run(300);
    EXPECT_EQ(unit.read(2666), 600.0);
  }
}

TEST(PositionerModes, OneSignalStartsWhatP2647Says) {
  PositioningUnit unit;
  prepare(unit);
  const auto edge = [&] {
    unit.set(2650, 1.0);
    unit.set(2631, 1.0);
    unit.run(2);
    unit.set(2650, 0.0);
    unit.set(2631, 0.0);
    unit.run(2);
  };
  unit.set(2625, 1.0);
  unit.set(2690, 500000.0);
  edge();
  EXPECT_EQ(unit.read(2669), 4.0);
  reject(unit);
  unit.set(2647, 1.0);
  edge();
  EXPECT_EQ(unit.read(2669), 8.0);
  EXPECT_FALSE(unit.has(kIllegalSignals));
  unit.set(2690, 600000.0);
  edge();
  EXPECT_EQ(unit.read(2669), 8.0);
  EXPECT_EQ(unit.read(2671), 600000.0) << "the edge belongs to the mode that is active";
  EXPECT_FALSE(unit.has(kIllegalSignals));
}

TEST(PositionerModes, MdiSelectedDuringABlockLetsItGoOn) {
  PositioningUnit unit;
  prepare(unit);
  unit.start_block(1);
  unit.set(2647, 1.0);
  unit.run(100);
  EXPECT_EQ(unit.value_of(kIllegalSignals), 5);
  EXPECT_EQ(unit.read(2669), 4.0);
  unit.set(2641, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 2000));
  unit.run(2);
  EXPECT_FALSE(unit.has(kIllegalSignals)) << "the block is over";
}

TEST(PositionerModes, ABlockEdgeAloneIsRefusedWhereMdiIsSelected) {
  PositioningUnit unit;
  prepare(unit);
  unit.set(2647, 1.0);
  unit.run(2);
  unit.set(2625, 1.0);
  unit.set(2631, 1.0);
  unit.run(2);
  EXPECT_EQ(unit.value_of(kIllegalSignals), 5);
  EXPECT_EQ(unit.read(2669), 0.0);
  unit.set(2631, 0.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(kIllegalSignals));
}

TEST(PositionerModes, SetReferenceIsIgnoredInMotion) {
  for (const std::size_t active : {kJog, kSearch, kBlock, kMdi}) {
    SCOPED_TRACE(kModes[active].name);
    PositioningUnit unit;
    prepare(unit);
    kModes[active].ask(unit);
    unit.run(100);
    unit.set(2599, 70000.0);
    const double place = unit.read(2665);
    unit.pulse(2596, 2);
    EXPECT_LT(unit.read(2665) - place, 1000.0);
    EXPECT_FALSE(unit.has(7557));
  }
}

TEST(PositionerModes, JogIsRefusedWhereMdiHasReachedItsTarget) {
  PositioningUnit unit;
  prepare(unit);
  unit.move(1000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2669), 8.0);
  unit.set(2589, 1.0);
  unit.run(5);
  EXPECT_EQ(unit.value_of(kIllegalSignals), 1);
  EXPECT_EQ(unit.read(2666), 0.0);
  unit.set(2589, 0.0);
  unit.set(2647, 0.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), 0.0);
  unit.set(2589, 1.0);
  unit.run(3);
  EXPECT_EQ(unit.read(2669), 1.0);
}

}  // namespace
}  // namespace drive
