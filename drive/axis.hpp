#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/axis_configuration.hpp"
#include "drive/axis_inputs.hpp"
#include "drive/causes.hpp"
#include "drive/drive_object.hpp"
#include "drive/function_modules.hpp"
#include "drive/identification.hpp"
#include "drive/operating_mode.hpp"
#include "drive/parameters.hpp"
#include "drive/setpoint_channel.hpp"
#include "drive/speed_monitors.hpp"
#include "drive/state_machine.hpp"
#include "motor/drive_train.hpp"

namespace drive {

/// What the master sees of the axis after a cycle; measured speed and torques are means over the cycle.
struct ActualValues {
  std::uint16_t statusword = 0;
  double speed = 0.0;                 ///< r0063, from the encoder (rad/s)
  double speed_demand = 0.0;          ///< r1170, behind the ramp (rad/s)
  double torque_demand = 0.0;         ///< r0079 (N·m)
  double torque = 0.0;                ///< r0080 (N·m)
  std::int64_t encoder_counts = 0;    ///< increments since power-on
  std::int32_t encoder_position = 0;  ///< r0482, wraps at 32 bits
  State state = State::NotReadyToSwitchOn;
  std::int8_t mode = mode_code::kProfileVelocity;  ///< r8762, 6061h
  bool pulses_enabled = false;

  friend bool operator==(const ActualValues&, const ActualValues&) = default;
};

/// What parameters show of an axis beyond its actual values.
struct AxisInsight {
  AxisInputs inputs{};                  ///< of the last cycle, ramp enables as velocity mode has them
  bool switching_on_inhibited = false;  ///< by p0010 or p0009
  bool torque_control = false;          ///< r1407.2
  double fixed_setpoint = 0.0;          ///< r1024 (rad/s)
  double setpoint_sum = 0.0;            ///< r1078 (rad/s)
  double directed_setpoint = 0.0;       ///< r1114 (rad/s)
  double ramp_input = 0.0;              ///< r1119 (rad/s)
  double ramp_output = 0.0;             ///< r1150 (rad/s)
  double ramp_acceleration = 0.0;       ///< r1149, mean of the last cycle (rad/s²)
  motor::TorqueLimits torque_limits{};  ///< effective, r1538 and r1539 (N·m)
  double dc_voltage = 0.0;              ///< r0070, at the end of the last step (V)
  bool torque_limit_reached = false;    ///< with the pulses on
  bool target_reached = false;
  bool overspeed = false;
  bool blocked = false;
  double energy_drawn = 0.0;     ///< at the motor terminals (J)
  double energy_fed_back = 0.0;  ///< the same, not negative (J)
};

/// One axis: sequence control, setpoint channel and motor behind the parameters, faults and alarms of a drive
/// object. It is told the time that passes and allocates nothing.
class Axis final : public DriveObject {
 public:
  /// An axis at place @p module (0..7) of a unit with CANopen address @p node_id (0 = not known) and DC link
  /// @p supply, behind an infeed that is a drive object if @p has_infeed.
  explicit Axis(const AxisConfiguration& configuration, std::uint8_t module = 0, std::uint8_t node_id = 0,
                const motor::SupplyData& supply = {}, bool has_infeed = false);

  /// Its place among the axes of the unit, 1..8.
  std::size_t axis_number() const noexcept { return context().module + 1U; }

  /// One process-data cycle of @p duration (s), a multiple of motor::kControlPeriod, by itself on a DC link that
  /// nothing moves.
  void cycle(const AxisInputs& inputs, double duration) noexcept;
  void cycle(const Setpoints& setpoints, double duration) noexcept { cycle(inputs_of(setpoints), duration); }
  /// The same in parts, for axes that share a DC link: the sequence control at the beginning of a cycle of
  /// @p duration (s),
  void begin_cycle(const AxisInputs& inputs, double duration) noexcept;
  /// or with what the interconnections have brought into the inputs and the bus into the process data,
  void begin_cycle(double duration) noexcept;
  /// one step of motor::kControlPeriod with the link at @p dc_voltage (V), which returns the energy drawn from it
  /// (J, negative = fed back),
  double step(double dc_voltage) noexcept;
  /// when all axes have moved, the actual values,
  void measure() noexcept;
  /// and monitoring, messages and statusword at the end.
  void end_cycle() noexcept;
  /// Lets @p duration (s) pass in a quiescent axis with the DC link at @p dc_voltage (V): only temperatures
  /// change.
  void rest(double duration, double dc_voltage) noexcept;
  /// What the interconnections brought in the last cycle.
  const AxisInputs& inputs() const noexcept { return wired_; }
  /// Whether the bus has brought something else than in the last cycle that goes through no input.
  bool has_new_command() const noexcept;
  /// 6060h was written as a parameter: p1300 follows if the mode is possible and the pulses are off; otherwise the
  /// mode stays, and only requested_mode() changes.
  void request_mode(std::int8_t code) noexcept;
  /// 6060h: the mode that was last asked for.
  std::int8_t requested_mode() const noexcept { return mode_.requested(); }
  /// Whether 6042h leads (mode 2).
  bool velocity_mode() const noexcept { return mode_.velocity_mode(parameters_.control_mode); }
  /// Whether an encoder is mounted.
  bool has_encoder() const noexcept { return context().axis.machine.encoder.type != motor::EncoderType::None; }
  /// The values after the last cycle; the statusword follows a fault at once.
  const ActualValues& actual() const noexcept { return actual_; }
  /// Whether further cycles with the setpoints of the last one would change nothing: pulses off, shaft still.
  bool is_quiescent() const noexcept;
  /// Power-off of the sequence control: pulses off, Switch on disabled, no message left; the shaft coasts on.
  void power_off() noexcept override;

  /// The master has given the connection up, which is no fault: the axis stops as p8641 says, and ON needs an
  /// edge.
  void lose_connection() noexcept;

  /// Acknowledges what can be acknowledged now; true if no fault is left. During a fault reaction nothing can.
  bool acknowledge() noexcept override;

  /// Replaces constant torque and friction torque of the load by @p torque (N·m; a constant one positive against
  /// positive rotation, friction not negative).
  void set_load_torque(double torque, motor::LoadTorqueType type = motor::LoadTorqueType::Constant) noexcept;

  /// The motor encoder has @p defect from now on.
  void fail_encoder(motor::EncoderDefect defect) noexcept;

  /// All parameters in SI units.
  const AxisParameters& parameters() const noexcept { return parameters_; }
  /// What parameters show that is no actual value.
  AxisInsight insight() const noexcept;
  /// Machine, power unit and control after the last step.
  const motor::Signals& signals() const noexcept { return train_.signals(); }
  /// What machine, power unit and load have done, for balances.
  const motor::DriveTrain& drive_train() const noexcept { return train_; }
  /// Counts the energies on from @p drawn and @p fed_back (J, not negative), those of a former life.
  void continue_energy(double drawn, double fed_back) noexcept {
    energy_drawn_ = drawn;
    energy_fed_back_ = fed_back;
  }
  /// Computes p0340's choice anew from the motor data: 1 everything, 2 the circuit, 4 the controllers, 5 the
  /// limits, 3 both; circuit and inertia only of a motor that is not of the list.
  void compute_parameters(int choice) noexcept;
  /// Ends commissioning (p0010 = 0).
  void leave_commissioning() noexcept;
  /// Whether the axis was switched on by jog (p1055, p1056) and is still so.
  bool jogs() const noexcept { return jogging_; }
  /// Whether it is switched on and waits for the infeed or the DC link.
  bool waits_for_power() const noexcept { return state_ == State::SwitchedOn && !has_power(); }
  /// Whether the infeed operates (p0864) and the DC link has its voltage.
  bool has_power() const noexcept;
  /// Whether bit 8 of the controlword asks for a halt that p8791 provides.
  bool halt_requested() const noexcept;
  /// Whether the setpoint waits until the holding brake is open.
  bool brake_opens() const noexcept { return pulses_enabled_in(state_) && brake_opening_ > 0.0; }
  /// Whether the sequence control has a holding brake to lead, and it is open.
  bool brake_is_open() const noexcept { return has_brake() && pulses_enabled_in(state_) && brake_opening_ <= 0.0; }
  /// What the active faults do to the motor, as p8641 and p2101 have it.
  Reactions active_reactions() const noexcept;
  /// Function modules in force (r0108).
  function_module::Set function_modules() const noexcept { return modules_; }
  /// Asks for @p wanted (p0108); those that the axis always has stay.
  void set_function_modules(function_module::Set wanted) noexcept;
  /// Whether setpoints go through the extended setpoint channel; without it they begin at p1155 and p1160.
  bool has_setpoint_channel() const noexcept { return (modules_ & function_module::kSetpointChannel) != 0; }
  bool provides(const ParameterRow& row) const noexcept override;
  /// Whether the unit, by p0009, keeps the axis from being switched on.
  void inhibit(bool inhibited) noexcept;

  /// What is selected, runs and was found of the motor identification.
  const Identification& identification() const noexcept { return identification_; }
  /// p1900, p1910 and p1960 are written with one of their values.
  void select_identification(std::int32_t value) noexcept;
  void select_standstill_measurement(std::int32_t value) noexcept;
  void select_rotating_measurement(std::int32_t value) noexcept;

 private:
  void* own_block(BlockId id) noexcept override;
  const void* own_block(BlockId id) const noexcept override;
  void before_setting(const ParameterRow& row) noexcept override;
  void after_setting(const ParameterRow& row) noexcept override;
  WriteState write_state() const noexcept override;
  void on_settings_changed(BlockId block) noexcept override;
  void on_parameter_written() noexcept override { settled_ = false; }
  void react(const FaultRow& row) noexcept override;
  void on_acknowledged_fault_left() noexcept override;
  void on_messages_changed() noexcept override;

  void apply_parameters() noexcept;
  void follow_control_mode() noexcept;
  std::uint16_t command_word() const noexcept;
  void sequence(double duration) noexcept;
  void follow_inputs() noexcept;
  void follow_jog() noexcept;
  void wait_for_power(double duration) noexcept;
  void check_standstill(double duration) noexcept;
  bool stands() const noexcept;
  Reaction reaction_to(const FaultRow& row) const noexcept;
  bool apply(Event event) noexcept;
  void perform(Action action) noexcept;
  void brake_on(Ramp ramp) noexcept;
  void begin(double duration) noexcept;
  void take_inputs() noexcept;
  void lead_setpoint() noexcept;
  void lead_torque() noexcept;
  double halted_torque() noexcept;
  void configure_channel() noexcept;
  void configure_control() noexcept;
  FixedSetpoints fixed_setpoints() const noexcept;
  motor::ControlSettings control_settings(const motor::MachineData& machine) const noexcept;
  motor::TorqueLimits effective_torque_limits() const noexcept;
  bool has_brake() const noexcept;
  void lead_brake() noexcept;
  double move(double dc_voltage) noexcept;
  double measured_step(double dc_voltage) noexcept;
  void watch(double dc_voltage) noexcept;
  void monitor() noexcept;
  Observed observed() const noexcept;
  CauseLimits cause_limits() const noexcept;
  void follow(const Verdict& verdict) noexcept;
  void refresh_status() noexcept;

  // Motor identification (axis_identification.cpp).
  void lead_measurement() noexcept;
  void begin_measurement() noexcept;
  motor::StandstillTask standstill_task(const motor::MachineData& machine) const noexcept;
  motor::RotatingTask rotating_task(const motor::MachineData& machine) const noexcept;
  bool can_begin_measurement() const noexcept;
  void step_measurement() noexcept;
  void end_measurement() noexcept;
  void stop_measurement() noexcept;
  void cancel_identification() noexcept;
  void give_back_control() noexcept;
  void show_selection() noexcept;
  void take_over(IdentificationPart part) noexcept;
  void take_over(const motor::StandstillResult& found) noexcept;
  void take_over(const motor::RotatingResult& found) noexcept;
  void take_over_saturation(const motor::SaturationCurve& found) noexcept;
  void assign_rotor_circuit(const motor::MachineData& machine) noexcept;
  void set_dynamics(double factor) noexcept;
  void compute_as_new(std::span<const std::uint16_t> numbers, const ObjectContext& described) noexcept;
  void compute_inertia() noexcept;
  void compute_circuit() noexcept;
  void assign_rounded(std::uint16_t number, double value) noexcept;

  AxisParameters parameters_;
  function_module::Set modules_;
  motor::DriveTrain train_;
  // Follows from the parameters.
  SetpointChannel channel_;
  FixedSetpoints fixed_setpoints_{};
  std::uint16_t implausible_parameter_ = 0;
  double counts_to_speed_;  // rad an increment

  State state_ = State::NotReadyToSwitchOn;
  AxisInputs wired_{};         // of this cycle
  AxisInputs wired_before_{};  // of the last one
  AxisInputs inputs_{};        // those of this cycle with the ramp enables of velocity mode
  OperatingMode mode_;
  bool jogging_ = false;                 // switched on by p1055 or p1056
  bool on_withheld_ = false;             // after OFF1 by lose_connection(), until ON goes
  unsigned input_messages_ = 0;          // that an input has brought, a bit each
  double power_missing_ = 0.0;           // s, since ON
  motor::TorqueLimits torque_limits_{};  // p1522, p1523
  double torque_setpoint_ = 0.0;         // of torque control, N·m
  bool torque_led_ = false;              // in the last cycle
  StandstillMonitor standstill_;
  TargetMonitor target_monitor_;
  CauseMonitor causes_;
  bool inhibited_ = false;  // by the unit
  bool target_reached_ = false;
  bool is_blocked_ = false;
  bool overspeed_ = false;
  double ramp_acceleration_ = 0.0;  // rad/s²
  double energy_drawn_ = 0.0;       // J
  double energy_fed_back_ = 0.0;    // J
  double brake_opening_ = 0.0;      // s, until the holding brake is open
  Identification identification_;
  bool settled_ = false;  // the last cycle changed nothing
  ActualValues actual_;
  ActualValues before_;    // those of the cycle before
  AxisFeedback feedback_;  // what acts on messages and statusword at the end of the cycle

  /// What the steps of a cycle leave behind.
  struct Cycle {
    double duration = 0.0;  // s
    int steps = 0;
    bool measured = false;  // a measurement leads instead of the setpoint channel
    motor::Command command{};
    double torque_demand = 0.0;  // sums of the steps (N·m)
    double torque = 0.0;
    double speed = 0.0;         // rad/s
    double ramp_before = 0.0;   // rad/s
    double peak_current = 0.0;  // A
    unsigned tripped_phases = 0;
    double highest_dc_voltage = 0.0;  // V
    double lowest_dc_voltage = 0.0;   // V
  };
  Cycle cycle_;
  double dc_voltage_ = 0.0;  // V
};

}  // namespace drive
