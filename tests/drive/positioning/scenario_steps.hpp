#pragma once

#include <cstdint>
#include <functional>
#include <numbers>

#include "tests/drive/positioning/positioning_unit.hpp"

/// Axes and steps that scenarios are made of.
namespace drive::scenario {

inline AxisConfiguration plain() {
  return PositioningUnit::axis_configuration();
}
inline AxisConfiguration with_absolute_encoder() {
  AxisConfiguration axis = plain();
  axis.machine.encoder.type = motor::EncoderType::Absolute;
  axis.machine.encoder.revolutions = 16;
  return axis;
}
inline AxisConfiguration with_wall() {
  AxisConfiguration axis = plain();
  axis.load.end_stops.upper = 2.0 * std::numbers::pi;  // 10000 LU
  axis.load.end_stops.stiffness = 2000.0;
  return axis;
}
inline AxisConfiguration with_probe() {
  AxisConfiguration axis = plain();
  axis.switches.add({.input = 3, .from = 0.5, .to = 0.6});
  return axis;
}

using TestedUnit = PositioningUnit;

inline void enable_and_reference(TestedUnit& unit) {
  unit.enable();
  unit.set_reference();
}
/// Block 1 as @p block, started.
inline void start(TestedUnit& unit, const TestedUnit::Block& block) {
  enable_and_reference(unit);
  unit.block(0, block);
  unit.set(2632, 1.0);
  unit.set(2625, 1.0);
  unit.set(2631, 1.0);
  unit.run(2);
}
/// Software limits at ±20000 LU, and an MDI to @p target.
inline void move_within_limits(TestedUnit& unit, double target) {
  enable_and_reference(unit);
  unit.set(2580, -20000.0);
  unit.set(2581, 20000.0);
  unit.set(2582, 1.0);
  unit.move(target);
}
inline void activate_limits_outside(TestedUnit& unit, double lower, double upper) {
  enable_and_reference(unit);
  unit.set(2580, lower);
  unit.set(2581, upper);
  unit.set(2582, 1.0);
}
/// Block 1 as @p block in the table, without a start; block 5 follows it.
inline std::function<void(TestedUnit&)> checked(const TestedUnit::Block& block) {
  return [block](TestedUnit& unit) {
    unit.block(0, block);
    unit.block(1, {.number = 5});
  };
}
inline void search(TestedUnit& unit) {
  unit.enable();
  unit.set(2605, 3000.0);
  unit.set(2595, 1.0);
}
inline void jog_from(TestedUnit& unit, double place, std::uint16_t jog) {
  unit.enable();
  unit.set(2585, -6000.0);
  unit.set(2586, 6000.0);
  unit.set_reference(place);
  unit.set(jog, 1.0);
}
inline void clamp(TestedUnit& unit) {
  start(unit, {.number = 1, .task = 2, .position = 20000.0, .velocity = 600.0, .parameter = 300.0});
}

}  // namespace drive::scenario
