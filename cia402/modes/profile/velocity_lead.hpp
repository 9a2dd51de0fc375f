#pragma once

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/motion/velocity_ramp.hpp"
#include "drive/positioning/profile/trapezoid_profile.hpp"

namespace cia402 {

/// Speed control along slopes, as profile velocity and velocity mode have it. In front of a software limit it
/// brakes under position control, so that the axis stands on the limit, and is held there until it is led away.
class VelocityLead {
 public:
  /// Goes on with @p velocity (position units/s).
  void start(double velocity) noexcept;
  /// The next 1 ms towards @p target (position units/s), as far as the limits allow.
  Demand cycle(double target, const VelocitySlopes& slopes, const Limits& limits, const Actual& actual) noexcept;
  /// The demand (position units/s).
  double velocity() const noexcept { return velocity_; }

 private:
  /// A limit of travel in the direction of the target.
  struct End {
    bool exists = false;
    double direction = 1.0;
    double position = 0.0;  // position units

    friend bool operator==(const End&, const End&) = default;
  };
  /// What the profile was told.
  struct Order {
    double velocity = 0.0;
    VelocitySlopes slopes{};

    friend bool operator==(const Order&, const Order&) = default;
  };

  static End end_of_travel(double target, double position, const Limits& limits) noexcept;
  bool ends_within(const End& end, double next, const VelocitySlopes& slopes, double position) const noexcept;
  void approach(const End& end, const Order& order, const Limits& limits, double position) noexcept;
  void follow(const Order& order) noexcept;

  double velocity_ = 0.0;
  End end_{};  // that is approached, or stood on
  Order order_{};
  drive::TrapezoidProfile profile_{};
};

}  // namespace cia402
