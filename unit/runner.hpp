#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drive/access/parameter_access.hpp"
#include "drive/images/retained_image.hpp"
#include "unit/configuration.hpp"
#include "unit/cycle_clock.hpp"
#include "unit/face.hpp"
#include "unit/follow_ups.hpp"
#include "unit/message_watch.hpp"
#include "unit/parameter_storage.hpp"
#include "unit/presets.hpp"
#include "unit/time.hpp"
#include "unit/unit_parameters.hpp"

namespace unit {

/// Runs a drive unit between its faces: tells it the time, runs its cycles while something moves and lets it rest
/// otherwise, and brings its parameters and what it keeps back to life. Nothing in it reads a clock, blocks or,
/// after the last face is attached, allocates. Axes are counted from 1; where a function takes one, 0 is the
/// control unit.
class Runner final : private drive::AccessListener {
 public:
  using ImageError = drive::image_format::Error;

  /// @p keeper outlives this.
  Runner(const Configuration& configuration, ParameterKeeper& keeper);
  ~Runner() override = default;
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Before start(): @p face, which outlives this, is connected to the unit from now on. It gets the presets.
  void attach(Face& face);
  /// Not from within a cycle: @p other, which outlives that, stands in the place of @p face from now on and hands
  /// on to it what it likes.
  void replace(const Face& face, Face& other) noexcept;

  /// Before start(): @p clock, which outlives this, is asked if the unit takes its time from the host.
  void ask(HostClock& clock) noexcept { host_clock_ = &clock; }

  /// Before start(): the saved parameters, and what a power cut did not take. An image that does not fit changes
  /// nothing.
  [[nodiscard]] tl::expected<void, ImageError> load_parameters(std::span<const std::byte> image) noexcept;
  [[nodiscard]] tl::expected<void, ImageError> load_retained(std::span<const std::byte> image) noexcept;
  /// What survives a power cut at @p now; valid until the next call.
  std::span<const std::byte> retained(TimePoint now) noexcept;
  /// Power-on: the first cycle is run.
  void start(TimePoint now) noexcept;
  bool is_on() const noexcept { return started_.has_value(); }

  /// The time is @p now; nothing is stamped with it yet.
  void set_now(TimePoint now) noexcept { now_ = now; }
  /// The time is @p now, which faults and alarms are stamped with from now on.
  void tell_time(TimePoint now) noexcept;
  void tell_time() noexcept { tell_time(now_); }
  /// The time that was told last.
  TimePoint now() const noexcept { return now_; }
  /// When run_due() is wanted next; kNever while the unit rests.
  TimePoint next_deadline() const noexcept { return clock_.next(); }
  /// Runs the cycles that have ended by now(), and shows what they have led to.
  void run_due() noexcept {
    if (clock_.next() <= now_) run_cycles();
  }
  /// run_due() in parts, for units that make the steps of their cycles together (drive::JointSteps): up to the
  /// steps of the one cycle that is due. The unit, if it shares them: finish_due() is to follow when they are
  /// made, and nothing before it. nullptr: all is done.
  [[nodiscard]] drive::DriveUnit* begin_due() noexcept;
  void finish_due() noexcept;
  /// Runs the first of the cycles that were missed, if any was: it takes what has come so far. What it leads to is
  /// shown after the last of them.
  bool make_up_cycle() noexcept;
  bool is_resting() const noexcept { return clock_.is_resting(); }
  /// The rest, if there is one, ends with what came at @p arrival, now() at the latest.
  void end_rest(TimePoint arrival) noexcept;
  /// From now on @p observer, which outlives that, looks at every cycle, and the unit does not rest; nullptr:
  /// nobody does.
  void observe(CycleObserver* observer) noexcept;
  /// See drive::DriveUnit::let_in().
  void let_in(drive::Interlude* interlude) noexcept { unit_.let_in(interlude); }
  /// Something has come for @p axes: the next cycle has to run them.
  void wake(AxisMask axes = kAllAxes) noexcept {
    if ((idle_ & axes) == 0) return;
    idle_ &= ~axes;
    wake_clock();
  }

  /// Faults or alarms may have come or gone: the faces show them at once; what the axes make of it is for the
  /// cycle that follows. The second one does that when the answer to a request is out.
  void show_messages() noexcept;
  void show_messages_later() noexcept { follow_ups_.add(FollowUp::ShowMessages); }
  /// Parameter @p number of drive object @p object was written; what follows from that beyond the drive object
  /// comes with follow_up().
  void on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept;
  bool has_follow_ups() const noexcept { return !follow_ups_.is_empty(); }
  /// The answer to a request is out: carries out what it has led to, here and at the faces.
  void follow_up() noexcept;

  /// Before the face is attached: what belongs to the groups of parameters that it knows.
  ParameterGroups& groups() noexcept { return storage_.groups(); }
  /// Saves @p group, or has it restored when the answer is out: see ParameterStorage.
  [[nodiscard]] std::optional<drive::Refusal> store(ParameterGroup group) noexcept {
    return storage_.store(group);
  }
  [[nodiscard]] std::optional<drive::Refusal> restore(ParameterGroup group) noexcept {
    return storage_.restore(group);
  }
  /// A save runs: no parameter may be written.
  bool is_saving() const noexcept { return storage_.is_saving(); }
  /// What ParameterKeeper::on_store() has begun is over; @p kept: with success.
  void on_stored(bool kept, TimePoint now) noexcept;
  bool has_saved_parameters() const noexcept { return storage_.has_saved(); }
  /// What was saved last, or loaded; valid until the next save.
  drive::SavedValues saved_parameters() const noexcept { return storage_.saved(); }
  /// How somebody beside the faces reads and writes parameters, under the conditions that hold for a master, at
  /// the time that was told last; what the writes lead to comes with follow_up(). A save that one begins goes on,
  /// see is_saving().
  drive::ParameterAccess& parameter_access() noexcept { return access_; }
  /// Somebody beside the faces writes index @p index of parameter @p number of drive object @p object at @p now
  /// by parameter_access(), and what it leads to is carried out at once.
  [[nodiscard]] tl::expected<void, drive::ParameterError> write_parameter(std::uint8_t object,
                                                                          std::uint16_t number, std::size_t index,
                                                                          double value, TimePoint now) noexcept;
  /// p8848 comes into force.
  void take_over_period() noexcept;
  /// A face has left the state in which its master leads the unit: p0972 = 3 waits for that.
  void on_operation_left() noexcept { storage_.on_operational_left(); }
  /// Power-off of the drives.
  void power_off() noexcept { unit_.power_off(); }
  /// The same of the unit as a whole, which a bus that starts anew alone does not do.
  void restart_unit() noexcept {
    unit_.power_off();
    unit_.lose_positions();
  }
  /// The unit is switched off and on again: by the face whose bus starts anew with that, if there is one.
  void power_cycle() noexcept;
  /// The parameters of @p group are the saved ones again, as after power-on.
  void reload(ParameterGroup group) noexcept;

  /// Raises fault or alarm @p number on @p axis (0..axes) with @p value; a message that propagates appears on
  /// every drive object.
  tl::expected<void, drive::FaultError> raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                              TimePoint now) noexcept;
  /// Acknowledges the faults of @p axis (0..axes) and takes back the alarms that raise() brought; true if no fault
  /// is left.
  bool acknowledge(std::size_t axis, TimePoint now) noexcept;
  /// The same for every drive object.
  void acknowledge() noexcept;
  /// An operator panel that will not be silent for longer than @p timeout (s) takes the control of @p axis
  /// (1..axes), or why it cannot.
  [[nodiscard]] std::optional<drive::PanelRefusal> take_control(std::size_t axis, double timeout,
                                                                TimePoint now) noexcept;
  /// It gives ON or OFF1 and a speed setpoint (rad/s); false if none leads the axis.
  [[nodiscard]] bool command_by_panel(std::size_t axis, bool on, double speed, TimePoint now) noexcept;
  /// It gives OFF1, and the control back at standstill; false if none has it.
  [[nodiscard]] bool give_control_back(std::size_t axis, TimePoint now) noexcept;
  /// Sets the load torque of @p axis (1..axes; N·m; a constant one positive against positive rotation, friction
  /// not negative).
  void set_load_torque(std::size_t axis, double torque, TimePoint now, motor::LoadTorqueType type) noexcept;
  /// The encoder of @p axis (1..axes) has @p defect from now on.
  void fail_encoder(std::size_t axis, motor::EncoderDefect defect, TimePoint now) noexcept;
  /// Sets the line voltage of the supply (V rms between lines, not negative; 0 = mains failure).
  void set_line_voltage(double voltage, TimePoint now) noexcept;
  /// Inertia and friction of the load of @p axis (1..axes) and the air around its motor are @p settings from @p
  /// now on: see drive::Axis::set_plant().
  void set_plant(std::size_t axis, const motor::PlantSettings& settings, TimePoint now) noexcept;
  /// Puts @p voltage (V) to the analogue input of the control unit (r0752).
  void set_analog_input(double voltage, TimePoint now) noexcept;
  /// Puts terminal @p number of the control unit (drive::Terminals::exists) to 24 V or 0 V; the cycle that @p now
  /// lies in takes it.
  void set_input(unsigned number, bool high, TimePoint now) noexcept;

  const drive::DriveUnit& unit() const noexcept { return unit_; }
  drive::DriveUnit& unit() noexcept { return unit_; }
  /// Those who answer for parameters of the faces are named here.
  UnitParameters& parameters() noexcept { return parameters_; }
  const CycleClock& clock() const noexcept { return clock_; }
  /// Counts how often the faults and alarms were different from before.
  std::uint32_t message_changes() const noexcept { return messages_.changes(); }
  /// Whether an axis turns or has its pulses enabled.
  bool is_moving() const noexcept;
  /// The axes whose load drives the shaft at its bursting speed.
  AxisMask held_back_axes() const noexcept;
  /// Cycles left out because the program was kept from running for too long.
  std::uint64_t skipped_cycles() const noexcept { return skipped_cycles_; }

 private:
  // drive::AccessListener
  bool is_locked() const noexcept override { return is_saving(); }
  void on_access() noexcept override { tell_time(now_); }
  void on_written(std::uint8_t object, std::uint16_t number) noexcept override {
    on_parameter_written(object, number);
  }

  void run_cycles() noexcept;
  void run_cycle(bool all, TimePoint end) noexcept;
  void begin_cycle(bool all, TimePoint end) noexcept;
  void end_cycles() noexcept;
  void wake_clock() noexcept;
  void see_what_rests() noexcept;
  void publish() noexcept;
  void tell_of_messages() noexcept;
  void ask_host() noexcept;
  std::uint8_t object_of(std::size_t axis) const noexcept;
  // runner_parameters.cpp
  void lay_presets(ParameterGroup group) noexcept;
  void take_over(const Replacement& replacement) noexcept;
  void adopt(const Replacement& replacement) noexcept;
  void resume(const Replacement& replacement) noexcept;
  void restore_object(std::uint8_t object) noexcept;
  void show_messages(std::uint8_t) noexcept { show_messages(); }
  void restart_if_due(std::uint8_t) noexcept;
  void restore_group(std::uint8_t which) noexcept;
  void reset(std::uint8_t) noexcept { power_cycle(); }

  ParameterKeeper& keeper_;
  FollowUps<FollowUp> follow_ups_;
  UnitParameters parameters_;
  drive::DriveUnit unit_;
  drive::ParameterAccess access_{unit_, *this};
  ParameterStorage storage_;
  Presets presets_;
  std::vector<std::byte> retained_;
  std::vector<Face*> faces_;
  CycleClock clock_;
  MessageWatch messages_;
  CycleObserver* observer_ = nullptr;
  HostClock* host_clock_ = nullptr;
  AxisMask idle_;                     ///< nothing moves there, and nothing has come since the last cycle
  std::optional<TimePoint> started_;  ///< when the unit was switched on
  TimePoint now_{};                   ///< as last told
  TimePoint rested_until_{};          ///< temperatures have been brought up to here while resting
  std::uint64_t skipped_cycles_ = 0;
};

}  // namespace unit
