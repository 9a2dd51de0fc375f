#pragma once

#include "motor/data/machine_data.hpp"

namespace motor {

/// Temperature coefficient of the resistance of copper (1/K).
inline constexpr double kCopperCoefficient = 0.00393;

/// Resistance at @p temperature (°C) as a multiple of that at kDataTemperature.
constexpr double resistance_factor(double temperature) noexcept {
  return 1.0 + kCopperCoefficient * (temperature - kDataTemperature);
}

}  // namespace motor
