#include "cia402/modes/profile/velocity.hpp"

#include <algorithm>
#include <cmath>

#include "cia402/base/word_bits.hpp"

namespace cia402 {
namespace {

/// 6042h between the amounts of 6046h, with its sign; 0 counts as positive.
double bounded(const VelocitySettings& settings) noexcept {
  const double highest = std::max(settings.minimum, settings.maximum);
  const double amount = std::clamp(std::abs(settings.target), settings.minimum, highest);
  return settings.target < 0.0 ? -amount : amount;
}

}  // namespace

Demand Velocity::cycle(std::uint16_t word, const VelocitySettings& settings, const Limits& limits,
                       const Actual& actual) noexcept {
  if (!has(word, VelocityBits::kEnableRamp)) {
    lead_.start(0.0);
    return lead_.cycle(0.0, settings.slopes, limits, actual);
  }
  const double input = has(word, VelocityBits::kReferenceRamp) ? bounded(settings) : 0.0;
  const double goal = has(word, VelocityBits::kUnlockRamp) ? input : lead_.velocity();
  Demand demand = lead_.cycle(goal, settings.slopes, limits, actual);
  demand.is_limited = demand.is_limited || std::abs(settings.target) > settings.maximum;
  return demand;
}

}  // namespace cia402
