#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/control/field/current_controller.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "motor/control/measurement.hpp"
#include "motor/data/control_period.hpp"

namespace motor {

/// Leads the current to setpoints that stand still in the stator frame. It sees the mean of two readings, so
/// voltage pulses that change their sign in every period do not disturb it.
class CurrentLead {
 public:
  /// Begins without current; the gains are those for @p machine as it is believed to be.
  void start(const MachineData& machine) noexcept {
    *this = {};
    const bool synchronous = machine.type == MachineType::Synchronous;
    const SynchronousData& axes = machine.synchronous;
    const double inductance =
        synchronous ? std::min(axes.d_inductance, axes.q_inductance) : induction_circuit(machine).leakage;
    const double gain = kBandwidth * inductance;
    controller_.configure({gain, gain, kIntegralTime, kIntegralTime}, kControlPeriod);
  }
  /// Voltage (V) that leads the current to @p setpoint (A); the DC link must leave @p reserve (V) besides.
  SpaceVector step(SpaceVector setpoint, const Measurement& measured, double reserve = 0.0) noexcept {
    const SpaceVector mean = 0.5 * (measured.current + before_);
    before_ = measured.current;
    setpoint_ = setpoint_ + kSmoothing * (setpoint - setpoint_);
    const double limit = measured.dc_voltage * std::numbers::inv_sqrt3 - reserve;
    const SpaceVector voltage = controller_.step(setpoint_, mean, {}, std::max(0.0, limit));
    limited_steps_ = controller_.limited() ? limited_steps_ + 1 : 0;
    return voltage;
  }
  /// What the current is led to, smoothed (A), stator frame.
  SpaceVector setpoint() const noexcept { return setpoint_; }
  /// For how many steps the DC link has not given what was wanted.
  int limited_steps() const noexcept { return limited_steps_; }

 private:
  static constexpr double kBandwidth = 2.0 * std::numbers::pi * 250.0;  // rad/s: calm with data that are wrong
  /// Soon enough for what the valves lose, which jumps when a current changes its sign (s).
  static constexpr double kIntegralTime = 4.0 / kBandwidth;
  static constexpr double kSmoothing = kControlPeriod * kBandwidth;  // of the setpoint, in a step

  CurrentController<double> controller_{};
  SpaceVector before_{};
  SpaceVector setpoint_{};
  int limited_steps_ = 0;
};

}  // namespace motor
