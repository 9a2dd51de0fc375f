// Modulo axes, gears and backlash over a whole unit.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/drive/positioning/recorded_unit.hpp"

namespace drive {
namespace {

constexpr double kRange = 360000.0;

struct ModuloUnit : PositioningUnit {
  explicit ModuloUnit(double range = kRange) {
    set(2576, range);
    set(2577, 1.0);
    enable();
    EXPECT_TRUE(bit(2684, 9));
  }
};

TEST(Modulo, GoesEveryWayOfItsReference) {
  ModuloUnit unit;
  RecordedUnit recorded{"k7_modulo", unit};
  for (const int number : {2571, 2572, 2573})
    unit.set(static_cast<std::uint16_t>(number), recorded.file.number("/parameters/p" + std::to_string(number)));
  unit.set(2691, recorded.file.number("/parameters/p2643"));
  unit.set_reference(recorded.stimulus("start"));
  unit.set(2648, 1.0);
  unit.set(2647, 1.0);
  for (const nlohmann::json& task : recorded.file.about.at("stimulus").at("tasks")) {
    const double time = task.at("t_s").get<double>();
    const std::string way = task.at("way").get<std::string>();
    recorded.set_at(time, 2690, task.at("p2642").get<double>());
    recorded.set_at(time, 2651, way == "positive" ? 1.0 : 0.0);
    recorded.set_at(time, 2652, way == "negative" ? 1.0 : 0.0);
    recorded.set_at(time, 2650, 1.0);
    recorded.set_at(time + 0.05, 2650, 0.0);
  }
  double before = unit.read(2665);
  const auto end = static_cast<int>(recorded.file.table.abscissa().back() * 1000.0);
  for (int now = 0; now <= end; ++now)
    recorded.at(now * 1e-3, [&] {
      const double setpoint = unit.read(2665);
      EXPECT_GE(setpoint, 0.0);
      EXPECT_LT(setpoint, kRange);
      recorded.turned -= kRange * std::round((setpoint - before) / kRange);
      before = setpoint;
    });
  recorded.run();
  recorded.expect_agreement();
  unit.run(300);
  EXPECT_EQ(unit.read(2665), 190000.0);
  EXPECT_NEAR(unit.read(2521), 190000.0, 1.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(Modulo, LandsOnItsTargetAtTheWrap) {
  ModuloUnit unit;
  unit.set_reference(359000.0);
  unit.move(0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 0.0);
  unit.run(500);
  EXPECT_NEAR(unit.read(2521), 0.0, 1.0);
  EXPECT_NEAR(unit.read(2521, 1), 1000.0, 1.0);
  unit.move(359999.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  EXPECT_EQ(unit.read(2665), 359999.0);
  unit.run(500);
  EXPECT_NEAR(unit.read(2521, 1), 999.0, 1.0);
}

TEST(Modulo, IsSwitchedWithThePulsesOffOnly) {
  PositioningUnit unit;
  unit.wire(2577, {8890, kOwnObject, 4});
  unit.enable();
  unit.control(0x001F);
  unit.run(10);
  EXPECT_FALSE(unit.bit(2684, 9));
  unit.control(0x0016);
  EXPECT_TRUE(unit.run_until([&] { return unit.bit(2684, 9); }, 1000));
  unit.control(0x0006);
  EXPECT_TRUE(unit.run_until([&] { return !unit.bit(2684, 9); }, 1000));
}

TEST(Modulo, LosesNoUnitWithAGearInManyTurns) {
  PositioningUnit unit;
  unit.set(2504, 3.0);
  unit.set(2505, 7.0);
  unit.set(2506, 10007.0);
  unit.set(2576, 10007.0);
  unit.set(2577, 1.0);
  unit.set(2571, 60000.0);
  unit.set(2572, 2000.0);
  unit.set(2573, 2000.0);
  unit.set(2586, 60000.0);
  unit.set(2585, -60000.0);
  EXPECT_NEAR(unit.read(2524), 10007.0 * 7.0 / 3.0, 0.01);
  unit.enable();
  unit.set_reference();
  const std::int64_t zero = unit.axis().actual().encoder_counts;
  unit.set(2590, 1.0);
  unit.run(10000);
  unit.set(2590, 0.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
  unit.run(500);
  constexpr double kCounts = 2048.0 * 2048.0;  // of a revolution of the motor
  const double counts = static_cast<double>(unit.axis().actual().encoder_counts - zero);
  const double way = std::round(counts * (10007.0 * 7.0) / (kCounts * 3.0));
  EXPECT_GT(way, 900.0 * 10007.0);
  EXPECT_NEAR(unit.read(2521), way - 10007.0 * std::floor(way / 10007.0), 1.0);  // the zero lies between counts
  EXPECT_NEAR(unit.read(2665), unit.read(2521), 2.0);
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

TEST(Backlash, IsPassedAfterAReversal) {
  PositioningUnit unit;
  unit.set(2583, 250.0);
  unit.set(2534, 0.0);  // no overshoot
  unit.enable();
  unit.set_reference();
  unit.move(10000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.run(800);
  const double forwards = unit.read(2521, 1);
  unit.move(5000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.run(800);
  EXPECT_NEAR(unit.read(2521), 5000.0, 1.0);
  EXPECT_NEAR(forwards - unit.read(2521, 1), 5250.0, 2.0);
  EXPECT_NEAR(std::abs(unit.read(2667)), 250.0, 2.0);
  unit.move(10000.0);
  ASSERT_TRUE(unit.run_until([&] { return unit.is_done(); }));
  unit.run(800);
  EXPECT_NEAR(unit.read(2521, 1), forwards, 2.0);
}

}  // namespace
}  // namespace drive
