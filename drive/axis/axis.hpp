#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/axis/actual_values.hpp"
#include "drive/axis/axis_schedule.hpp"
#include "drive/axis/axis_step.hpp"
#include "drive/axis/setpoints.hpp"
#include "drive/base/axis_configuration.hpp"
#include "drive/base/function_modules.hpp"
#include "drive/base/input_edges.hpp"
#include "drive/base/references.hpp"
#include "drive/catalogue/axis_blocks.hpp"
#include "drive/messages/cause_monitor.hpp"
#include "drive/object/drive_object.hpp"
#include "motor/drive_train.hpp"
#include "motor/lockstep/lockstep.hpp"

namespace drive {

/// One axis: function blocks and a motor behind the parameters, faults and alarms of a drive object. It runs its
/// blocks in their order, is told the time that passes and allocates nothing.
class Axis final : public DriveObject {
 public:
  /// An axis at place @p module (0..7) of a unit with CANopen address @p node_id (0 = not known) and DC link
  /// @p supply, behind an infeed that is a drive object if @p has_infeed.
  explicit Axis(const AxisConfiguration& configuration, std::uint8_t module = 0, std::uint8_t node_id = 0,
                const motor::SupplyData& supply = {}, bool has_infeed = false);

  /// Its place among the axes of the unit, 1..8.
  std::size_t axis_number() const noexcept { return context().module + 1U; }

  /// One process-data cycle of @p duration (s), a multiple of motor::kControlPeriod, with the inputs of the blocks
  /// as they are, by itself on a DC link that nothing moves.
  void cycle(double duration) noexcept;
  void cycle(const Setpoints& setpoints, double duration) noexcept {
    command(setpoints);
    cycle(duration);
  }
  /// The inputs of the blocks become what those of an axis that is wired as a new one bring of @p setpoints (p8790
  /// = 1; p1070 and p1503 at 60FFh and 6071h).
  void command(const Setpoints& setpoints) noexcept;
  /// What is in the process data and no parameter leads: named bits of the controlword and 6060h.
  void take_image() noexcept;
  /// Whether that is something else than in the last cycle.
  bool has_new_image() const noexcept;
  /// A cycle in parts, for axes that share a DC link. One of @p duration (s) begins,
  void start_cycle(double duration) noexcept;
  /// the blocks that have their turn in @p phase run with the inputs as they are,
  void run(Phase phase) noexcept;
  /// Whether it has position control, and the phases of kInTheSlices.
  bool positions() const noexcept { return (modules_ & function_module::kPositioning) != 0; }
  /// A slice begins in which the fast inputs of the unit did what @p inputs tells (until the next slice).
  void begin_slice(const InputEdges& inputs) noexcept { edges_ = inputs; }
  /// After the phases of a slice: its speed setpoint and torque limits act in the steps that follow.
  void follow_position() noexcept;
  /// between kBeforeTheSteps and kAfterTheSteps come steps of motor::kControlPeriod with the link at @p dc_voltage
  /// (V), each of which returns the energy drawn from it (J, negative = fed back).
  double step(double dc_voltage) noexcept;
  /// The same of several axes: the next @p count steps (1..kMostPlannedSteps) are planned in @p plan,
  motor::AxisRun plan_steps(StepPlan& plan, std::size_t count) noexcept;
  /// of which @p done have been made.
  void take_steps(const StepPlan& plan, const motor::RunResult& done) noexcept;
  /// Whether each step hangs on what came of the one before.
  bool goes_step_by_step() const noexcept { return measured_; }
  /// The blocks whose inputs are taken before @p phase.
  static std::span<const BlockId> inputs_of(Phase phase) noexcept;
  /// What comes before the steps, and what after them, of an axis whose inputs nothing brings.
  void begin_cycle(double duration) noexcept;
  void end_cycle() noexcept;
  /// Lets @p duration (s) pass in a quiescent axis with the DC link at @p dc_voltage (V): only temperatures
  /// change.
  void rest(double duration, double dc_voltage) noexcept;
  /// 6060h was written as a parameter: p1300 follows if the mode is possible and the pulses are off; otherwise the
  /// mode stays, and only requested_mode() changes.
  void request_mode(std::int8_t code) noexcept;
  /// 6060h: the mode that was last asked for.
  std::int8_t requested_mode() const noexcept { return block<SpeedControl>().requested_mode(); }
  /// The mode of operation whose setpoint leads while the speed does.
  const OperatingModeRow& speed_setpoint() const noexcept { return block<SpeedControl>().speed_setpoint(); }
  /// r0054: the controlword as it came.
  std::uint16_t controlword() const noexcept { return controlword_; }
  /// Where the load is (its revolutions from the place at power-on).
  double load_place() const noexcept;
  /// Whether an encoder is mounted.
  bool has_encoder() const noexcept { return context().axis.machine.encoder.type != motor::EncoderType::None; }
  /// Whether a fault of the encoder is active.
  bool has_encoder_fault() const noexcept;
  /// The values after the last cycle; the statusword follows a fault at once.
  const ActualValues& actual() const noexcept { return actual_; }
  /// Whether further cycles with the setpoints of the last one would change nothing: pulses off, shaft still.
  bool is_quiescent() const noexcept;
  /// Power-off of the sequence control: pulses off, Switch on disabled, no message left; the shaft coasts on.
  void power_off() noexcept override;
  /// The electronics start anew: an incremental encoder begins at 0 and has no reference.
  void lose_position() noexcept;

  /// The master has given the connection up, which is no fault: the axis stops as p8641 says, and ON needs an
  /// edge.
  void lose_connection() noexcept;

  /// Acknowledges what can be acknowledged now; true if no fault is left. During a fault reaction nothing can.
  bool acknowledge() noexcept override;

  /// Replaces constant torque and friction torque of the load by @p torque (N·m; a constant one positive against
  /// positive rotation, friction not negative).
  void set_load_torque(double torque, motor::LoadTorqueType type = motor::LoadTorqueType::Constant) noexcept;

  /// Inertia and friction of the load and the air around the motor are @p settings from now on; behind a coupling
  /// the load has an inertia. What the drive believes of them (p0341, p0613) stays.
  void set_plant(const motor::PlantSettings& settings) noexcept;
  /// As last set, at first as configured.
  const motor::PlantSettings& plant() const noexcept { return plant_; }

  /// The motor encoder has @p defect from now on.
  void fail_encoder(motor::EncoderDefect defect) noexcept;

  /// All function blocks.
  const AxisBlocks& blocks() const noexcept { return blocks_; }
  using DriveObject::block;
  /// A function block of the axis.
  template <class Block>
  const Block& block() const noexcept {
    return std::get<Block>(blocks_);
  }
  template <class Block>
  Block& block() noexcept {
    return std::get<Block>(blocks_);
  }
  /// What values on the bus are relative to.
  References references() const noexcept;
  /// r1538 and r1539: with the pulses off, what parameters and motor allow (N·m).
  motor::TorqueLimits effective_torque_limits() const noexcept;
  /// r1407.7, with the pulses on.
  bool is_at_torque_limit() const noexcept {
    return block<SequenceControl>().pulses_enabled() && train_.signals().torque_limit_reached;
  }
  /// Whether a cause of @p message held at the end of the last cycle.
  bool has_cause(std::uint16_t message) const noexcept { return causes_.holds(message); }
  /// Machine, power unit and control after the last step.
  const motor::Signals& signals() const noexcept { return train_.signals(); }
  /// What machine, power unit and load have done, for balances.
  const motor::DriveTrain& drive_train() const noexcept { return train_; }
  /// Counts the energies on from @p drawn and @p fed_back (J, not negative), those of a former life.
  void continue_energy(double drawn, double fed_back) noexcept {
    train_.continue_energy(drawn, fed_back);
    block<PowerUnit>().continue_energy(drawn, fed_back);
  }
  /// Computes p0340's choice anew from the motor data: 1 everything, 2 the circuit, 4 the controllers, 5 the
  /// limits, 3 both; circuit and inertia only of a motor that is not of the list.
  void compute_parameters(int choice) noexcept;
  /// Ends commissioning (p0010 = 0).
  void leave_commissioning() noexcept;
  /// Whether the axis was switched on by jog (p1055, p1056) and is still so.
  bool jogs() const noexcept { return block<SequenceControl>().jogs(); }
  /// Whether it is switched on and waits for the infeed or the DC link.
  bool waits_for_power() const noexcept {
    return block<SequenceControl>().waits_for_power(block<PowerUnit>().has_link());
  }
  /// Whether the setpoint waits until the holding brake is open.
  bool brake_opens() const noexcept {
    return block<SequenceControl>().pulses_enabled() && block<HoldingBrake>().is_opening();
  }
  /// Whether the sequence control has a holding brake to lead, and it is open.
  bool brake_is_open() const noexcept {
    return has_brake() && block<SequenceControl>().pulses_enabled() && !block<HoldingBrake>().is_opening();
  }
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
  const Identification& identification() const noexcept { return block<Identification>(); }
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
  void on_settings_changed(BlockId changed) noexcept override;
  void on_parameter_written() noexcept override { settled_ = false; }
  void react(const FaultRow& row) noexcept override;
  void on_acknowledged_fault_left() noexcept override;
  void on_messages_changed() noexcept override;

  // What follows from the settings (axis_parameters.cpp).
  void apply_parameters() noexcept;
  void configure_channel() noexcept;
  void check_blocks() noexcept;
  void configure_model() noexcept;
  void configure_control() noexcept;
  void commission() noexcept;
  void follow_control_mode() noexcept;

  // The schedule (axis_schedule.cpp), and the turns of the blocks (axis_turns.cpp).
  struct Turn;
  struct Schedule;
  template <Phase kPhase>
  void run() noexcept;
  void follow_panel() noexcept;
  void stand_by() noexcept {}  ///< of a block that does nothing but is asked by another
  void choose_mode() noexcept;
  void follow_jog_bits() noexcept;
  void control_sequence() noexcept;
  void lead_setpoint() noexcept;
  void begin_sums() noexcept;
  void lead_torque() noexcept;
  void lead_brake() noexcept;
  void lead_identification() noexcept;
  void run_slice() noexcept;
  void read_position() noexcept;
  void lead_position() noexcept;
  void control_position() noexcept;
  void tell_positioning() noexcept;
  bool is_position_control_possible() const noexcept;
  void show_position_messages() noexcept;
  void plan_ramp() noexcept;
  void measure() noexcept;
  void track_measurement() noexcept;
  void watch_speed() noexcept;
  void follow_encoder_word() noexcept;
  void answer_encoder_word() noexcept;
  void observe_motor() noexcept;
  void judge_causes() noexcept;
  void conclude_measurement() noexcept;
  void refresh_status() noexcept;
  void show_free_bits() noexcept;

  // What the sequence control brings about (axis_sequence.cpp).
  bool apply(Event event) noexcept;
  void perform(Action action) noexcept;
  void brake_on(Ramp ramp) noexcept;
  void follow(const Verdict& verdict) noexcept;
  Reaction reaction_to(const FaultRow& row) const noexcept;
  bool stands() const noexcept;
  bool has_brake() const noexcept;
  motor::ControlSettings control_settings(const motor::MachineData& machine) const noexcept;

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

  function_module::Set modules_;
  AxisBlocks blocks_;
  CauseMonitor<AxisBlocks> causes_;

  // Of the cycle that runs.
  motor::DriveCommand command_{};
  bool measured_ = false;  // a measurement leads instead of the setpoint channel
  motor::PlantSettings plant_;
  motor::DriveTrain train_;
  double duration_ = 0.0;  // s

  InputEdges edges_{};                  // of the slice
  bool block_asked_for_probe_ = false;  // in the slice before
  bool adjustment_asked_ = false;       // p2507 = 2 in the slice before

  std::uint16_t controlword_ = 0;  // of the last cycle
  bool settled_ = false;           // the last cycle changed nothing
  ActualValues actual_;
  ActualValues before_;  // those of the cycle before
};

}  // namespace drive
