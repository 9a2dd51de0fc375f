#pragma once

#include <array>
#include <limits>
#include <span>

#include "drive/messages/cause.hpp"
#include "motor/control/signals.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// Torque limits, supplementary torques, and in torque control the setpoint. All torques in N·m.
class TorqueSetpoint {
 public:
  static constexpr double kAsParameter = std::numeric_limits<double>::infinity();

  struct Settings {
    using Block = TorqueSetpoint;

    double upper_limit = 0.0;       ///< p1520
    double lower_limit = 0.0;       ///< p1521
    double reduction_weight = 1.0;  ///< p1544, what 100 % of p1542 take off
    double threshold = 0.0;         ///< p2194, share of the limit, r2199.11
  };
  struct Inputs {
    using Block = TorqueSetpoint;

    double setpoint = 0.0;               ///< p1503
    double supplementary_1 = 0.0;        ///< p1511
    double supplementary_2 = 0.0;        ///< p1513
    double upper_limit = kAsParameter;   ///< p1522, p1520 if it is infinite
    bool travels_to_fixed_stop = false;  ///< p1545
    double lower_limit = kAsParameter;   ///< p1523, p1521 if it is infinite
    double reduction = 0.0;              ///< p1542 (MOMRED), a share, taken off both limits
    double upper_scaling = 1.0;          ///< p1552, share of the upper limit that is left
    double lower_scaling = 1.0;          ///< p1554, the same of the lower limit

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// What it does in a cycle.
  struct Turn {
    bool leads = false;    ///< torque control with the operation enabled
    bool enabled = true;   ///< p0856; a disabled speed controller gives no torque
    bool halts = false;    ///< the setpoint goes to zero
    double halt_step = 0;  ///< by so much in the cycle
  };
  /// Takes up the limits of this cycle.
  void limit() noexcept;
  /// Enters limits, supplementary torque and setpoint into @p command.
  void run(const Turn& turn, motor::DriveCommand& command) noexcept;

  /// Of the last cycle, from inputs and settings.
  const motor::TorqueLimits& limits() const noexcept { return limits_; }
  /// Whether the torque setpoint led in the last cycle.
  bool led() const noexcept { return led_; }
  /// Lower limit above the upper one.
  double crossed_limits() const noexcept { return limits_.lower - limits_.upper; }

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  void scale() noexcept;

  motor::TorqueLimits limits_{};
  double setpoint_ = 0.0;  // of torque control
  bool led_ = false;
};

template <>
inline constexpr auto causes_of<TorqueSetpoint> = std::array{
    CauseRow<TorqueSetpoint>{7090, &TorqueSetpoint::crossed_limits, Side::Above, cause::kNone, cause::kNone,
                             cause::kAtOnce, Pulses::Any, nullptr, cause::kNone, "p1520 below p1521"},
};

}  // namespace drive
