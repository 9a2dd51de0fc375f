#pragma once

#include "motor/data/inverter_data.hpp"
#include "motor/plant/inverter_losses.hpp"
#include "motor/plant/machine/thermal.hpp"

namespace motor {

/// A power unit as something that loses energy, warms and gets overloaded.
class PowerUnit {
 public:
  /// As cold as the air.
  explicit PowerUnit(const InverterData& data) noexcept
      : data_{data},
        losses_{data},
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
  double losses(double current, bool pulses_on) const noexcept { return pulses_on ? losses_.at(current) : 0.0; }
  /// What it takes for itself while the pulses are on.
  const InverterLosses<double>& inverter() const noexcept { return losses_; }
  InverterLosses<double>& inverter() noexcept { return losses_; }
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
  InverterLosses<double> losses_;
  OverloadModel overload_;
  OverloadModel chip_;  // its rise above the heat sink
  OverloadModel heat_sink_;
};

}  // namespace motor
