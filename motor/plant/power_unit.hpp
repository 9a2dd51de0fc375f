#pragma once

#include <algorithm>
#include <array>

#include "motor/data/inverter_data.hpp"
#include "motor/math/space_vector.hpp"
#include "motor/plant/machine/thermal.hpp"

namespace motor {

/// A power unit as something that loses energy, warms and gets overloaded.
class PowerUnit {
 public:
  /// As cold as the air.
  explicit PowerUnit(const InverterData& data) noexcept
      : data_{data},
        constant_losses_{data.idle_losses},
        overload_{{.reference_current = data.rated_current, .time_constant = data.overload_time_constant}},
        chip_{{.reference_current = data.rated_current,
               .time_constant = data.chip_time_constant,
               .rise = data.chip_rise,
               .ambient = 0.0}},
        heat_sink_{{.reference_current = data.rated_current,
                    .time_constant = data.heat_sink_time_constant,
                    .rise = data.heat_sink_rise,
                    .ambient = data.ambient}} {}

  /// What the unit turns into heat (W) at @p current (A rms); nothing with the pulses off.
  double losses(double current, bool pulses_on) const noexcept {
    if (!pulses_on) return 0.0;
    return constant_losses_ + current * (data_.losses_per_ampere + data_.losses_per_square * current);
  }
  /// Whether the voltage at the terminals is what was asked for.
  bool is_ideal() const noexcept { return !(data_.dead_time > 0.0 || data_.forward_voltage > 0.0); }
  /// What dead time and forward voltages take from the voltage at @p current (stator frame, A) and @p dc_voltage
  /// (V): against each phase current the same, but for a small one (stator frame, V).
  SpaceVector distortion(SpaceVector current, double dc_voltage) const noexcept {
    const double knee = 0.01 * data_.rated_current;
    const double drop = data_.dead_time * data_.pulse_frequency * dc_voltage + data_.forward_voltage;
    std::array<double, 3> phases = phase_values(current);
    for (double& phase : phases) phase = drop * std::clamp(phase / knee, -1.0, 1.0);
    return vector_of(phases);
  }
  /// From now on distortion() takes @p power (W) besides the other losses.
  void set_drop_losses(double power) noexcept { constant_losses_ = data_.idle_losses + power; }
  /// Goes on for @p dt (s) with the mean of the squared output current (A² rms); exact for any length.
  void step(double dt, double mean_square_current) noexcept {
    overload_.step(dt, mean_square_current);
    chip_.step(dt, mean_square_current);
    heat_sink_.step(dt, mean_square_current);
  }
  /// r0036 (1 = 100 %, above which F30005 trips).
  double overload() const noexcept { return overload_.utilisation(); }
  /// r0037[2], of the hottest junction (°C).
  double chip_temperature() const noexcept { return heat_sink_.temperature() + chip_.temperature(); }
  /// r0037[0] (°C).
  double heat_sink_temperature() const noexcept { return heat_sink_.temperature(); }
  const InverterData& data() const noexcept { return data_; }

 private:
  InverterData data_;
  double constant_losses_;  // W, whatever the current
  OverloadModel overload_;
  OverloadModel chip_;  // its rise above the heat sink
  OverloadModel heat_sink_;
};

}  // namespace motor
