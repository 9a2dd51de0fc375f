#pragma once

#include <array>

#include "motor/data/inverter_data.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// What an inverter takes for itself: of the energy, and of the voltage that it is asked for.
template <class Number>
class InverterLosses {
 public:
  InverterLosses() = default;
  explicit InverterLosses(const InverterData& data) noexcept
      : idle_{data.idle_losses},
        constant_{data.idle_losses},
        per_ampere_{data.losses_per_ampere},
        per_square_{data.losses_per_square},
        drop_a_volt_{data.dead_time * data.pulse_frequency},
        forward_voltage_{data.forward_voltage},
        knee_{0.01 * data.rated_current},
        ideal_{!(data.dead_time > 0.0 || data.forward_voltage > 0.0)} {}

  /// What it turns into heat (W) at @p current (A rms) with the pulses on.
  Number at(const Number& current) const noexcept {
    return constant_ + current * (per_ampere_ + per_square_ * current);
  }
  /// Whether the voltage at the terminals is what was asked for.
  Condition<Number> is_ideal() const noexcept { return ideal_.holds(); }
  /// What dead time and forward voltages take from the voltage at @p current (stator frame, A) and @p dc_voltage
  /// (V): against each phase current the same, but for a small one (stator frame, V).
  SpaceVectorOf<Number> distortion(const SpaceVectorOf<Number>& current, const Number& dc_voltage) const noexcept {
    const Number drop = drop_a_volt_ * dc_voltage + forward_voltage_;
    std::array<Number, 3> phases = phase_values(current);
    for (Number& phase : phases) phase = drop * bounded<Number>(phase / knee_, -1.0, 1.0);
    return vector_of(phases);
  }
  /// From now on distortion() takes @p power (W) besides the other losses, where it is not ideal.
  void set_drop_losses(const Number& power) noexcept {
    constant_ = select<Number>(ideal_.holds(), constant_, idle_ + power);
  }

 private:
  Number idle_ = 0.0;         // W
  Number constant_ = 0.0;     // W, whatever the current
  Number per_ampere_ = 0.0;   // W/A
  Number per_square_ = 0.0;   // W/A²
  Number drop_a_volt_ = 0.0;  // share of the time that is dead
  Number forward_voltage_ = 0.0;
  Number knee_ = 1.0;  // A
  Flag<Number> ideal_{};
};

}  // namespace motor
