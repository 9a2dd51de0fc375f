#pragma once

#include "motor/control_settings.hpp"
#include "motor/current_loop.hpp"
#include "motor/encoder.hpp"
#include "motor/inverter_data.hpp"
#include "motor/load.hpp"
#include "motor/machine_data.hpp"
#include "motor/mechanics.hpp"
#include "motor/plant.hpp"
#include "motor/signals.hpp"
#include "motor/speed_controller.hpp"
#include "motor/tuning.hpp"

namespace motor {

/// One axis from the DC link to the load: inverter, machine, shaft, encoder and the control loops around them.
class DriveTrain {
 public:
  /// At rest and cold; the control knows @p machine exactly and is set by computed_settings().
  DriveTrain(const MachineData& machine, const Load& load, const InverterData& inverter = {}) noexcept;

  /// Replaces all settings of the control; what the speed controller has integrated stays.
  void tune(const ControlSettings& settings) noexcept;
  /// Changes the gains of the speed controller with encoder.
  void tune(const SpeedControllerGains& gains) noexcept;
  /// What the control believes of the machine (p03xx) from now on; the machine itself stays what it is.
  void set_machine(const MachineData& machine) noexcept;
  /// Settings in force.
  const ControlSettings& settings() const noexcept { return settings_; }

  /// Advances by kControlPeriod with @p command held and the DC link at @p dc_voltage (V, not negative). Returns
  /// the energy drawn from the link in the step, losses of the inverter included, negative when fed back (J).
  double step(double dc_voltage, const Command& command) noexcept;
  /// Lets @p duration (s) pass with the pulses off and the shaft at rest: only temperatures change.
  void rest(double duration) noexcept;

  /// Replaces the constant load torque (N·m, positive against positive rotation).
  void set_load_torque(double torque) noexcept { mechanics_.set_load_torque(torque); }
  /// Closes or opens the holding brake at once; opening and closing times are the owner's.
  void set_brake(bool closed) noexcept { brake_closed_ = closed; }
  /// The encoder has @p defect from now on.
  void inject(EncoderDefect defect) noexcept { encoder_.inject(defect); }
  /// The state after the last step.
  const Signals& signals() const noexcept { return signals_; }
  /// Where the energy of the last step went, behind the terminals (J).
  const PlantEnergies& energies() const noexcept { return energies_; }
  /// What the inverter has lost in the last step (J).
  double inverter_losses() const noexcept { return 0.0; }
  /// What machine and load have stored (J).
  StoredEnergy stored() const noexcept;
  /// Whether nothing but temperatures changes any more while the pulses are off.
  bool rests() const noexcept;

 private:
  double torque_setpoint(const Command& command) noexcept;

  MachineData machine_;
  ControlSettings settings_;
  SpeedController speed_controller_;
  CurrentLoop current_loop_;
  Mechanics mechanics_;
  Encoder encoder_;
  Signals signals_{};
  PlantEnergies energies_{};
  bool brake_closed_ = false;
};

}  // namespace motor
