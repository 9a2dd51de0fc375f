#pragma once

#include <cmath>

#include "motor/control/observation.hpp"
#include "motor/data/control_period.hpp"

namespace motor {

/// Notices a shaft that is at the torque limit and comes no nearer to the speed that is wanted.
class StallWatch {
 public:
  /// Looks for a shaft that gains less than @p gain (rad/s, positive) in kTime.
  explicit StallWatch(double gain = 1.0) noexcept : gain_{gain} {}

  /// One period on the way to @p goal (rad/s); true once the shaft is stalled.
  bool step(double goal, const Observation& seen) noexcept {
    const double missing = std::abs(goal - seen.speed);
    const bool other_goal = goal < goal_ || goal > goal_;
    if (!seen.torque_limit_reached || other_goal || missing < nearest_ - gain_) {
      nearest_ = missing;
      time_ = 0.0;
    }
    goal_ = goal;
    time_ += kControlPeriod;
    return seen.torque_limit_reached && time_ > kTime;
  }

 private:
  static constexpr double kTime = 0.2;  // s

  double gain_;
  double goal_ = 0.0;
  double nearest_ = 0.0;
  double time_ = 0.0;
};

}  // namespace motor
