#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// V/f control: a voltage whose amplitude follows its frequency, without regard to the rotor. Slip compensation,
/// resonance damping and the I_max controller change the frequency by what the currents show.
class VoltageFrequencyControl {
 public:
  void configure(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Pulses come: from frequency 0.
  void start() noexcept;
  /// Voltage for the period after this one, stator frame (V); fills what the control knows into @p signals.
  SpaceVector step(const Measurement& measured, const DriveCommand& command, Signals& signals) noexcept;

 private:
  void watch(const Measurement& measured, SpaceVector current) noexcept;
  double frequency_for(const DriveCommand& command, double dc_voltage) const noexcept;
  double amplitude_for(double frequency, double acceleration) const noexcept;
  void report(SpaceVector current, Signals& signals) const noexcept;

  VoltageFrequencySettings settings_{};
  double pole_pairs_ = 1.0;
  double resistance_ = 0.0;
  double rated_frequency_ = 1.0;  // electrical rad/s
  double current_limit_ = 1.0;    // A peak
  double slip_rate_ = 0.0;        // slip a torque (rad/s per N·m)
  double damping_gain_ = 0.0;     // rad/s per A
  double reduction_rate_ = 0.0;   // rad/s² per A
  double vdc_max_ = 0.0;          // V, 0 = never
  Frame frame_{};
  double torque_ = 0.0;          // estimate (N·m)
  double active_current_ = 0.0;  // along the voltage, smoothed (A)
  double swing_ = 0.0;           // what it deviates from that (A)
  double excess_ = 0.0;          // of the current over its limit (A)
  double reduction_ = 0.0;  // of the frequency's amount by the I_max controller (rad/s), below 0 when it feeds
};

}  // namespace motor
