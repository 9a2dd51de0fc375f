#include "motor/identification/rotating/saturation_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/identification/model/field_model.hpp"
#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/rotating/test_speeds.hpp"

namespace motor {
namespace {

/// Shares of the rated flux that are looked at; the first four become p0362 to p0365, and p0366 to p0369.
constexpr std::array kShares{0.6, 0.85, 1.15, 1.25, 1.0};
/// The same without encoder: with little flux the speed is not estimated calmly.
constexpr std::array kObservedShares{0.8, 0.9, 1.15, 1.25, 1.0};
constexpr double kHighestShare = 1.25;
constexpr double kSettling = 5.0;   // rotor time constants until the flux stands
constexpr double kAveraging = 0.4;  // s
constexpr double kPlausible = 2.0;  // of flux and what is believed, or its inverse

}  // namespace

SpeedPlan SaturationTest::start(const RotatingTask& task, const RotatingFindings& found) noexcept {
  *this = {};
  circuit_ = induction_circuit(task.machine);
  rated_flux_ = rated_flux(task.machine);
  rated_current_ = std::numbers::sqrt2 * task.machine.induction.magnetising_current;
  const TestSpeeds speeds = test_speeds(task, found.dc_voltage, kHighestShare);
  if (!speeds.useful()) return {};
  const double settling = kSettling * circuit_.magnetising_inductance / circuit_.rotor_resistance;
  shares_ = task.settings.mode == ControlMode::Encoder ? kShares : kObservedShares;
  SpeedPlan plan;
  for (const double share : shares_)
    plan.add({.speed = first_direction(task) * speeds.high, .hold = settling + kAveraging, .flux_share = share});
  return plan;
}

void SaturationTest::take(const FieldBlock& block, const SpeedPlace& place) noexcept {
  if (place.held < 0.0 || place.remaining > kAveraging) return;
  Level& level = levels_[place.stop];
  const SpaceVector behind = block.voltage - block.resistance * block.current;
  level.voltage = level.voltage + behind;
  level.current = level.current + block.current;
  level.threshold = level.threshold + block.threshold;
  level.frequency += block.frequency;
  level.power += 1.5 * dot(behind, block.current);
  level.per_volt += 1.5 * dot(block.threshold, block.current);
  ++level.blocks;
}

/// The torque is the same at every flux; what seems to change it with the current is lost in the inverter.
bool SaturationTest::find_threshold(RotatingFindings& found) const noexcept {
  LeastSquares<2> torque;
  for (const Level& level : levels_) {
    if (level.blocks == 0) return false;
    torque.add({1.0, level.per_volt / level.frequency}, level.power / level.frequency);
  }
  const auto solution = torque.solve();
  if (!solution) return false;
  found.result.threshold_voltage = std::max(0.0, (*solution)[1]);
  return true;
}

FluxPoint SaturationTest::point_of(const Level& level, double threshold) const noexcept {
  const double share = 1.0 / level.blocks;
  const SpaceVector current = share * level.current;
  const SpaceVector induced = share * (level.voltage - threshold * level.threshold);
  const double frequency = share * level.frequency;
  const SpaceVector rotor = inducing_flux(induced, frequency) - circuit_.leakage * current;
  const double flux = length(rotor);
  return {flux, flux > 0.0 ? dot(current, rotor) / flux : 0.0};
}

bool SaturationTest::finish(RotatingFindings& found) noexcept {
  if (!find_threshold(found)) return false;
  std::array<FluxPoint, kLevels> points{};
  for (std::size_t i = 0; i < kLevels; ++i) {
    points[i] = point_of(levels_[i], found.result.threshold_voltage);
    const double ratio = points[i].flux / (shares_[i] * rated_flux_);
    if (!(ratio < kPlausible && ratio > 1.0 / kPlausible && points[i].current > 0.0)) return false;
  }
  for (std::size_t i = 0; i < found.result.flux.size(); ++i) {
    found.result.flux[i] = points[i].flux / rated_flux_;
    found.result.magnetising_current[i] = points[i].current / rated_current_;
  }
  return fit_saturation(points, rated_flux_, found.result);
}

}  // namespace motor
