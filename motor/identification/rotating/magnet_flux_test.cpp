#include "motor/identification/rotating/magnet_flux_test.hpp"

#include <cmath>
#include <numbers>

#include "motor/identification/rotating/test_speeds.hpp"

namespace motor {
namespace {

constexpr double kHold = 0.05;          // s
constexpr double kLeastCurrent = 0.07;  // of the rated one, above which the valves' voltage has its sign
constexpr double kLowest = 0.9;         // of the least speed, where the shaft is turned round
constexpr double kPlausible = 2.0;      // times what is believed, or the inverse of it
constexpr int kParts = 4;               // strong currents count if they are one of so many parts of all

}  // namespace

SpeedPlan MagnetFluxTest::start(const RotatingTask& task, const RotatingFindings& found) noexcept {
  *this = {};
  machine_ = task.machine;
  with_encoder_ = task.settings.mode == ControlMode::Encoder;
  const TestSpeeds speeds = test_speeds(task, found.dc_voltage);
  if (!speeds.useful()) return {};
  least_frequency_ = kLowest * machine_.pole_pairs * speeds.least;
  least_current_ = kLeastCurrent * std::numbers::sqrt2 * machine_.rated_current;
  const double direction = first_direction(task);
  SpeedPlan plan;
  for (int ramps = 0; ramps < 3; ++ramps) {
    plan.add({.speed = direction * speeds.least, .hold = kHold});
    plan.add({.speed = direction * speeds.high, .hold = kHold});
  }
  plan.add({.speed = direction * speeds.least, .hold = kHold});
  return plan;
}

void MagnetFluxTest::take(const FieldBlock& block, const SpeedPlace& place) noexcept {
  const double frequency = with_encoder_ ? machine_.pole_pairs * block.speed() : block.frequency;
  if (place.stop == 0 || std::abs(frequency) < least_frequency_) return;
  const SynchronousData& data = machine_.synchronous;
  const double induced = block.voltage.im - block.resistance * block.current.im -
                         frequency * data.d_inductance * block.current.re -
                         data.q_inductance * block.current_slope.im;
  const bool strong = norm(block.current) > least_current_ * least_current_;
  if (strong) strong_.add({frequency, block.threshold.im}, induced);
  all_.add({frequency, block.threshold.im}, induced);
}

bool MagnetFluxTest::finish(RotatingFindings& found) noexcept {
  // Slow ramps have no strong currents, and weak ones do not tell the threshold voltage.
  const bool weak = kParts * strong_.count() < all_.count();
  const auto solution = (weak ? all_ : strong_).solve();
  if (!solution) return false;
  const double flux = (*solution)[0];
  const double ratio = flux / machine_.synchronous.magnet_flux;
  if (!(ratio < kPlausible && ratio > 1.0 / kPlausible)) return false;
  found.result.magnet_flux = flux;
  found.result.threshold_voltage = weak ? 0.0 : (*solution)[1];
  return true;
}

}  // namespace motor
