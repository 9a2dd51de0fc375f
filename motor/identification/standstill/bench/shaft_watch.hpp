#pragma once

#include <algorithm>
#include <cmath>

#include "motor/control/measurement.hpp"

namespace motor {

/// How far the shaft has turned, as the encoder sees it.
class ShaftWatch {
 public:
  /// Begins where the next step() finds the shaft of a machine with @p pole_pairs.
  void start(double pole_pairs) noexcept {
    *this = {};
    pole_pairs_ = pole_pairs;
  }
  /// Follows the shaft, which turns less than half a pole pitch from call to call.
  void step(const Measurement& measured) noexcept {
    const SpaceVector now = measured.rotor;
    if (seen_) angle_ += std::atan2(cross(last_, now), dot(last_, now)) / pole_pairs_;
    seen_ = true;
    last_ = now;
    travel_ = std::max(travel_, std::abs(angle_));
  }
  /// From the start (rad).
  double angle() const noexcept { return angle_; }
  /// The furthest that it was from there (rad).
  double travel() const noexcept { return travel_; }

 private:
  SpaceVector last_{};
  double pole_pairs_ = 1.0;
  double angle_ = 0.0;
  double travel_ = 0.0;
  bool seen_ = false;
};

}  // namespace motor
