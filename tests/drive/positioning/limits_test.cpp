// Software limits, the number range, STOP cams and velocity limits over a whole unit.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/recorded_unit.hpp"

namespace drive {
namespace {

constexpr double kLower = -40000.0;
constexpr double kUpper = 40000.0;

/// Enabled, its reference set at 0, with software limits; it notes the extremes of r2665.
struct LimitedUnit : PositioningUnit {
  LimitedUnit() {
    set(2580, kLower);
    set(2581, kUpper);
    set(2582, 1.0);
    set(2585, -9000.0);
    set(2586, 9000.0);
    enable();
    set_reference();
  }
  template <class Condition>
  bool goes_until(const Condition& holds, int limit = 5000) {
    return run_until(
        [&] {
          lowest = std::min(lowest, read(2665));
          highest = std::max(highest, read(2665));
          return holds();
        },
        limit);
  }
  bool stands() { return bit(2683, 2); }
  bool mode_ends() {
    return goes_until([&] { return !bit(2684, 15) && stands(); });
  }

  double lowest = 0.0;
  double highest = 0.0;
};

/// A motion that leads beyond the upper limit, and the alarm at its start (0 = none).
struct BeyondCase {
  const char* name;
  std::function<void(LimitedUnit&)> start;
  int alarm;
};
void PrintTo(const BeyondCase& row, std::ostream* out) {
  *out << row.name;
}
class BeyondTheLimit : public testing::TestWithParam<BeyondCase> {};

TEST_P(BeyondTheLimit, EndsOnItExactly) {
  LimitedUnit unit;
  GetParam().start(unit);
  unit.goes_until([&] { return unit.bit(2683, 4); }, 10);
  EXPECT_EQ(unit.has(7478), GetParam().alarm == 7478);
  ASSERT_TRUE(unit.goes_until([&] { return unit.bit(2683, 7); }));
  EXPECT_TRUE(unit.has(7480));
  unit.goes_until([] { return false; }, 500);
  EXPECT_EQ(unit.read(2665), kUpper);
  EXPECT_EQ(unit.highest, kUpper);
  EXPECT_FALSE(unit.bit(2683, 3)) << "not the programmed target";
  EXPECT_FALSE(unit.has(7482));
}

INSTANTIATE_TEST_SUITE_P(
    Motions, BeyondTheLimit,
    testing::Values(BeyondCase{"Jog", [](LimitedUnit& unit) { unit.set(2590, 1.0); }, 0},
                    BeyondCase{"JogByAnIncrement",
                               [](LimitedUnit& unit) {
                                 unit.set(2588, 100000.0);
                                 unit.set(2591, 1.0);
                                 unit.set(2590, 1.0);
                               },
                               7478},
                    BeyondCase{"MdiAbsolute", [](LimitedUnit& unit) { unit.move(40001.0, 9000.0); }, 7478},
                    BeyondCase{"SettingUp",
                               [](LimitedUnit& unit) {
                                 unit.set(2653, 1.0);
                                 unit.set(2651, 1.0);
                                 unit.move(0.0, 9000.0);
                               },
                               0},
                    BeyondCase{"Block",
                               [](LimitedUnit& unit) {
                                 unit.block(0, {.number = 1, .position = 60000.0, .velocity = 9000.0});
                                 unit.start_block(1);
                               },
                               7478},
                    BeyondCase{"RelativeBlockWithASmallDeceleration",
                               [](LimitedUnit& unit) {
                                 unit.block(0, {.number = 1,
                                                .position = 60000.0,
                                                .velocity = 9000.0,
                                                .mode = 0x100,
                                                .deceleration = 20.0});
                                 unit.start_block(1);
                               },
                               7478},
                    BeyondCase{"EndlessBlock",
                               [](LimitedUnit& unit) {
                                 unit.block(0, {.number = 1, .task = 3, .velocity = 9000.0});
                                 unit.start_block(1);
                               },
                               0}),
    [](const auto& test) { return test.param.name; });

TEST(Limits, EndTheTaskThatLeadsBeyond) {
  LimitedUnit unit;
  unit.move(90000.0, 9000.0);
  ASSERT_TRUE(unit.mode_ends());
  EXPECT_EQ(unit.read(2665), kUpper);
  EXPECT_FALSE(unit.has(7478));
  unit.set(2581, 90000.0);
  unit.run(500);
  EXPECT_EQ(unit.read(2665), kUpper) << "the task is over, whatever the limit becomes";
  EXPECT_FALSE(unit.has(7480));
}

TEST(Limits, LetOnlyTravelBackStart) {
  LimitedUnit unit;
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7480); }));
  unit.set(2590, 0.0);
  unit.run(5);
  unit.pulse(2590, 100);
  EXPECT_EQ(unit.read(2665), kUpper);
  EXPECT_TRUE(unit.has(7480));
  unit.set(2589, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2665) < kUpper; }, 5));
  unit.run(1);
  EXPECT_FALSE(unit.has(7480));
  EXPECT_FALSE(unit.bit(2683, 7));
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7479); }));
  EXPECT_EQ(unit.read(2665), kLower);
  EXPECT_TRUE(unit.bit(2683, 6));
}

TEST(Limits, ComeNearerInMotion) {
  LimitedUnit unit;
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.goes_until([&] { return unit.read(2665) > 10000.0; }));
  unit.set(2581, 30000.0);
  ASSERT_TRUE(unit.goes_until([&] { return unit.bit(2683, 7); }));
  EXPECT_EQ(unit.read(2665), 30000.0);
  EXPECT_EQ(unit.highest, 30000.0);
}

TEST(Limits, AreKeptWithTheFullDecelerationWhereTheTaskHasLess) {
  LimitedUnit unit;
  unit.block(0, {.number = 1, .position = 39000.0, .velocity = 2000.0});
  unit.block(1, {.number = 2, .task = 3, .velocity = 2000.0, .deceleration = 1.0});
  unit.start_block(1);
  ASSERT_TRUE(unit.goes_until([&] { return unit.read(2665) > 30000.0; }));
  unit.start_block(2);
  ASSERT_TRUE(unit.goes_until([&] { return unit.bit(2683, 7); }));
  EXPECT_EQ(unit.highest, kUpper);
}

TEST(Limits, AreKeptByAnIntermediateStop) {
  LimitedUnit unit;
  unit.block(0, {.number = 1, .task = 3, .velocity = 2000.0, .deceleration = 1.0});
  unit.start_block(1);
  ASSERT_TRUE(unit.goes_until([&] { return unit.read(2666) > 300.0; }));
  unit.set(2640, 0.0);
  unit.goes_until([] { return false; }, 1000);
  EXPECT_LE(unit.highest, kUpper);
  unit.set(2640, 1.0);
  ASSERT_TRUE(unit.goes_until([&] { return unit.bit(2683, 7); }, 60000));
  EXPECT_EQ(unit.highest, kUpper);
}

TEST(Limits, ActivatedOutsideAreAFaultAndLetTravelBack) {
  LimitedUnit unit;
  unit.set(2582, 0.0);
  unit.move(50000.0, 9000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.set(2647, 0.0);
  unit.set(2582, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7482));
  unit.run(1000);
  unit.acknowledge();
  unit.enable();
  unit.run(2);
  EXPECT_FALSE(unit.has(7482));
  EXPECT_TRUE(unit.has(7480));
  const double place = unit.read(2665);
  unit.pulse(2590, 50);
  EXPECT_EQ(unit.read(2665), place);
  unit.move(30000.0, 9000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 30000.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(Limits, ActInTheOtherDirectionToo) {
  LimitedUnit unit;
  unit.move(-50000.0, 9000.0);
  unit.run(10);
  EXPECT_TRUE(unit.has(7477));
  ASSERT_TRUE(unit.mode_ends());
  EXPECT_EQ(unit.lowest, kLower);
  EXPECT_TRUE(unit.has(7479));
  unit.set(2580, -30000.0);
  unit.run(3);
  EXPECT_TRUE(unit.has(7481));
}

TEST(Limits, AreNotInForceWithoutReference) {
  PositioningUnit unit;
  unit.set(2581, 1000.0);
  unit.set(2582, 1.0);
  unit.set(2586, 6000.0);
  unit.enable();
  unit.set(2590, 1.0);
  EXPECT_TRUE(unit.run_until([&] { return unit.read(2665) > 5000.0; }, 2000));
}

TEST(Limits, FollowTheirReference) {
  PositioningUnit unit;
  unit.enable();
  RecordedUnit recorded{"k12_jog_limit", unit};
  recorded.set_parameters();
  unit.set(2582, 1.0);
  unit.set_reference(recorded.stimulus("start_pos"));
  recorded.set_at(recorded.stimulus("jog2_on"), 2590, 1.0);
  recorded.set_at(recorded.stimulus("jog2_off"), 2590, 0.0);
  recorded.set_at(recorded.stimulus("jog1_on"), 2589, 1.0);
  recorded.set_at(recorded.stimulus("jog1_off"), 2589, 0.0);
  recorded.set_at(recorded.stimulus("jog2_on_again"), 2590, 1.0);
  recorded.run();
  recorded.expect_agreement();
  EXPECT_EQ(unit.read(2665), 40000.0);
  EXPECT_TRUE(unit.has(7480));
  EXPECT_TRUE(unit.bit(2683, 7));
}

TEST(NumberRange, EndsAtTheLastPosition) {
  PositioningUnit unit;
  unit.enable();
  unit.set(2585, -6000.0);
  unit.set(2586, 6000.0);
  unit.set_reference(2147470000.0);
  unit.set(2590, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7474); }));
  EXPECT_EQ(unit.read(2665), 2147482647.0);
  unit.set(2590, 0.0);
  unit.run(2);
  unit.pulse(2589, 300);
  EXPECT_FALSE(unit.has(7474));
  EXPECT_LT(unit.read(2665), 2147482647.0);
  unit.run(1000);
  unit.set_reference(-2147470000.0);
  unit.set(2589, 1.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.has(7473); }));
  EXPECT_EQ(unit.read(2665), -2147482648.0);
}

TEST(NumberRange, RefusesRelativeTargetsBeyond) {
  for (const bool positive : {true, false}) {
    PositioningUnit unit;
    unit.enable();
    unit.set_reference(positive ? 2147470000.0 : -2147470000.0);
    unit.block(0, {.number = 1, .position = positive ? 20000.0 : -20000.0, .mode = 0x100});
    unit.start_block(1);
    EXPECT_TRUE(unit.has(positive ? 7476 : 7475));
    unit.run(1000);
    EXPECT_NEAR(std::abs(unit.read(2665)), 2147470000.0, 5.0);
  }
}

}  // namespace
}  // namespace drive
