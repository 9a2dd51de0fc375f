#include <gtest/gtest.h>

#include "tests/daemon/configuration/command_line.hpp"

namespace axisd {
namespace {

/// The first axis of a configuration whose `axes` hold @p axis alone.
AxisConfiguration axis_of(const std::string& axis) {
  return parse_configuration(R"({"axes": [)" + axis + "]}", "node.json").axes.at(0);
}

TEST(ConfiguredLoad, TakesFrictionThatALoadTorqueCanTakeThePlaceOf) {
  const AxisConfiguration axis =
      axis_of(R"({"load": {"gear": 2, "torque": [{"type": "friction", "torque": 5}, 3]}})");

  EXPECT_EQ(axis.load.friction_torque, 2.5);
  EXPECT_EQ(axis.load.constant_torque, 1.5);
}

TEST(ConfiguredLoad, TakesAHoistAsALoad) {
  const AxisConfiguration axis = axis_of(R"({"load": {"torque": {"type": "hoist", "mass": 10, "radius": 0.05}}})");

  EXPECT_DOUBLE_EQ(axis.load.constant_torque, 10 * 9.80665 * 0.05);
  EXPECT_EQ(axis.load.fan_coefficient, 0.0);
}

TEST(ConfiguredLoad, TakesAFanAsALoad) {
  const AxisConfiguration axis = axis_of(R"({"load": {"torque": {"type": "fan", "coefficient": 2e-5}}})");

  EXPECT_EQ(axis.load.fan_coefficient, 2e-5);
  EXPECT_EQ(axis.load.constant_torque, 0.0);
}

TEST(ConfiguredLoad, TakesEverySectionOfALoad) {
  const motor::Load load = axis_of(R"({"load": {
    "inertia": 0.01,
    "friction": {"coulomb": 1, "viscous": 0.1, "breakaway": 1.5, "stribeck_speed": 2},
    "coupling": {"stiffness": 500, "damping": 0.2, "backlash": 0.01},
    "end_stops": {"lower": -10, "upper": 20, "stiffness": 5000, "damping": 3},
    "brake": {"torque": 15, "opening_time": 0.2, "closing_time": 0.03},
    "torque": [2, {"type": "constant", "torque": 3}, {"type": "pendulum", "mass": 1, "radius": 0.1},
               {"type": "profile", "points": [[0, 1], [0.5, -1], [1, 1]], "repeats": true}]
  }})")
                               .load;

  EXPECT_EQ(load.inertia, 0.01);
  EXPECT_EQ(load.breakaway_torque, 1.5);
  EXPECT_EQ(load.stribeck_speed, 2.0);
  EXPECT_EQ(load.coupling.stiffness, 500.0);
  EXPECT_EQ(load.coupling.damping, 0.2);
  EXPECT_EQ(load.coupling.backlash, 0.01);
  EXPECT_EQ(load.end_stops.lower, -10.0);
  EXPECT_EQ(load.end_stops.upper, 20.0);
  EXPECT_EQ(load.end_stops.stiffness, 5000.0);
  EXPECT_EQ(load.end_stops.damping, 3.0);
  EXPECT_EQ(load.brake.torque, 15.0);
  EXPECT_EQ(load.brake.opening_time, 0.2);
  EXPECT_EQ(load.brake.closing_time, 0.03);
  EXPECT_EQ(load.constant_torque, 5.0);
  EXPECT_DOUBLE_EQ(load.pendulum_torque, 0.1 * 9.80665);
  ASSERT_EQ(load.profile.count, 3U);
  EXPECT_EQ(load.profile.points[1].time, 0.5);
  EXPECT_EQ(load.profile.points[1].torque, -1.0);
  EXPECT_TRUE(load.profile.repeats);
}

TEST(ConfiguredLoad, RefersALoadBehindAGearToTheShaft) {
  const motor::Load load = axis_of(R"({"load": {
    "gear": 10, "inertia": 1, "friction": {"coulomb": 5, "viscous": 2, "breakaway": 6, "stribeck_speed": 1},
    "coupling": {"stiffness": 1000, "damping": 1, "backlash": 0.01}, "end_stops": {"lower": -1, "upper": 2},
    "brake": {"torque": 3}, "torque": [20, {"type": "fan", "coefficient": 1}]
  }})")
                               .load;

  EXPECT_DOUBLE_EQ(load.inertia, 0.01);
  EXPECT_DOUBLE_EQ(load.coulomb_friction, 0.5);
  EXPECT_DOUBLE_EQ(load.viscous_friction, 0.02);
  EXPECT_DOUBLE_EQ(load.breakaway_torque, 0.6);
  EXPECT_DOUBLE_EQ(load.stribeck_speed, 10.0);
  EXPECT_DOUBLE_EQ(load.coupling.stiffness, 10.0);
  EXPECT_DOUBLE_EQ(load.coupling.damping, 0.01);
  EXPECT_DOUBLE_EQ(load.coupling.backlash, 0.1);
  EXPECT_DOUBLE_EQ(load.end_stops.lower, -10.0);
  EXPECT_DOUBLE_EQ(load.end_stops.upper, 20.0);
  EXPECT_DOUBLE_EQ(load.constant_torque, 2.0);
  EXPECT_DOUBLE_EQ(load.fan_coefficient, 1e-3);
  EXPECT_DOUBLE_EQ(load.brake.torque, 3.0);  // it is on the motor shaft
}

}  // namespace
}  // namespace axisd
