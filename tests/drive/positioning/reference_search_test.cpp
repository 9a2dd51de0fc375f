// The search for the reference over a whole unit: variants, start regions and directions of the cam.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/recorded_unit.hpp"

namespace drive {
namespace {

constexpr double kRevolution = 10000.0;  // LU
constexpr unsigned kCamInput = 0;
constexpr unsigned kMinusInput = 1;  // reversing cams, 0 = reached
constexpr unsigned kPlusInput = 2;

AxisConfiguration with_switches(const std::vector<TravelSwitch>& switches, double start_position = 0.0) {
  AxisConfiguration axis = PositioningUnit::axis_configuration();
  for (const TravelSwitch& row : switches) axis.switches.add(row);
  axis.machine.encoder.start_position = start_position;
  return axis;
}

/// Its switches feed the cam and, where there are any, the reversing cams.
struct SearchUnit : PositioningUnit {
  explicit SearchUnit(const std::vector<TravelSwitch>& switches, double start_position = 0.0)
      : PositioningUnit{with_switches(switches, start_position)} {
    constexpr std::array<std::uint16_t, 3> kInputs{2612, 2613, 2614};
    for (const TravelSwitch& row : switches)
      if (row.input <= kPlusInput)
        wire(kInputs[row.input], {722, kControlUnitNumber, static_cast<std::uint16_t>(row.input)});
    set(2572, 500.0);
    set(2573, 500.0);
    set(2608, 3000.0);
    set(2611, 3000.0);
    enable();
  }
  void start(bool negative = false) {
    set(2604, negative ? 1.0 : 0.0);
    set(2595, 1.0);
    run(2);
  }
  bool is_referenced() { return bit(2684, 11); }
  /// True when the search has ended with the reference set.
  bool finds() {
    return run_until([&] { return is_referenced() || !bit(2684, 0); }) && is_referenced();
  }
  /// Ends in a fault; the axis comes to rest.
  bool fails_with(int fault) {
    const bool comes = run_until([&] { return has(fault); });
    EXPECT_TRUE(run_until([&] { return !bit(2684, 0) && read(2666) == 0.0; }, 2000));
    EXPECT_FALSE(is_referenced());
    return comes;
  }
  /// Where the motor is, from where it was at power-on (LU).
  double place() { return read(2521, 1); }
};

constexpr double kAnywhere = 1e3;  // beyond every way (load revolutions)
TravelSwitch cam(double from, double to) {
  return {.input = kCamInput, .from = from, .to = to};
}
/// 0 from @p from on upwards.
TravelSwitch plus_cam(double from) {
  return {.input = kPlusInput, .from = from, .to = kAnywhere, .inverted = true};
}
/// 0 up to @p to.
TravelSwitch minus_cam(double to) {
  return {.input = kMinusInput, .from = -kAnywhere, .to = to, .inverted = true};
}

struct SearchCase {
  const char* name;
  bool negative;                       // p2604
  std::vector<TravelSwitch> switches;  // a cam among them: p2607 = 1
  double mark;                         // which is found (revolutions from the start)
};

void PrintTo(const SearchCase& row, std::ostream* out) {
  *out << row.name;
}

class Search : public testing::TestWithParam<SearchCase> {};

TEST_P(Search, FindsTheMarkAndGoesToThePointBesideIt) {
  const SearchCase& row = GetParam();
  for (const double offset : {0.0, 500.0, -500.0, 23000.0}) {
    SCOPED_TRACE(offset);
    SearchUnit unit{row.switches};
    const bool has_cam = !row.switches.empty() && row.switches.front().input == kCamInput;
    unit.set(2607, has_cam ? 1.0 : 0.0);
    unit.set(2599, 7000.0);
    unit.set(2600, offset);
    unit.start(row.negative);
    EXPECT_EQ(unit.read(2669), 2.0);
    EXPECT_TRUE(unit.bit(2684, 0));
    EXPECT_TRUE(unit.bit(2684, 2));
    ASSERT_TRUE(unit.finds()) << testing::PrintToString(unit.messages());

    EXPECT_EQ(unit.read(2665), 7000.0);
    EXPECT_EQ(unit.read(2669), 0.0);
    EXPECT_FALSE(unit.bit(2684, 0));
    unit.run(600);
    EXPECT_NEAR(unit.place(), row.mark * kRevolution + offset, 1.0);
    EXPECT_NEAR(unit.read(2521), 7000.0, 1.0);
    EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Variants, Search,
    testing::Values(SearchCase{"BeforeTheCam", false, {cam(3.3, 5.2)}, 3.0},
                    SearchCase{"BeforeTheCamNegative", true, {cam(-5.2, -3.3)}, -3.0},
                    SearchCase{"OnTheCam", false, {cam(-1.3, 2.0)}, -2.0},
                    SearchCase{"OnTheCamNegative", true, {cam(-2.0, 1.3)}, 2.0},
                    SearchCase{"BehindTheCam", false, {cam(-5.2, -3.3), plus_cam(2.0)}, -6.0},
                    SearchCase{"BehindTheCamNegative", true, {cam(3.3, 5.2), minus_cam(-2.0)}, 6.0},
                    SearchCase{"ShortCam", false, {cam(3.3, 3.4)}, 3.0},
                    SearchCase{"ShortCamNegative", true, {cam(-3.4, -3.3)}, -3.0},
                    SearchCase{"BehindAShortCam", false, {cam(-3.4, -3.35), plus_cam(2.0)}, -4.0},
                    SearchCase{"NoCam", false, {}, 1.0}, SearchCase{"NoCamNegative", true, {}, -1.0},
                    SearchCase{"NoCamAndAReversingCam", false, {plus_cam(0.4)}, 0.0},
                    SearchCase{"NoCamAndAReversingCamNegative", true, {minus_cam(-0.4)}, 0.0}),
    [](const auto& test) { return test.param.name; });

TEST(ReferenceSearch, FindsTheMarkExactlyAtEverySpeed) {
  for (const double speed : {30.0, 300.0, 7000.0, 30000.0}) {
    SCOPED_TRACE(speed);
    SearchUnit unit{{}, 0.9};
    unit.set(2607, 0.0);
    unit.set(2608, speed);
    unit.set(2572, 20000.0);
    unit.start();
    ASSERT_TRUE(unit.finds());
    EXPECT_EQ(unit.read(2523), 1000.0);
    unit.run(600);
    EXPECT_NEAR(unit.place(), 1000.0, 1.0);
  }
}

TEST(ReferenceSearch, FollowsItsReference) {
  SearchUnit unit{{cam(4.0, kAnywhere)}, 0.27};
  RecordedUnit recorded{"k13_reference_approach", unit};
  recorded.set_parameters();
  const double end = recorded.file.number("/events/end_pos_before_setting");
  unit.set(2599, end);  // so that the coordinates stay what they are
  recorded.set_at(0.0, 2595, 1.0);
  recorded.run();
  recorded.expect_agreement();
  EXPECT_TRUE(unit.is_referenced());
  EXPECT_EQ(unit.read(2665), end);
  EXPECT_NEAR(std::abs(unit.read(2680)), recorded.file.number("/events/r2680_abs"), 10.0);
}

TEST(ReferenceSearch, TakesTheOverrideOnlyAsFarAsTheCam) {
  SearchUnit unit{{cam(3.3, 5.2)}};
  unit.wire(2646, {2900, kOwnObject, 0});
  unit.set(2900, 50.0);
  unit.start();
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2666) == 2500.0; }));
  EXPECT_TRUE(unit.run_until([&] { return unit.read(2666) == -3000.0; }));
  EXPECT_TRUE(unit.finds());
}

TEST(ReferenceSearch, LetsMarksCountInTheirWindowOnly) {
  SearchUnit unit{{cam(3.3, 5.2)}};
  unit.set(2609, 20000.0);
  unit.set(2610, 8000.0);  // so from 12000 LU on
  unit.start();
  ASSERT_TRUE(unit.finds());
  unit.run(600);
  EXPECT_NEAR(unit.place(), 20000.0, 1.0);
  EXPECT_NEAR(unit.read(2680), -13000.0, 60.0);
}

TEST(ReferenceSearch, TakesAMarkAtATerminal) {
  SearchUnit unit{{{.input = 3, .from = 1.2345, .to = 1.5}}};
  unit.set(494, 4.0);
  unit.set(2607, 0.0);
  unit.start();
  ASSERT_TRUE(unit.finds());
  unit.run(600);
  EXPECT_NEAR(unit.place(), 12345.0, 1.0);
}

TEST(ReferenceSearch, TakesOnlyTheMarkThatATerminalSelects) {
  SearchUnit unit{{{.input = 3, .from = 1.5, .to = 2.5}}};
  unit.set(493, 4.0);
  unit.set(2607, 0.0);
  unit.start();
  ASSERT_TRUE(unit.finds());
  unit.run(600);
  EXPECT_NEAR(unit.place(), 20000.0, 1.0);
}

TEST(ReferenceSearch, FailsWithoutTheCam) {
  SearchUnit unit{{}};
  unit.set(2606, 30000.0);
  unit.start();
  EXPECT_TRUE(unit.fails_with(7458));
  EXPECT_GT(unit.place(), 30000.0);
  EXPECT_EQ(unit.messages(), std::vector{7458});
}

TEST(ReferenceSearch, FailsWithoutTheMark) {
  SearchUnit unit{{cam(3.3, 5.2)}};
  unit.set(2609, 2000.0);
  unit.start();
  EXPECT_TRUE(unit.fails_with(7459));
  EXPECT_EQ(unit.messages(), std::vector{7459});
}

TEST(ReferenceSearch, FailsBetweenTwoReversingCamsWithoutMark) {
  SearchUnit unit{{plus_cam(0.4), minus_cam(-0.3)}, 0.5};
  unit.set(2607, 0.0);
  unit.set(2608, 300.0);
  for (int round = 0; round < 2; ++round) {
    unit.start();
    EXPECT_TRUE(unit.fails_with(7459));
    EXPECT_LT(unit.place(), -0.3 * kRevolution);
    unit.set(2595, 0.0);
    unit.run(1000);
    unit.acknowledge();
    unit.enable();
  }
}

TEST(ReferenceSearch, FailsWhereTheCamHasNoEnd) {
  SearchUnit unit{{cam(-kAnywhere, kAnywhere)}};
  unit.set_reference(-2147470000.0);
  unit.start();
  EXPECT_TRUE(unit.fails_with(7460));
  EXPECT_NEAR(unit.read(2521), -2147482648.0, 100.0);
}

TEST(ReferenceSearch, FailsAtAReversingCamOfTheWrongSide) {
  SearchUnit unit{{{.input = kMinusInput, .from = 2.0, .to = 3.0, .inverted = true}}};
  unit.start();
  EXPECT_TRUE(unit.fails_with(7499));
  SearchUnit both{{plus_cam(2.0)}};
  both.wire(2613, {722, kControlUnitNumber, kPlusInput});
  both.start();
  EXPECT_TRUE(both.fails_with(7499));
}

TEST(ReferenceSearch, EndsWithItsSignal) {
  SearchUnit unit{{cam(3.3, 5.2)}};
  unit.set_reference();
  unit.start();
  EXPECT_FALSE(unit.is_referenced());
  unit.run(300);
  unit.set(2595, 0.0);
  EXPECT_TRUE(unit.run_until([&] { return unit.has(7495); }, 3));
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }, 1000));
  EXPECT_TRUE(unit.bit(2683, 2));
  EXPECT_FALSE(unit.bit(2684, 0));
  EXPECT_FALSE(unit.is_referenced());
  EXPECT_TRUE(unit.messages().empty());
  unit.start();
  EXPECT_TRUE(unit.finds());
}

TEST(ReferenceSearch, ForgetsThePastAtItsStart) {
  SearchUnit unit{{cam(3.3, 5.2)}};
  unit.start();
  ASSERT_TRUE(unit.finds());
  EXPECT_NE(unit.read(2680), 0.0);
  unit.set(2595, 0.0);
  unit.run(2);
  EXPECT_TRUE(unit.is_referenced());
  unit.start();
  EXPECT_EQ(unit.read(2680), 0.0);
  EXPECT_FALSE(unit.is_referenced());
}

}  // namespace
}  // namespace drive
