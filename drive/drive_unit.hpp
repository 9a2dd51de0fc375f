#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "drive/axis/axis.hpp"
#include "drive/control_unit/control_unit.hpp"
#include "drive/infeed/infeed.hpp"
#include "drive/interlude.hpp"
#include "drive/positioning/switches/travel_switches.hpp"
#include "drive/step_observer.hpp"
#include "motor/plant/dc_link.hpp"

namespace drive {

/// The layer that owns the bus and the files: it acts on agreed parameters and on commands.
class ParameterHost {
 public:
  virtual ~ParameterHost() = default;
  /// Takes over @p value of parameter @p row of @p object, or carries the command out; the reason if it cannot.
  virtual std::optional<Refusal> on_parameter(const DriveObject& object, const ParameterRow& row,
                                              std::size_t index, double value) noexcept = 0;
  /// What an agreed parameter or a command reads as, in the parameter's own unit; nothing: the last value that was
  /// written, loaded or brought in.
  virtual std::optional<double> value_of(const DriveObject& object, const ParameterRow& row,
                                         std::size_t index) const noexcept {
    (void)object, (void)row, (void)index;
    return std::nullopt;
  }
  /// Why nobody may write index @p index of @p row of @p object in whatever state, if somebody holds it.
  virtual std::optional<Refusal> lock_on(const DriveObject& object, const ParameterRow& row,
                                         std::size_t index) const noexcept {
    (void)object, (void)row, (void)index;
    return std::nullopt;
  }
};

class Wiring;

/// What the unit is made of.
struct UnitConfiguration {
  std::vector<AxisConfiguration> axes{AxisConfiguration{}};  ///< 1..8
  std::uint8_t node_id = 0;                                  ///< CANopen address in force, 1..127; 0 = not known
  bool address_switch_off = false;  ///< p8620 can be written: the address switch stands at 0
  motor::SupplyData supply{};       ///< of the DC link that feeds all axes
  bool infeed = false;              ///< the infeed is a drive object, which switches the link to the line
};

/// The drive unit: control unit and axes with their parameters and messages, reached by drive object number
/// (control unit 1, infeed 2 if it is one, then the axes). Nothing is allocated after construction.
class DriveUnit final : private Surroundings {
 public:
  /// @p host outlives the unit; without one every agreed value is taken.
  explicit DriveUnit(const UnitConfiguration& configuration, ParameterHost* host = nullptr);
  ~DriveUnit() override;
  DriveUnit(const DriveUnit&) = delete;
  DriveUnit& operator=(const DriveUnit&) = delete;

  /// Drive object @p number, or nullptr.
  DriveObject* object(std::uint8_t number) noexcept;
  const DriveObject* object(std::uint8_t number) const noexcept;
  /// Calls @p visit with every drive object in ascending order of their numbers.
  template <class Visit>
  void for_each_object(const Visit& visit) {
    visit(static_cast<DriveObject&>(control_unit_));
    if (infeed_) visit(static_cast<DriveObject&>(*infeed_));
    for (Axis& axis : axes_) visit(static_cast<DriveObject&>(axis));
  }
  template <class Visit>
  void for_each_object(const Visit& visit) const {
    visit(static_cast<const DriveObject&>(control_unit_));
    if (infeed_) visit(static_cast<const DriveObject&>(*infeed_));
    for (const Axis& axis : axes_) visit(static_cast<const DriveObject&>(axis));
  }
  const ControlUnit& control_unit() const noexcept { return control_unit_; }
  ControlUnit& control_unit() noexcept { return control_unit_; }
  /// The infeed, if it is a drive object.
  const Infeed* infeed() const noexcept { return infeed_ ? &*infeed_ : nullptr; }
  Infeed* infeed() noexcept { return infeed_ ? &*infeed_ : nullptr; }
  /// The drive object number of the first axis.
  std::uint8_t first_axis() const noexcept { return first_axis_number(infeed_.has_value()); }
  std::span<Axis> axes() noexcept { return axes_; }
  std::span<const Axis> axes() const noexcept { return axes_; }

  /// One process-data cycle of @p duration (s), a multiple of motor::kControlPeriod, with what the bus has brought
  /// into the process data of the axes. They run it step by step side by side on their DC link. An axis that is
  /// not @p awake rests while it is quiescent and its inputs stay as they are.
  void cycle(std::span<const bool> awake, double duration) noexcept;
  /// The same in parts, for units that make their steps together (JointSteps): up to the steps,
  void begin_cycle(std::span<const bool> awake, double duration) noexcept;
  /// these,
  void make_steps() noexcept;
  /// and what comes of them.
  void finish_cycle() noexcept;
  /// Whether nothing happens between the steps of the cycle that has begun, so that they can be made with those of
  /// other units.
  bool shares_steps() const noexcept;
  /// How many there are, and how many axes make them.
  long steps() const noexcept { return running_.steps; }
  std::size_t running_axes() const noexcept { return running_.count; }
  /// Makes the steps of @p units together: of all the same number, and at most motor::kMostAxesInLockstep axes
  /// that make them. All of them share them.
  static void make_steps(std::span<DriveUnit* const> units) noexcept;
  /// cycle() with @p setpoints in place of the interconnections, for axes that are wired as new ones; an axis
  /// without any must be quiescent and rests.
  void cycle(std::span<const std::optional<Setpoints>> setpoints, double duration) noexcept;
  /// Puts what is to be sent into the process data again, as it is now.
  void send_process_data() noexcept;
  /// An operator panel that will not be silent for longer than @p timeout (s) takes the control of @p axis
  /// (0..axes-1), or why it cannot.
  [[nodiscard]] std::optional<PanelRefusal> take_control(std::size_t axis, double timeout) noexcept;
  /// Why it could not now.
  [[nodiscard]] std::optional<PanelRefusal> panel_refusal(std::size_t axis) noexcept;
  /// What a cycle does to process data, without moving the axes.
  void exchange_process_data() noexcept;
  /// Sources of interconnections are found anew before the next cycle: what they are relative to has changed.
  void on_wiring_changed() noexcept override;
  /// From now on @p observer, which outlives that, looks at every step; nullptr: nobody does.
  void observe(StepObserver* observer) noexcept { observer_ = observer; }
  /// From now on @p interlude, which outlives that, comes between some steps of every cycle; nullptr: nobody does.
  void let_in(Interlude* interlude) noexcept { interlude_ = interlude; }
  /// Lets @p duration (s) pass while every axis is quiescent.
  void rest(double duration) noexcept;
  /// The DC link that the axes share.
  const motor::DcLink& dc_link() const noexcept { return dc_link_; }
  /// Of the supply, as last set, at first as configured (V rms between lines).
  double line_voltage() const noexcept { return line_voltage_; }
  /// The line fails (0) or changes its voltage (V rms between lines, not negative).
  void set_line_voltage(double voltage) noexcept;

  /// The value of a parameter as it is transferred.
  [[nodiscard]] tl::expected<ParameterValue, ParameterError> read(std::uint8_t object, std::uint16_t number,
                                                                  std::size_t index) const noexcept;
  /// The same of @p placed of @p object, found by DriveObject::parameter() with @p index.
  static ParameterValue read(const DriveObject& object, const PlacedRow& placed, std::size_t index) noexcept;
  /// Writes a parameter; the type of @p value has to be that of the parameter.
  [[nodiscard]] tl::expected<void, ParameterError> write(std::uint8_t object, std::uint16_t number,
                                                         std::size_t index, const ParameterValue& value) noexcept;
  /// The same of @p placed of @p object, found by DriveObject::parameter() with @p index.
  [[nodiscard]] tl::expected<void, ParameterError> write(DriveObject& object, const PlacedRow& placed,
                                                         std::size_t index, double value) noexcept;

  /// Tells every drive object the time since the unit was switched on (ms).
  void set_time(Uptime now) noexcept;
  /// The unit has a former life of @p runtime (ms), which the times of messages go on from.
  void continue_after(Uptime runtime) noexcept;
  /// Time switched on over all lives (ms), as of set_time().
  Uptime runtime() const noexcept { return former_runtime_ + uptime_; }
  /// A message appears on drive object @p object, and one that propagates globally on all that can have it.
  [[nodiscard]] tl::expected<void, FaultError> raise(std::uint8_t object, std::uint16_t number,
                                                     std::uint32_t value = 0, Cause cause = Cause::Gone) noexcept;
  /// The cause of a message is gone, where it came from and where it spread to.
  void withdraw(std::uint8_t object, std::uint16_t number) noexcept;
  /// Acknowledges the faults of every drive object (p2102, p8611[0]); true if no fault is left.
  bool acknowledge() noexcept;
  /// Acknowledges the faults of drive object @p object and takes back its alarms without a cause of their own, as
  /// raise() brings them; true if no fault is left.
  bool acknowledge(std::uint8_t object) noexcept;
  /// Power-off of the sequence controls: pulses off, no message left; the shafts coast on.
  void power_off() noexcept;
  /// The electronics start anew with that (POWER ON, p0976), not only the communication: incremental encoders know
  /// no place any more.
  void lose_positions() noexcept {
    for (Axis& axis : axes_) axis.lose_position();
  }
  /// Factory reset: every drive object in the state of a new one, commissioning ended.
  void restore_parameters() noexcept;
  /// The saved parameters that @p which chooses are as in a new unit again.
  void restore_parameters(RowFilter which) noexcept;
  /// Ends commissioning everywhere (p0009 = 0, p0010 = 0).
  void leave_commissioning() noexcept;
  /// The axes get the function modules that p0108 asks for, as they do when p0009 becomes 0; called when p0108 was
  /// loaded.
  void follow_function_modules() noexcept;

 private:
  /// Which axes run in a cycle, and these in their order; the others rest.
  struct Running {
    std::array<bool, kMostAxes> runs{};
    std::array<Axis*, kMostAxes> axes{};
    std::size_t count = 0;
    double duration = 0.0;  // s
    long steps = 0;         // in that

    std::span<Axis* const> all() const noexcept { return {axes.data(), count}; }
  };

  /// The switches beside the way of the load of an axis.
  struct AxisSwitches {
    const Axis* axis = nullptr;
    TravelSwitches switches;
  };

  std::uint32_t& message_counter() noexcept override { return message_counter_; }
  const TimeLine& time() const noexcept override { return control_unit_.clock().line(); }
  std::optional<ObjectKind> kind_of(std::uint8_t number) const noexcept override;
  std::optional<Refusal> agree(const DriveObject& object, const ParameterRow& row, std::size_t index,
                               double value) noexcept override;
  tl::expected<void, ParameterError> clear_alarms(DriveObject& object, const PlacedRow& counter,
                                                  double count) noexcept;
  std::optional<double> agreed_value(const DriveObject& object, const ParameterRow& row,
                                     std::size_t index) const noexcept override;
  std::optional<Refusal> lock_on(const DriveObject& object, const ParameterRow& row,
                                 std::size_t index) const noexcept override;
  void inhibit_axes(bool inhibited) noexcept;
  void follow_unit_inputs() noexcept;
  void run_infeed(double duration) noexcept;
  void connect_line() noexcept;
  void group_inputs();
  void take_inputs(const Axis& axis, Phase phase) noexcept;
  bool has_new_inputs(const Axis& axis, Phase phase) const noexcept;
  bool has_nothing_to_do(const Axis& axis) const noexcept;
  void run_for(double duration) noexcept;
  void collect_running() noexcept;
  void wake_for(Phase phase) noexcept;
  void run_phase(Phase phase) noexcept;
  void rest_others() noexcept;
  bool is_sliced() const noexcept;
  bool goes_step_by_step() const noexcept;
  void fit_switches();
  void move_switches() noexcept;
  void run_slice() noexcept;
  void run_steps(long steps) noexcept;
  static long run_steps(std::span<DriveUnit* const> units, long steps) noexcept;
  void send_converted() noexcept;
  void end_cycle() noexcept;

  ParameterHost* host_;
  std::uint32_t message_counter_ = 0;
  Uptime former_runtime_ = 0;
  Uptime uptime_ = 0;
  motor::DcLink dc_link_;
  double lowest_dc_voltage_ = 0.0;  // V, of the last cycle
  double line_voltage_;             // V rms between lines
  ControlUnit control_unit_;
  std::optional<Infeed> infeed_;
  std::vector<Axis> axes_;
  std::vector<AxisSwitches> switches_;  // of the axes that have some
  std::unique_ptr<Wiring> wiring_;
  StepObserver* observer_ = nullptr;
  Interlude* interlude_ = nullptr;
  long steps_in_slice_ = 0;
  Running running_;  // of the present cycle
};

}  // namespace drive
