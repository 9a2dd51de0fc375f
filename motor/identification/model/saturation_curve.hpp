#pragma once

#include <array>
#include <span>

namespace motor {

/// Rotor flux of an induction machine and the current that lets it stand.
struct FluxPoint {
  double flux = 0.0;     ///< V·s
  double current = 0.0;  ///< A peak
};

/// Saturation characteristic of an induction machine as a measurement has found it; all 0: not found.
struct SaturationCurve {
  /// p0362 to p0369: flux and magnetising current, as shares of the rated ones.
  std::array<double, 4> flux{};
  std::array<double, 4> magnetising_current{};
  /// The same as InductionCircuit has it: L_M without saturation (H), and the flux that halves it (V·s; 0 = none).
  double fitted_magnetising_inductance = 0.0;
  double fitted_saturation_flux = 0.0;
  /// What the shares of flux refer to (V·s): the flux that was believed the rated one.
  double rated_flux = 0.0;

  bool is_known() const noexcept { return fitted_magnetising_inductance > 0.0; }
};

/// Fits i/psi = (1 + (psi/psi_sat)^6)/L_M to @p points and puts it into @p curve; false where they do not tell it.
/// A psi_sat far beyond @p rated_flux (V·s) is none: nothing of it was seen.
bool fit_saturation(std::span<const FluxPoint> points, double rated_flux, SaturationCurve& curve) noexcept;

}  // namespace motor
