#pragma once

#include <limits>

#include "motor/data/supply_data.hpp"

namespace motor {

/// Voltage of an unloaded rectifier: mean of the six-pulse bridge over the line voltage between lines (rms).
inline constexpr double kRectifierRatio = 1.35;

/// What went through a DC link since its start (J, never negative): from_line + missing = to_line + infeed_losses
/// + chopper + axes + what is stored more than at the start.
struct SupplyEnergies {
  double from_line = 0.0;      ///< drawn from the line
  double to_line = 0.0;        ///< fed back to the line
  double infeed_losses = 0.0;  ///< heat of supply and infeed
  double chopper = 0.0;        ///< heat of the braking resistor
  double axes = 0.0;           ///< drawn by the axes less what they fed back; this one may be negative
  double missing = 0.0;        ///< asked for by the axes while the link was empty
};

/// The DC link of a unit as an energy store: fed by the infeed, drawn from by the axes, held down by the braking
/// chopper. The infeed carries the power (u0² - u²)/2R, which is that of a source u0 behind a resistance R for the
/// drops that occur, and makes the energy follow a linear equation: every step is exact, whatever its length.
class DcLink {
 public:
  /// A link that is charged to what its infeed gives without load. @p data is valid (motor/validation.hpp).
  explicit DcLink(const SupplyData& data) noexcept;

  /// Advances by @p dt (s, positive) while the axes draw @p energy_drawn (J, negative = fed back) evenly. The
  /// chopper switches at the instant the voltage reaches its threshold. An empty link stays at 0 V.
  void step(double dt, double energy_drawn) noexcept;
  /// The line fails (0) or changes its voltage (V rms between lines, not negative); what is stored stays.
  void set_line_voltage(double voltage) noexcept;
  /// Charges or discharges the link to @p voltage (V, not negative), for a start from another state.
  void start(double voltage) noexcept;

  /// r0026 (V), not negative.
  double voltage() const noexcept;
  /// Whether the braking resistor carries current now.
  bool chopper_on() const noexcept { return chopper_on_; }
  /// Power of the braking resistor now (W).
  double chopper_power() const noexcept { return chopper_on_ ? energy_ * chopper_rate_ : 0.0; }
  /// In the capacitors (J).
  double stored() const noexcept { return energy_; }
  const SupplyEnergies& energies() const noexcept { return energies_; }
  const SupplyData& data() const noexcept { return data_; }
  /// Whether a step without axes would change nothing.
  bool settled() const noexcept;

 private:
  /// Part of a step in which no switch and no limit changes: the infeed gives infeed_power + infeed_rate·(level -
  /// E).
  struct Stretch {
    double infeed_power = 0.0;  // W
    double infeed_rate = 0.0;   // 1/s
    double lower = 0.0;         // J, the part ends where the energy leaves lower..upper
    double upper = std::numeric_limits<double>::infinity();
  };
  /// What came of it.
  struct Course {
    double time;         // s
    double below_level;  // J, mean of level - E, where that matters
  };
  double level_at(double line_voltage) const noexcept;
  double infeed_power() const noexcept;
  Stretch stretch(bool rising) const noexcept;
  double advance(const Stretch& stretch, double axes_power, double time) noexcept;
  Course decay(const Stretch& stretch, double axes_power, double time) noexcept;
  Course climb(const Stretch& stretch, double axes_power, double time) noexcept;
  double covered_within(double exponent) noexcept;
  void hold(double axes_power, double time) noexcept;
  void switch_chopper() noexcept;
  void book_infeed(double energy, double time, double mean_stored) noexcept;
  double energy_at(double voltage) const noexcept { return 0.5 * data_.capacitance * voltage * voltage; }

  SupplyData data_;
  double infeed_rate_;    // 1/s, of a conducting infeed
  double chopper_rate_;   // 1/s, share of the energy that the resistor takes
  double chopper_start_;  // J, infinite without a chopper
  double chopper_end_;    // J
  double highest_power_;  // W, that the infeed can draw
  double lowest_power_;   // W, not positive, what it can feed back
  bool connected_;        // to the line
  double level_;          // J, where the infeed gives nothing
  double energy_;         // J
  double next_look_;      // s, until the comparator of the chopper looks
  bool chopper_on_ = false;
  double exponent_ = 0.0;  // of the last exponential, and what it covered
  double covered_ = 0.0;
  SupplyEnergies energies_;
};

}  // namespace motor
