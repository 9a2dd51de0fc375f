#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "device/axis_objects.hpp"
#include "device/communication.hpp"
#include "device/configuration.hpp"
#include "device/cycle_clock.hpp"
#include "device/error_control.hpp"
#include "device/error_objects.hpp"
#include "device/indicator_leds.hpp"
#include "device/mirrored_parameters.hpp"
#include "device/node_address.hpp"
#include "device/object_rows.hpp"
#include "device/parameter_storage.hpp"
#include "device/parameter_window.hpp"
#include "device/presets.hpp"
#include "device/rpdo_monitor.hpp"
#include "device/sdo_identifiers.hpp"
#include "device/telegram_loss.hpp"
#include "device/unit_parameters.hpp"
#include "device/unit_process_data.hpp"
#include "drive/drive_unit.hpp"
#include "drive/retained_image.hpp"
#include "libcanopen/node/node.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// What the unit tells the program around it. Called from within the functions of Device.
class Listener : public ParameterKeeper {
 public:
  /// The identifiers to be received have changed: see Device::subscriptions().
  virtual void on_subscriptions_changed() noexcept = 0;
  /// Another station has sent @p identifier, which belongs to this node-ID.
  virtual void on_foreign_frame(std::uint32_t identifier) noexcept = 0;
  /// Life guarding was asked for and stays off (see device::Configuration::remote_frames).
  virtual void on_life_guarding_withheld() noexcept {}
  /// When the RPDO that wakes the resting unit at @p now has come from the bus: @p now, or earlier if the program
  /// was kept from running.
  virtual canopen::TimePoint frame_arrival(canopen::TimePoint now) noexcept { return now; }
  /// p8608 asks for the controller to be restarted from bus-off. True if the bus can be used now, false if it
  /// cannot yet: Device::on_bus_state() tells when.
  virtual bool on_bus_restart() noexcept { return true; }
};

/// The drive unit as a CANopen node: control unit and axes behind the objects of CiA 301 and CiA 402. It is fed
/// frames and time and hands its frames to a sink; nothing in it reads a clock, blocks or, after construction,
/// allocates. Axes are counted from 1; where a function takes one, 0 is the control unit.
class Device final : private canopen::Application,
                     private canopen::EntryOwner,
                     private AxisListener,
                     private AlarmListener,
                     private WindowListener {
 public:
  /// Process-data cycle of a new unit.
  static constexpr canopen::Duration kCycle = CycleClock::kFactory;

  Device(const Configuration& configuration, canopen::FrameSink& sink, Listener& listener);
  ~Device() override = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Before the first start(): the saved parameters, and what a power cut did not take. An image that does not fit
  /// changes nothing.
  [[nodiscard]] tl::expected<void, drive::image_format::Error> load_parameters(
      std::span<const std::byte> image) noexcept;
  [[nodiscard]] tl::expected<void, drive::image_format::Error> load_retained(
      std::span<const std::byte> image) noexcept;
  /// What ParameterKeeper::on_store() has begun is over: whoever has asked for it gets the answer, by @p kept that
  /// of success or HardwareError.
  void on_stored(bool kept, canopen::TimePoint now) noexcept;
  /// What survives a power cut at @p now; valid until the next call.
  std::span<const std::byte> retained(canopen::TimePoint now) noexcept;

  /// Power-on, or the bus is back: sends the boot-up message and starts the communication afresh. If the node was
  /// Operational, that is leaving Operational.
  void start(canopen::TimePoint now) noexcept;
  /// A frame from the bus; SDO requests are answered within the call, but saves: see on_stored().
  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept;
  /// Handles what is due at @p now: timers of the node and process-data cycles.
  void on_time(canopen::TimePoint now) noexcept;
  /// When on_time() is wanted next; kNever while nothing moves and nothing is pending.
  canopen::TimePoint next_deadline() const noexcept;

  /// Raises fault or alarm @p number on @p axis (0..axes) with @p value; a message that propagates appears on
  /// every drive object.
  tl::expected<void, drive::FaultError> raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                              canopen::TimePoint now) noexcept;
  /// Acknowledges the faults of @p axis (0..axes) and takes back the alarms that raise() brought; true if no fault
  /// is left.
  bool acknowledge(std::size_t axis, canopen::TimePoint now) noexcept;
  /// Sets the load torque of @p axis (1..axes; N·m; a constant one positive against positive rotation, friction
  /// not negative).
  void set_load_torque(std::size_t axis, double torque, canopen::TimePoint now,
                       motor::LoadTorqueType type = motor::LoadTorqueType::Constant) noexcept;
  /// The encoder of @p axis (1..axes) has @p defect from now on.
  void fail_encoder(std::size_t axis, motor::EncoderDefect defect, canopen::TimePoint now) noexcept;
  /// Sets the line voltage of the supply (V rms between lines, not negative; 0 = mains failure).
  void set_line_voltage(double voltage, canopen::TimePoint now) noexcept;

  /// Puts terminal @p number of the control unit (drive::Terminals::exists) to 24 V or 0 V; the cycle that @p now
  /// lies in takes it.
  void set_input(unsigned number, bool high, canopen::TimePoint now) noexcept;

  /// The CAN controller is in error state @p state now. While the bus is off the unit sends nothing and hears
  /// nothing but SDO requests, which it answers: p8608 ends that also where no controller does.
  void on_bus_state(BusState state, canopen::TimePoint now) noexcept;
  /// p8608[0] = 1 at @p now; false if the bus is not off.
  bool restart_bus(canopen::TimePoint now) noexcept;
  /// Frames that had arrived were lost before on_frame(): A08751.
  void on_frames_lost(canopen::TimePoint now) noexcept;

  /// The address in force.
  std::uint8_t node_id() const noexcept { return node_.node_id(); }
  const canopen::Node& node() const noexcept { return node_; }
  const drive::DriveUnit& unit() const noexcept { return unit_; }
  /// Axis @p number (1..axes).
  const drive::Axis& axis(std::size_t number = 1) const noexcept { return unit_.axes()[number - 1]; }
  /// What must be received (see canopen::Node::subscriptions()).
  std::span<const canopen::Subscription> subscriptions() const noexcept { return node_.subscriptions(); }
  /// What the LEDs of the CANopen board show.
  IndicatorLeds leds() const noexcept;
  /// The process-data cycle in force: p8848 as of the last start of the unit.
  canopen::Duration cycle() const noexcept { return clock_.period(); }
  /// Counts how often the faults and alarms were different from before.
  std::uint32_t message_changes() const noexcept { return error_objects_.updates(); }
  /// Whether an axis turns or has its pulses enabled.
  bool is_moving() const noexcept;
  /// The axes (bit 0 = axis 1) whose load drives the shaft at its bursting speed.
  std::uint32_t held_back_axes() const noexcept;
  /// Frames of asynchronous RPDOs whose values were overwritten before a cycle has taken them.
  std::uint64_t lost_telegrams() const noexcept { return lost_telegrams_; }
  /// Cycles left out because the program was kept from running for too long.
  std::uint64_t skipped_cycles() const noexcept { return skipped_cycles_; }

 private:
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  void on_reset(canopen::NmtCommand command) noexcept override;
  void before_rpdo(std::uint16_t number) noexcept override;
  void on_rpdo(std::uint16_t number) noexcept override;
  void on_subscriptions_changed() noexcept override { listener_.on_subscriptions_changed(); }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { listener_.on_foreign_frame(identifier); }
  void on_life_guarding_withheld() noexcept override { listener_.on_life_guarding_withheld(); }
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override {
    return storage_.restore(sub_index);
  }
  void on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept override;
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  void on_awake() noexcept override;
  void on_alarm() noexcept override { tell_time(now_), alarm_changed_ = true; }

  /// Takes the frames of a node that is off the bus.
  struct Nowhere final : canopen::FrameSink {
    void send(const canopen::Frame&, canopen::Delivery) override {}
  };
  void on_parameter_access() noexcept override { tell_time(now_); }
  bool is_locked() const noexcept override { return storage_.is_saving(); }
  void on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept override;

  void tell_time(canopen::TimePoint now) noexcept;
  void serve(const canopen::Frame& frame) noexcept;
  void run_cycles() noexcept;
  void run_cycle(bool all) noexcept;
  void show_values() noexcept;
  void switch_off() noexcept;
  void publish() noexcept;
  void show_messages() noexcept;
  void follow_parameters() noexcept;
  void wake() noexcept;
  void leave_operational(std::uint32_t value) noexcept;
  void bring_out(ParameterGroup group) noexcept;
  UnitProcessData::WiredBy wired_at_start() const noexcept;
  void take_over(ParameterGroup group, UnitProcessData::WiredBy wired) noexcept;
  void restore_object(std::uint8_t object) noexcept;
  void take_over_parameters() noexcept;
  void carry_out_task() noexcept;
  void restore(ParameterGroup group) noexcept;
  void miss_rpdos() noexcept;
  void take_over_cycle() noexcept;
  void restart() noexcept;
  bool restart_is_due() const noexcept;
  // device_bus.cpp
  void serve_off_the_bus(const canopen::Frame& frame) noexcept;
  void restart_bus() noexcept;
  void overwrite(std::uint16_t number) noexcept;
  bool make_up_cycle() noexcept;
  void lose_connection() noexcept;
  void lose_telegram(std::uint16_t number) noexcept;
  void end_telegram_loss() noexcept;

  Configuration configuration_;
  canopen::FrameSink& sink_;
  Nowhere nowhere_;
  Listener& listener_;
  UnitParameters parameters_;
  NodeAddress address_;
  drive::DriveUnit unit_;
  ParameterStorage storage_;
  std::vector<std::byte> retained_;
  std::vector<canopen::EntryDescription> object_rows_;
  canopen::Dictionary dictionary_;
  MirroredParameters mirrored_parameters_;
  Presets presets_;
  std::deque<AxisObjects> axes_;
  ErrorObjects error_objects_;
  ErrorControl error_control_;
  SdoIdentifiers sdo_identifiers_;
  canopen::Node node_;
  UnitProcessData process_data_;
  Communication communication_;
  ParameterWindow window_;
  RpdoMonitor rpdo_monitor_;
  TelegramLoss telegram_loss_;
  CycleClock clock_;
  std::optional<canopen::TimePoint> started_;        ///< when the unit was switched on
  canopen::TimePoint now_{};                         ///< as last told
  canopen::TimePoint made_up_at_ = canopen::kNever;  ///< when a missed cycle has last been run for a frame
  canopen::TimePoint rested_until_{};                ///< temperatures have been brought up to here while resting
  std::uint8_t restored_object_ = 0;                 ///< a drive object that was reset by p0970, 0 = none
  bool alarm_changed_ = false;                       ///< within a call into the node: messages are shown after it
  bool parameter_written_ = false;  ///< within a call into the node: what follows from it comes after it
  bool restarting_ = false;         ///< the unit itself leaves Operational
  std::uint64_t skipped_cycles_ = 0;
  std::uint64_t lost_telegrams_ = 0;
};

}  // namespace device
