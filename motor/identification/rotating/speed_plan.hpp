#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "motor/control/observation.hpp"
#include "motor/data/control_period.hpp"

namespace motor {

/// Speeds that a measurement wants to see, one after the other.
struct SpeedPlan {
  struct Stop {
    double speed = 0.0;       ///< (rad/s)
    double hold = 0.0;        ///< how long it is kept once it is reached (s)
    double flux_share = 1.0;  ///< of the rated flux, from the way there on
  };
  std::array<Stop, 8> stops{};
  std::size_t count = 0;  ///< of the stops; none: the measurement cannot be made

  void add(const Stop& stop) noexcept { stops[count++] = stop; }
};

/// Where on a plan a drive is.
struct SpeedPlace {
  std::size_t stop = 0;    ///< the one it is at or goes to
  double held = -1.0;      ///< time for which it has been there (s), negative on the way
  double remaining = 0.0;  ///< of the time there (s)
};

/// Leads a drive along a plan by a speed setpoint that changes with a slope, and waits for nothing for ever.
class SpeedWalk {
 public:
  enum class Progress { Running, Done, Late };

  /// Goes from the present setpoint on; @p slope (rad/s²) and @p tolerance of the speed (rad/s) are positive.
  void start(const SpeedPlan& plan, double slope, double tolerance) noexcept {
    plan_ = plan;
    slope_ = slope;
    tolerance_ = tolerance;
    head_for(0);
  }
  /// One period; @p ready is false as long as the machine gives no torque yet.
  Progress step(const Observation& seen, bool ready) noexcept {
    const SpeedPlan::Stop& stop = plan_.stops[place_.stop];
    left_ -= kControlPeriod;
    if (left_ < 0.0) return Progress::Late;
    // A setpoint that went on while the torque is limited would only be run after.
    const double way = ready && !seen.torque_limit_reached ? slope_ * kControlPeriod : 0.0;
    change_ = std::clamp(stop.speed - setpoint_, -way, way);
    setpoint_ += change_;
    if (place_.held < 0.0) return arrive(stop, seen.speed, ready);
    place_.held += kControlPeriod;
    place_.remaining -= kControlPeriod;
    if (place_.remaining > 0.0) return Progress::Running;
    if (place_.stop + 1 == plan_.count) return Progress::Done;
    head_for(place_.stop + 1);
    return Progress::Running;
  }
  const SpeedPlace& place() const noexcept { return place_; }
  /// The speed of the present stop (rad/s).
  double goal() const noexcept { return plan_.stops[place_.stop].speed; }
  /// (rad/s)
  double setpoint() const noexcept { return setpoint_; }
  /// Of the setpoint (rad/s²).
  double slope() const noexcept { return change_ / kControlPeriod; }
  double flux_share() const noexcept { return plan_.stops[place_.stop].flux_share; }
  /// The speeds between which the walk stays (rad/s).
  double highest() const noexcept { return reach(1.0); }
  double lowest() const noexcept { return -reach(-1.0); }

 private:
  static constexpr double kPatience = 4.0;   // times the duration of the ramp
  static constexpr double kLeastTime = 2.0;  // s, to magnetise and to settle

  Progress arrive(const SpeedPlan::Stop& stop, double speed, bool ready) noexcept {
    const bool there = std::abs(stop.speed - setpoint_) <= 0.0 && std::abs(stop.speed - speed) < tolerance_;
    if (ready && there) place_.held = 0.0;
    return Progress::Running;
  }
  void head_for(std::size_t index) noexcept {
    const SpeedPlan::Stop& stop = plan_.stops[index];
    place_ = {.stop = index, .held = -1.0, .remaining = stop.hold};
    left_ = stop.hold + kLeastTime + kPatience * std::abs(stop.speed - setpoint_) / slope_;
  }
  double reach(double sign) const noexcept {
    double result = 0.0;
    for (std::size_t i = 0; i < plan_.count; ++i) result = std::max(result, sign * plan_.stops[i].speed);
    return result;
  }

  SpeedPlan plan_{};
  SpeedPlace place_{};
  double slope_ = 1.0;
  double tolerance_ = 1.0;
  double setpoint_ = 0.0;
  double change_ = 0.0;  // of the setpoint in the last period (rad/s)
  double left_ = 0.0;    // s
};

}  // namespace motor
