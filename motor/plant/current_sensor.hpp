#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "motor/math/space_vector.hpp"

namespace motor {

/// The current sensors of two phases with their converters: whole steps of 12 bits, and noise of half a step. The
/// third phase is what the two leave. The noise is the same in every run.
class CurrentSensor {
 public:
  /// @p range (A peak, positive) is the highest current of a phase that can be told from a higher one.
  explicit CurrentSensor(double range) noexcept : step_{range / kSteps} {}

  /// What is read at the current @p true_current (stator frame, A).
  SpaceVector read(SpaceVector true_current) noexcept {
    const std::array<double, 3> phases = phase_values(true_current);
    const double u = convert(phases[0]);
    const double v = convert(phases[1]);
    return vector_of<double>({u, v, -u - v});
  }
  /// Smallest difference that is seen (A).
  double resolution() const noexcept { return step_; }

 private:
  static constexpr double kSteps = 2048.0;  // of 12 bits, each way
  static constexpr double kNoise = 0.5;     // standard deviation in steps
  static constexpr int kParts = 4;          // uniform numbers that make one of the noise

  double convert(double phase) noexcept {
    const double steps = std::floor(phase / step_ + kNoise * noise() + 0.5);
    return step_ * std::fmin(kSteps - 1.0, std::fmax(-kSteps, steps));
  }
  /// Nearly normal, with standard deviation 1: a sum of uniform numbers.
  double noise() noexcept {
    double sum = 0.0;
    for (int i = 0; i < kParts; ++i) {
      state_ ^= state_ << 13;
      state_ ^= state_ >> 7;
      state_ ^= state_ << 17;
      sum += static_cast<double>(state_ >> 11) * 0x1p-53 - 0.5;
    }
    return sum * std::sqrt(12.0 / kParts);
  }

  double step_;
  std::uint64_t state_ = 0x9E3779B97F4A7C15U;
};

}  // namespace motor
