#pragma once

#include <cstdint>
#include <optional>

#include "motor/control/control_settings.hpp"
#include "motor/control/excitation.hpp"
#include "motor/control/field/field_control.hpp"
#include "motor/control/field/induction_field.hpp"
#include "motor/control/field/synchronous_field.hpp"
#include "motor/control/field/tuning.hpp"
#include "motor/control/field/voltage_frequency.hpp"
#include "motor/control/observation.hpp"
#include "motor/control/signals.hpp"
#include "motor/data/inverter_data.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/lane_kind.hpp"
#include "motor/plant/current_sensor.hpp"
#include "motor/plant/encoder.hpp"
#include "motor/plant/machine/thermal.hpp"
#include "motor/plant/plant.hpp"
#include "motor/plant/power_unit.hpp"
#include "motor/train_state.hpp"

namespace motor {

/// One axis from the DC link to the load: inverter, machine, shaft, encoder and the control loops around them.
class DriveTrain {
 public:
  /// At rest and cold; the control knows @p machine exactly and is set by computed_settings().
  DriveTrain(const MachineData& machine, const Load& load, const InverterData& inverter = {}) noexcept
      : DriveTrain{machine, machine, load, inverter} {}
  /// The same with a control that believes in @p data_sheet while @p machine turns; both are of one type, with one
  /// encoder.
  DriveTrain(const MachineData& data_sheet, const MachineData& machine, const Load& load,
             const InverterData& inverter) noexcept;

  /// Replaces all settings of the control; what the controllers have integrated stays unless the mode changes.
  void tune(const ControlSettings& settings) noexcept;
  /// What the control believes of the machine (p03xx) from now on; the machine itself stays what it is.
  void set_machine(const MachineData& machine) noexcept;
  /// @p excitation, which outlives that, leads from the next step on, and nullptr makes it the control again. With
  /// the pulses on, what leads then starts anew.
  void lead_by(Excitation* excitation) noexcept;
  /// From now on control and excitations see currents through their sensors, and the rotor as the encoder counts
  /// it, or both as they are.
  void use_sensors(bool used) noexcept;
  /// Share of the rated flux that an induction machine gets from now on (p1570), positive.
  void set_flux_share(double share) noexcept { induction_.set_flux_share(share); }
  /// Settings in force.
  const ControlSettings& settings() const noexcept { return settings_; }

  /// Advances by kControlPeriod with @p command held and the DC link at @p dc_voltage (V, not negative). Returns
  /// the energy drawn from the link in the step, losses of the inverter included, negative when fed back (J).
  double step(double dc_voltage, const DriveCommand& command) noexcept;
  /// Lets @p duration (s) pass with the pulses off and the shaft at rest: only temperatures change.
  void rest(double duration) noexcept;

  /// Replaces constant torque and friction torque of the load by @p torque (N·m; a constant one positive against
  /// positive rotation, friction not negative).
  void set_load_torque(double torque, LoadTorqueType type = LoadTorqueType::Constant) noexcept {
    plant_.set_load_torque(torque, type);
  }
  /// Inertia and friction of the load become those of @p load, on @p machine as it really is; see
  /// Plant::set_body().
  void set_body(const MachineData& machine, const Load& load) noexcept { plant_.set_body(machine, load); }
  /// The air around the motor has @p temperature (°C) from now on.
  void set_ambient(double temperature) noexcept { thermal_.set_ambient(temperature); }
  /// Commands the holding brake; it acts after its opening or closing time.
  void set_brake(bool closed) noexcept { plant_.set_brake(closed); }
  /// From now on the encoder has @p defect instead of the one before.
  void inject(EncoderDefect defect) noexcept;
  /// Forgets what the encoder has found wrong; what still is comes back.
  void acknowledge_encoder() noexcept { encoder_.acknowledge(); }

  /// The state after the last step.
  const Signals& signals() const noexcept { return signals_; }
  /// What a drive can know after the last step, while it uses its sensors; current and DC link voltage are those
  /// of the last reading.
  Observation observation() const noexcept;
  const Encoder& encoder() const noexcept { return encoder_; }
  const PlantState& plant_state() const noexcept { return plant_.state(); }
  /// What hangs on the shaft (see Plant::load_torque()).
  double load_torque() const noexcept { return plant_.load_torque(); }
  /// Whether the shaft is at its bursting speed and would turn faster if it could.
  bool is_held_back() const noexcept { return plant_.is_held_back(); }
  /// Where the energy of the last step went, behind the terminals (J).
  const PlantEnergies& energies() const noexcept { return plant_.energies(); }
  /// What the inverter has lost in the last step (J).
  double inverter_losses() const noexcept { return state_.inverter_losses; }
  /// Of the steps since begin_sums().
  const StepSums<double>& sums() const noexcept { return sums_; }
  /// Begins them anew; the energies go on.
  void begin_sums() noexcept { sums_ = {.drawn = sums_.drawn, .fed_back = sums_.fed_back}; }
  /// Counts the energies on from @p drawn and @p fed_back (J, not negative).
  void continue_energy(double drawn, double fed_back) noexcept {
    sums_.drawn = drawn;
    sums_.fed_back = fed_back;
  }
  /// What machine and load have stored (J).
  StoredEnergy stored() const noexcept { return plant_.stored(); }
  /// Of which kind it is among those that can be advanced side by side while @p command leads; none while
  /// something happens to it that does not happen in most periods.
  std::optional<LaneKind> lane_kind(const DriveCommand& command) const noexcept;
  /// Whether nothing but temperatures changes any more while the pulses are off.
  bool rests() const noexcept;

 private:
  /// Which control leads.
  enum class Lead : std::uint8_t { Synchronous, Induction, VoltageFrequency, Excitation };

  using Heat = TrainState<double>::Heat;
  template <class Number>
  friend class LaneTrain;

  void configure() noexcept;
  SpaceVector control(const Measurement& measured, const DriveCommand& command) noexcept;
  Measurement measure(double dc_voltage) noexcept;
  Measurement sense(double dc_voltage) noexcept;
  void follow_sensors() noexcept;
  void start() noexcept;
  void stop() noexcept;
  SpaceVector rotor_direction() const noexcept;
  void move(double dc_voltage, bool pulses) noexcept;
  void observe() noexcept;
  void drive_with_drops(double dc_voltage) noexcept;
  void warm() noexcept;
  void warm_for(double duration, const Heat& heat) noexcept;

  MachineData believed_;
  ControlSettings settings_;
  Plant plant_;
  Encoder encoder_;
  PowerUnit power_unit_;
  MotorThermal thermal_;
  OverloadModel motor_model_;  // what the drive believes of its temperature
  FieldControl<SynchronousField<double>> synchronous_;
  FieldControl<InductionField<double>> induction_;
  VoltageFrequencyControl<double> voltage_frequency_;
  Signals signals_{};
  CurrentSensor current_sensor_;
  Excitation* excitation_ = nullptr;
  TrainState<double> state_{};
  StepSums<double> sums_{};
  SpaceVector seen_current_{};  // last reading of the sensors (A)
  double dc_voltage_ = 0.0;     // at that time
  Lead lead_ = Lead::Synchronous;
  bool pulses_ = false;  // the controllers run
  bool driven_ = false;  // the inverter gives what has been calculated
  bool encoder_true_ = true;
  bool sensors_used_ = false;
  bool sees_truth_ = true;  // neither sensors nor a wrong encoder stand between
  bool ideal_inverter_;
  bool with_encoder_ = true;
};

}  // namespace motor
