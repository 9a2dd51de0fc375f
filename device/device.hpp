#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "device/bus/unit_time.hpp"
#include "device/canopen_face.hpp"
#include "device/objects/configuration.hpp"
#include "unit/runner.hpp"

namespace device {

using unit::CycleClock;
using unit::HostClock;
using unit::Keeping;
using unit::ParameterKeeper;

/// What the unit tells the program around it. Called from within the functions of Device.
class Listener : public ParameterKeeper, public BusListener, public HostClock {};

/// The drive unit as a CANopen node: a runner with the face to its bus, and whatever further faces are attached.
/// It is fed frames and time and hands its frames to a sink; nothing in it reads a clock, blocks or, after
/// construction, allocates. Axes are counted from 1; where a function takes one, 0 is the control unit.
class Device final {
 public:
  /// Process-data cycle of a new unit.
  static constexpr canopen::Duration kCycle = CycleClock::kFactory;

  /// How the face to the bus is made, which works on @p runner.
  using MakeFace = std::function<std::unique_ptr<BusFace>(::unit::Runner& runner)>;

  /// The unit of @p configuration with the face that @p make gives it.
  Device(const ::unit::Configuration& configuration, const MakeFace& make, Listener& listener)
      : runner_{configuration, listener}, face_{make(runner_)} {
    runner_.ask(listener);
    runner_.attach(*face_);
  }
  /// The same from a @p plan that has both: `unit` and `make_face`.
  template <class Plan>
  requires requires(const Plan& plan) { plan.make_face; }
  Device(const Plan& plan, Listener& listener) : Device{plan.unit, plan.make_face, listener} {}
  /// The drive unit of @p configuration with its own face.
  Device(const Configuration& configuration, canopen::FrameSink& sink, Listener& listener)
      : Device{unit_configuration(configuration),
               [&](::unit::Runner& runner) {
                 return std::make_unique<CanopenFace>(configuration, runner, sink, listener);
               },
               listener} {}

  /// Before the first start(): @p face is connected to the unit besides the bus.
  void attach(std::unique_ptr<::unit::Face> face) {
    runner_.attach(*face);
    further_faces_.push_back(std::move(face));
  }
  /// The same; @p face outlives this.
  void attach(::unit::Face& face) { runner_.attach(face); }
  /// The face to its bus, and its dictionary, for who stands between that and the drive.
  ::unit::Face& canopen_face() noexcept { return *face_; }
  canopen::Dictionary& objects() noexcept { return face_->objects(); }
  /// See BusFace::spoil().
  bool spoil(std::size_t number, const AxisDefect& defect) noexcept { return face_->spoil(number, defect); }
  /// What a further face works with.
  ::unit::Runner& runner() noexcept { return runner_; }
  const ::unit::Runner& runner() const noexcept { return runner_; }

  /// Before the first start(): the saved parameters, and what a power cut did not take. An image that does not fit
  /// changes nothing.
  [[nodiscard]] tl::expected<void, drive::image_format::Error> load_parameters(
      std::span<const std::byte> image) noexcept {
    return face_->load(image);
  }
  [[nodiscard]] tl::expected<void, drive::image_format::Error> load_retained(
      std::span<const std::byte> image) noexcept {
    return runner_.load_retained(image);
  }
  /// What ParameterKeeper::on_store() has begun is over: whoever has asked for it gets the answer, by @p kept that
  /// of success or HardwareError.
  void on_stored(bool kept, canopen::TimePoint now) noexcept { runner_.on_stored(kept, unit_time(now)); }
  /// What survives a power cut at @p now; valid until the next call.
  std::span<const std::byte> retained(canopen::TimePoint now) noexcept { return runner_.retained(unit_time(now)); }

  /// Power-on, or the bus is back: sends the boot-up message and starts the communication afresh. If the node was
  /// Operational, that is leaving Operational.
  void start(canopen::TimePoint now) noexcept {
    if (!runner_.is_on()) runner_.start(unit_time(now));
    runner_.tell_time(unit_time(now));
    face_->start();
  }
  /// A frame from the bus; SDO requests are answered within the call, but saves: see on_stored().
  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    face_->on_frame(frame);
  }
  /// Handles what is due at @p now: timers of the node and process-data cycles.
  void on_time(canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    face_->before_cycles();
    runner_.run_due();
    face_->after_cycles();
  }
  /// The same in parts: see unit::Runner::begin_due().
  [[nodiscard]] drive::DriveUnit* begin_time(canopen::TimePoint now) noexcept;
  void finish_time() noexcept;
  /// See drive::DriveUnit::let_in().
  void let_in(drive::Interlude* interlude) noexcept { runner_.let_in(interlude); }
  /// When on_time() is wanted next; kNever while nothing moves and nothing is pending.
  canopen::TimePoint next_deadline() const noexcept {
    return std::min(face_->next_deadline(), node_time(runner_.next_deadline()));
  }

  /// What goes on by itself while the unit rests (temperatures, operating time) is that of @p now.
  void tell_time(canopen::TimePoint now) noexcept { runner_.tell_time(unit_time(now)); }
  /// Somebody beside the bus is about to read and write by the runner at @p now.
  void begin_access(canopen::TimePoint now) noexcept {
    runner_.tell_time(unit_time(now));
    face_->tell_time();
  }
  /// Somebody beside the bus writes a parameter at @p now: see unit::Runner::write_parameter().
  [[nodiscard]] tl::expected<void, drive::ParameterError> write_parameter(std::uint8_t object,
                                                                          std::uint16_t number, std::size_t index,
                                                                          double value,
                                                                          canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    face_->tell_time();
    return runner_.write_parameter(object, number, index, value, unit_time(now));
  }
  /// Somebody beside the bus reads and writes parameters at @p now: @p use(drive::ParameterAccess&) does it and
  /// makes an answer of it, and what the writes lead to is carried out behind that. A save that one begins goes
  /// on.
  template <class Use>
  auto access_parameters(canopen::TimePoint now, const Use& use) noexcept {
    runner_.set_now(unit_time(now));
    face_->tell_time();
    auto answer = use(runner_.parameter_access());
    runner_.follow_up();
    return answer;
  }
  /// Somebody beside the bus writes @p entry of dictionary() at @p now: see BusFace::write_object().
  template <class Value>
  [[nodiscard]] canopen::Result<void> write_object(const canopen::Entry& entry, const Value& value,
                                                   canopen::TimePoint now) noexcept {
    runner_.tell_time(unit_time(now));
    return face_->write_object(entry, value);
  }
  /// Whether the unit was switched on: it is when its bus is there for the first time.
  bool is_on() const noexcept { return runner_.is_on(); }
  /// All parameters are those of a new unit, as with 1011h; the reason if they cannot be now.
  [[nodiscard]] std::optional<drive::Refusal> restore(canopen::TimePoint now) noexcept {
    runner_.tell_time(unit_time(now));
    face_->tell_time();
    const auto refused = face_->restore();
    if (!refused) runner_.follow_up();
    return refused;
  }
  /// What was saved last, or loaded; valid until the next save.
  drive::SavedValues saved_parameters() const noexcept { return runner_.saved_parameters(); }
  /// A save runs: nothing that is saved may be written.
  bool is_saving() const noexcept { return face_->is_saving(); }
  /// Whether anything was saved, or loaded.
  bool is_stored() const noexcept { return face_->is_stored(); }

  /// The unit is switched off and on again at @p now, at once: it boots with what was saved.
  void power_cycle(canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    face_->tell_time();
    runner_.power_cycle();
    runner_.follow_up();
  }

  /// Raises fault or alarm @p number on @p axis (0..axes) with @p value; a message that propagates appears on
  /// every drive object.
  tl::expected<void, drive::FaultError> raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                              canopen::TimePoint now) noexcept {
    return runner_.raise(axis, number, value, unit_time(now));
  }
  /// Acknowledges the faults of @p axis (0..axes) and takes back the alarms that raise() brought; true if no fault
  /// is left.
  bool acknowledge(std::size_t axis, canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    return face_->acknowledge(axis);
  }
  /// Sets the load torque of @p axis (1..axes; N·m; a constant one positive against positive rotation, friction
  /// not negative).
  void set_load_torque(std::size_t axis, double torque, canopen::TimePoint now,
                       motor::LoadTorqueType type = motor::LoadTorqueType::Constant) noexcept {
    runner_.set_load_torque(axis, torque, unit_time(now), type);
  }
  /// The encoder of @p axis (1..axes) has @p defect from now on.
  void fail_encoder(std::size_t axis, motor::EncoderDefect defect, canopen::TimePoint now) noexcept {
    runner_.fail_encoder(axis, defect, unit_time(now));
  }
  /// An operator panel takes the control of @p axis (1..axes), commands it and gives the control back: see
  /// unit::Runner.
  [[nodiscard]] std::optional<drive::PanelRefusal> take_control(std::size_t axis, double timeout,
                                                                canopen::TimePoint now) noexcept {
    return runner_.take_control(axis, timeout, unit_time(now));
  }
  [[nodiscard]] bool command_by_panel(std::size_t axis, bool on, double speed, canopen::TimePoint now) noexcept {
    return runner_.command_by_panel(axis, on, speed, unit_time(now));
  }
  [[nodiscard]] bool give_control_back(std::size_t axis, canopen::TimePoint now) noexcept {
    return runner_.give_control_back(axis, unit_time(now));
  }
  /// Sets the line voltage of the supply (V rms between lines, not negative; 0 = mains failure).
  void set_line_voltage(double voltage, canopen::TimePoint now) noexcept {
    runner_.set_line_voltage(voltage, unit_time(now));
  }
  /// Inertia and friction of the load of @p axis (1..axes) and the air around its motor are @p settings from @p
  /// now on: see drive::Axis::set_plant().
  void set_plant(std::size_t axis, const motor::PlantSettings& settings, canopen::TimePoint now) noexcept {
    runner_.set_plant(axis, settings, unit_time(now));
  }
  /// Puts @p voltage (V) to the analogue input of the control unit (r0752).
  void set_analog_input(double voltage, canopen::TimePoint now) noexcept {
    runner_.set_analog_input(voltage, unit_time(now));
  }
  /// Puts terminal @p number of the control unit (drive::Terminals::exists) to 24 V or 0 V; the cycle that @p now
  /// lies in takes it.
  void set_input(unsigned number, bool high, canopen::TimePoint now) noexcept {
    runner_.set_input(number, high, unit_time(now));
  }

  /// The CAN controller is in error state @p state now. While the bus is off the unit sends nothing and hears
  /// nothing but SDO requests, which it answers: p8608 ends that also where no controller does.
  void on_bus_state(BusState state, canopen::TimePoint now) noexcept {
    runner_.tell_time(unit_time(now));
    face_->on_bus_state(state);
  }
  /// p8608[0] = 1 at @p now; false if the bus is not off.
  bool restart_bus(canopen::TimePoint now) noexcept {
    runner_.set_now(unit_time(now));
    return face_->restart_bus();
  }
  /// Frames that had arrived were lost before on_frame(): A08751.
  void on_frames_lost(canopen::TimePoint now) noexcept {
    runner_.tell_time(unit_time(now));
    face_->on_frames_lost();
  }

  /// Why axis @p number (1..axes) does not turn: see BusFace::explain().
  std::vector<std::string> explain(std::size_t number, std::vector<std::string> commanding = {}) const {
    return face_->explain(number, std::move(commanding));
  }

  /// From now on frames go to @p sink, which outlives this.
  void send_to(canopen::FrameSink& sink) noexcept { face_->send_to(sink); }

  /// The address in force.
  std::uint8_t node_id() const noexcept { return node().node_id(); }
  const canopen::Node& node() const noexcept { return face_->node(); }
  const canopen::Dictionary& dictionary() const noexcept { return face_->dictionary(); }
  /// The parameter that a master sees at @p index, @p sub_index of the SDO server at position @p server, if any.
  std::optional<ParameterWindow::Target> parameter_at(std::uint8_t server, std::uint16_t index,
                                                      std::uint8_t sub_index) const noexcept {
    const ParameterWindow* const window = face_->window();
    return window != nullptr ? window->parameter_at(server, index, sub_index) : std::nullopt;
  }
  /// Axis @p number (1..axes) as masters see it, and what its transitions need.
  AxisView view(std::size_t number) const noexcept { return face_->view(number); }
  std::vector<drive::TransitionView> state_machine(std::size_t number) const {
    return face_->state_machine(number);
  }
  const drive::DriveUnit& unit() const noexcept { return runner_.unit(); }
  /// Axis @p number (1..axes).
  const drive::Axis& axis(std::size_t number = 1) const noexcept { return runner_.unit().axes()[number - 1]; }
  /// What must be received (see canopen::Node::subscriptions()).
  std::span<const canopen::Subscription> subscriptions() const noexcept { return face_->subscriptions(); }
  /// What the LEDs of the CANopen board show.
  IndicatorLeds leds() const noexcept { return face_->leds(); }
  /// The process-data cycle in force: p8848 as of the last start of the unit.
  canopen::Duration cycle() const noexcept { return runner_.clock().period(); }
  /// When the next process-data cycle is due; kNever while the unit rests.
  canopen::TimePoint next_cycle() const noexcept { return node_time(runner_.next_deadline()); }
  /// Counts how often the faults and alarms were different from before.
  std::uint32_t message_changes() const noexcept { return runner_.message_changes(); }
  /// Whether an axis turns or has its pulses enabled.
  bool is_moving() const noexcept { return runner_.is_moving(); }
  /// The axes (bit 0 = axis 1) whose load drives the shaft at its bursting speed.
  std::uint32_t held_back_axes() const noexcept { return runner_.held_back_axes(); }
  /// Frames of asynchronous RPDOs whose values were overwritten before a cycle has taken them.
  std::uint64_t lost_telegrams() const noexcept { return face_->lost_telegrams(); }
  /// Cycles left out because the program was kept from running for too long.
  std::uint64_t skipped_cycles() const noexcept { return runner_.skipped_cycles(); }

 private:
  ::unit::Runner runner_;
  std::unique_ptr<BusFace> face_;
  std::vector<std::unique_ptr<::unit::Face>> further_faces_;
};

}  // namespace device
