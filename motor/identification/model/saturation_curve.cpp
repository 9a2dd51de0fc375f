#include "motor/identification/model/saturation_curve.hpp"

#include <cmath>

#include "motor/identification/model/least_squares.hpp"

namespace motor {
namespace {

constexpr double kFarSaturation = 3.0;  // of the rated flux

}  // namespace

bool fit_saturation(std::span<const FluxPoint> points, double rated_flux, SaturationCurve& curve) noexcept {
  LeastSquares<2> reluctance;
  for (const FluxPoint& point : points) {
    const double square = point.flux * point.flux;
    reluctance.add({1.0, square * square * square}, point.current / point.flux);
  }
  const auto solution = reluctance.solve();
  if (!solution || !((*solution)[0] > 0.0)) return false;
  const auto [linear, bend] = *solution;
  curve.fitted_magnetising_inductance = 1.0 / linear;
  const double saturation = bend > 0.0 ? std::pow(linear / bend, 1.0 / 6.0) : 0.0;
  curve.fitted_saturation_flux = saturation < kFarSaturation * rated_flux ? saturation : 0.0;
  return true;
}

}  // namespace motor
