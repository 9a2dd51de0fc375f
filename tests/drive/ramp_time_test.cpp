// Ramps of a whole axis against their solutions in closed form: at the end of every cycle the setpoint behind the
// ramp is where the solution is within one cycle of that moment.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

constexpr double kMaximum = 3000.0;  // rpm, p1082

/// Way along a ramp of @p change (all in rpm and s) after @p t: slope @p slope, which builds up in @p ti and
/// vanishes in @p tf.
double rounded_way(double t, double change, double slope, double ti, double tf) {
  const bool full = slope * (ti + tf) / 2 <= change;
  const double peak = full ? slope : std::sqrt(2 * change * slope / (ti + tf));
  const double build = ti * peak / slope;
  const double vanish = tf * peak / slope;
  const double steady = full ? change / slope - (ti + tf) / 2 : 0.0;
  const double end = build + steady + vanish;
  if (t <= 0) return 0.0;
  if (t < build) return peak * t * t / build / 2;
  if (t < build + steady) return peak * (t - build / 2);
  if (t < end) return change - peak * (end - t) * (end - t) / vanish / 2;
  return change;
}

using Solution = std::function<double(double)>;

/// Runs @p drive for @p seconds and holds its setpoint against @p speed, of the time since now.
void expect_solution(TestAxis& drive, const Solution& speed, double seconds) {
  const double cycle = TestAxis::kCycle;
  for (int i = 1; i * cycle <= seconds; ++i) {
    drive.run(cycle);
    const double before = speed((i - 1) * cycle), after = speed((i + 1) * cycle);
    ASSERT_GE(drive.demand_rpm(), std::min(before, after) - 0.01) << "after " << i * cycle << " s";
    ASSERT_LE(drive.demand_rpm(), std::max(before, after) + 0.01) << "after " << i * cycle << " s";
  }
  ASSERT_NEAR(drive.demand_rpm(), speed(seconds), 0.01) << "at the end";
}

/// The time from now until the setpoint is at @p rpm.
double time_to(TestAxis& drive, double rpm) {
  return drive.run_until([=](const Axis& a) { return std::abs(a.actual().speed_demand / kRpm - rpm) < 1e-6; },
                         60.0);
}

struct Times {
  double up = 10, down = 10, initial = 0, final_time = 0;
  int type = 0;
};

TestAxis axis_with(const Times& times) {
  TestAxis drive;
  EXPECT_TRUE(drive.axis.write(1082, kMaximum));
  EXPECT_TRUE(drive.axis.write(1115, times.initial + times.final_time > 0 ? 1.0 : 0.0));
  EXPECT_TRUE(drive.axis.write(1130, times.initial));
  EXPECT_TRUE(drive.axis.write(1131, times.final_time));
  EXPECT_TRUE(drive.axis.write(1134, times.type));
  EXPECT_TRUE(drive.axis.write(1136, times.initial));
  EXPECT_TRUE(drive.axis.write(1137, times.final_time));
  drive.enable(0.0);
  EXPECT_TRUE(drive.axis.write(1120, times.up));
  EXPECT_TRUE(drive.axis.write(1121, times.down));
  return drive;
}

/// Lets @p drive turn steadily at @p rpm.
void turn(TestAxis& drive, double rpm, const Times& times) {
  EXPECT_TRUE(drive.axis.write(1120, 0.3));
  EXPECT_TRUE(drive.axis.write(1121, 0.3));
  drive.setpoints.speed = rpm * kRpm;
  drive.run(4.0);
  EXPECT_TRUE(drive.axis.write(1120, times.up));
  EXPECT_TRUE(drive.axis.write(1121, times.down));
  EXPECT_NEAR(drive.demand_rpm(), rpm, 1e-6);
}

class RampTime : public testing::TestWithParam<Times> {};

TEST_P(RampTime, FromZeroToTheMaximumSpeedEachWay) {
  const Times p = GetParam();
  const double end = p.up + (p.initial + p.final_time) / 2 + 0.5;
  for (const double direction : {1.0, -1.0}) {
    TestAxis drive = axis_with(p);
    drive.setpoints.speed = direction * kMaximum * kRpm;
    expect_solution(
        drive,
        [&](double t) { return direction * rounded_way(t, kMaximum, kMaximum / p.up, p.initial, p.final_time); },
        end);
  }
}

TEST_P(RampTime, OverAPartOfTheSpeedAndBackToZero) {
  const Times p = GetParam();
  TestAxis drive = axis_with(p);
  drive.setpoints.speed = 700.0 * kRpm;
  expect_solution(
      drive, [&](double t) { return rounded_way(t, 700, kMaximum / p.up, p.initial, p.final_time); }, p.up + 4);
  drive.setpoints.speed = 0.0;
  expect_solution(
      drive, [&](double t) { return 700 - rounded_way(t, 700, kMaximum / p.down, p.initial, p.final_time); },
      p.down + 4);
}

TEST_P(RampTime, InReversal) {
  Times p = GetParam();
  if (p.initial + p.final_time > 0) p.down = p.up;  // otherwise the slope changes within the rounding
  for (const double direction : {1.0, -1.0}) {
    TestAxis drive = axis_with(p);
    turn(drive, direction * 1500, p);
    drive.setpoints.speed = -direction * 1500 * kRpm;
    const Solution speed = [&](double t) {
      if (p.initial + p.final_time > 0)
        return direction * (1500 - rounded_way(t, 3000, kMaximum / p.up, p.initial, p.final_time));
      const double zero = p.down / 2;
      const double way = t < zero ? 1500 - t * kMaximum / p.down : -(t - zero) * kMaximum / p.up;
      return direction * std::max(way, -1500.0);
    };
    expect_solution(drive, speed, p.up / 2 + p.down / 2 + 4);
  }
}

TEST_P(RampTime, OfOff1AndOff3) {
  const Times p = GetParam();
  for (const double direction : {1.0, -1.0})
    for (const bool quick : {false, true}) {
      TestAxis drive = axis_with(p);
      ASSERT_TRUE(drive.axis.write(1135, 0.8));
      ASSERT_TRUE(drive.axis.write(1226, 0.0));  // otherwise the pulses go before the rounded end
      turn(drive, direction * 2400, p);
      const double time = quick ? 0.8 : p.down;
      const double exact = 2400 / kMaximum * time + (p.initial + p.final_time) / 2;
      drive.setpoints.controlword = quick ? 0x000B : 0x000E;
      if (2400 * 2 < kMaximum / time * (p.initial + p.final_time)) continue;  // the full slope is not reached
      EXPECT_NEAR(time_to(drive, 0.0), exact, TestAxis::kCycle) << (quick ? "OFF3" : "OFF1");
    }
}

INSTANTIATE_TEST_SUITE_P(Ramps, RampTime,
                         testing::Values(Times{2, 1}, Times{1, 3}, Times{2, 1, 0.5, 0.3}, Times{1, 2, 0, 0.4},
                                         Times{1, 1, 0.4, 0}, Times{1, 1, 1.0, 1.0}, Times{1, 1.5, 0.6, 1.8},
                                         Times{2, 1, 0.5, 0.3, 1}));

TEST(RampTimes, AreSteps) {
  TestAxis drive = axis_with({0, 0});
  drive.setpoints.speed = 2000 * kRpm;
  drive.run(TestAxis::kCycle);
  EXPECT_NEAR(drive.demand_rpm(), 2000, 1e-6);
}

TEST(RampTimes, HaveTheTypeOfRoundingWhereTheTargetComesBack) {
  for (const int type : {0, 1}) {
    const double slope = kMaximum / 2, vanish = 0.3;
    TestAxis drive = axis_with({2, 2, 0.5, vanish, type});
    drive.setpoints.speed = kMaximum * kRpm;
    drive.run(1.0);
    const double reached = drive.demand_rpm();
    ASSERT_NEAR(reached, rounded_way(1.0, kMaximum, slope, 0.5, vanish), 0.01);

    drive.setpoints.speed = 0.0;
    double highest = reached;
    for (int i = 0; i < 250; ++i) {
      drive.run(TestAxis::kCycle);
      highest = std::max(highest, drive.demand_rpm());
    }
    const double past = type == 0 ? slope * vanish / 2 : 0.0;
    EXPECT_NEAR(highest, reached + past, slope * TestAxis::kCycle * 0.1) << "p1134 = " << type;
  }
}

TEST(RampTimes, BelongToTheMaximumSpeed) {
  TestAxis drive = axis_with({2, 2});
  drive.send(0x0000);
  ASSERT_TRUE(drive.axis.write(1082, 1000.0));
  drive.enable(0.0);
  drive.setpoints.speed = 1000 * kRpm;
  EXPECT_NEAR(time_to(drive, 1000), 2.0, TestAxis::kCycle);
}

}  // namespace
}  // namespace drive
