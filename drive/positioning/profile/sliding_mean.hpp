#pragma once

#include <cstddef>
#include <vector>

#include "drive/positioning/profile/trapezoid_profile.hpp"

namespace drive {

/// One cycle of the motions (s).
inline constexpr double kMotionCycle = 1e-3;

/// Jerk limiting: the mean of a setpoint over the last n cycles, x_f(t) = 1/Tr · ∫ x from t - Tr to t, Tr = n · 1
/// ms.
///
/// It is fed with the exact ways and areas of the setpoint and tells how far the mean lags behind, so it knows no
/// places: a shift of the coordinates does not concern it.
class SlidingMean {
 public:
  /// Has room for @p capacity cycles; the only allocation.
  explicit SlidingMean(std::size_t capacity) : cycles_(capacity) {}

  /// At rest, over @p cycles (at most the capacity) from now on; 0 = off, the mean is the setpoint itself.
  void start(std::size_t cycles) noexcept;
  /// A cycle of the setpoint: its way, its area from the place where it began, and its velocity at the end
  /// (LU/s).
  void add(const MotionStretch& stretch, double velocity) noexcept;

  std::size_t cycles() const noexcept { return length_; }
  /// How far the mean is behind the setpoint, with its sign (LU); exactly 0 when it is settled.
  double lag() const noexcept { return lag_; }
  double velocity() const noexcept { return velocity_; }          ///< of the mean (LU/s)
  double acceleration() const noexcept { return acceleration_; }  ///< of the mean (LU/s²)
  /// Whether the setpoint did not move in the last n cycles; always, when it is off.
  bool is_settled() const noexcept { return still_ >= length_; }

 private:
  struct Cycle {
    double way = 0.0;       // LU
    double offset = 0.0;    // LU, mean of the way in the cycle
    double velocity = 0.0;  // LU/s, at its end
  };
  /// Sums over cycles: their way, and how far the places within them lie behind the end (LU).
  struct Sums {
    double way = 0.0;
    double behind = 0.0;
  };
  void settle() noexcept;

  std::vector<Cycle> cycles_;  // a ring of length_
  std::size_t length_ = 0;
  std::size_t next_ = 0;   // the oldest of the ring, and where the next one goes
  std::size_t still_ = 0;  // cycles without motion until now, at most length_
  Sums sums_{};            // of all cycles
  Sums fresh_{};  // of those since the ring began anew; they replace the sums, so that errors do not add up
  double lag_ = 0.0;
  double velocity_ = 0.0;
  double acceleration_ = 0.0;
};

}  // namespace drive
