// What bounds the velocity and the jerk of the positioner over a whole unit.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/positioning/recorded_unit.hpp"

namespace drive {
namespace {

TEST(VelocityLimits, FollowTheirReference) {
  PositioningUnit unit;
  unit.enable();
  unit.set_reference();
  RecordedUnit recorded{"k1_override", unit};
  for (const int number : {2571, 2572, 2573})
    unit.set(static_cast<std::uint16_t>(number), recorded.file.number("/parameters/p" + std::to_string(number)));
  unit.wire(2646, {2900, kOwnObject, 0});
  const nlohmann::json& stimulus = recorded.file.about.at("stimulus");
  int number = 0;
  for (const nlohmann::json& step : stimulus.at("override")) {
    const double time = step.at("t_s").get<double>();
    recorded.set_at(time, 2900, step.at("pct").get<double>());
    const double effective =
        recorded.file.number("/events/override_" + std::to_string(++number) + "_effective_pct");
    recorded.at(time + 0.1, [&unit, effective] {
      EXPECT_NEAR(unit.read(2681), effective, 1e-3);
      EXPECT_EQ(unit.bit(2683, 1), effective == 110.0);
      EXPECT_EQ(unit.has(7456), effective == 110.0);
      EXPECT_TRUE(unit.bit(2684, 15));
    });
  }
  recorded.at(0.0, [&] {
    unit.set(2690, stimulus.at("target").get<double>());
    unit.set(2691, recorded.file.number("/parameters/p2643"));
    unit.set(2648, 1.0);
    unit.set(2647, 1.0);
    unit.set(2650, 1.0);
  });
  recorded.run();
  recorded.expect_agreement();
  EXPECT_EQ(unit.read(2665), stimulus.at("target").get<double>());
  EXPECT_TRUE(unit.messages().empty()) << testing::PrintToString(unit.messages());
}

/// Jogs with 9000·1000 LU/min until the velocity is constant; returns that.
double velocity_of_a_jog(PositioningUnit& unit, std::uint16_t jog = 2590) {
  unit.set(2585, -9000.0);
  unit.set(2586, 9000.0);
  unit.set(jog, 1.0);
  unit.run(2500);
  return unit.read(2666);
}

TEST(VelocityLimits, AreThoseOfThePositionerOfTheMotorAndFromOutside) {
  const auto run = [](const std::function<void(PositioningUnit&)>& prepare, double expected,
                      std::uint16_t jog = 2590) {
    PositioningUnit unit;
    prepare(unit);
    unit.enable();
    EXPECT_NEAR(velocity_of_a_jog(unit, jog), expected, 0.5);
    const bool capped = std::abs(expected) < 9000.0;
    EXPECT_EQ(unit.bit(2683, 1), capped);
    EXPECT_EQ(unit.has(7456), capped);
    EXPECT_NEAR(unit.read(2681), std::abs(expected) / 90.0, 0.01);
    unit.set(jog, 0.0);
    EXPECT_TRUE(unit.run_until([&] { return unit.read(2669) == 0.0; }));
    unit.run(2);
    EXPECT_FALSE(unit.bit(2683, 1));
    EXPECT_FALSE(unit.has(7456));
  };
  const auto from_outside = [](std::size_t index) {
    return [index](PositioningUnit& unit) {
      unit.wire(2594, {2691, kOwnObject, 0}, index), unit.set(2691, 4000.0);
    };
  };
  run([](PositioningUnit&) {}, 9000.0);
  run([](PositioningUnit& unit) { unit.set(2571, 8000.0); }, 8000.0);
  run([](PositioningUnit& unit) { unit.set(1082, 500.0); }, 5000.0);
  run([](PositioningUnit& unit) { unit.set(1083, 400.0); }, 4000.0);
  run([](PositioningUnit& unit) { unit.set(1086, -300.0); }, 3000.0);
  run(from_outside(0), 4000.0);
  run(from_outside(1), 4000.0);
  run(from_outside(1), -9000.0, 2589);
  run(from_outside(2), -4000.0, 2589);
}

TEST(VelocityLimits, OfAModuloAxisAreHalfARangeInACycle) {
  PositioningUnit unit;
  unit.set(2571, 30000.0);
  unit.set(2576, 900.0);
  EXPECT_FALSE(unit.has(7455));
  unit.set(2577, 1.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7455));
  unit.set(2576, 1100.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7455));
}

TEST(JerkLimits, TakeASecondAtTheMost) {
  PositioningUnit unit;
  EXPECT_FALSE(unit.has(7440));
  unit.set(2574, 50.0);
  unit.run(2);
  EXPECT_TRUE(unit.has(7440)) << "also without jerk limiting";
  unit.set(2574, 100.0);
  unit.run(2);
  EXPECT_FALSE(unit.has(7440));
}

}  // namespace
}  // namespace drive
