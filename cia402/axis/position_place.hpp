#pragma once

#include <cmath>
#include <cstdint>

#include "cia402/axis/scaling.hpp"
#include "cia402/drive/drive_state.hpp"

namespace cia402 {

/// Where the position value (6064h) of an axis begins: a place of the motor, and what is shown there.
class PositionPlace {
 public:
  /// The position at @p increments of the motor (since power-on) is @p units.
  void set(double increments, double units) noexcept {
    base_ = static_cast<std::int64_t>(std::llround(increments));
    units_ = units;
  }
  /// The position at @p increments of the motor, which need not be whole (position units).
  double at(double increments, const Scaling& scaling) const noexcept {
    const double whole = std::floor(increments);
    const std::int64_t from_base = static_cast<std::int64_t>(whole) - base_;
    const double per_increment = scaling.position().units_per_revolution() / kIncrements;
    return scaling.sign() * (scaling.position().exact_units(from_base) + (increments - whole) * per_increment) +
           units_;
  }
  /// The same, whole.
  std::int64_t whole_at(std::int64_t increments, const Scaling& scaling) const noexcept {
    const std::int64_t units = scaling.position().units(increments - base_);
    return (scaling.sign() < 0.0 ? -units : units) + std::llround(units_);
  }
  /// Where the motor is when the position is @p units (increments since power-on).
  double increments_at(double units, const Scaling& scaling) const noexcept {
    const double per_unit = kIncrements / scaling.position().units_per_revolution();
    return static_cast<double>(base_) + scaling.sign() * (units - units_) * per_unit;
  }

 private:
  std::int64_t base_ = 0;
  double units_ = 0.0;
};

}  // namespace cia402
