#pragma once

#include <cstdint>
#include <deque>
#include <span>

#include "device/bus/bus_follow_ups.hpp"
#include "device/bus/communication.hpp"
#include "device/bus/indicator_leds.hpp"
#include "device/bus/node_address.hpp"
#include "device/bus/reception.hpp"
#include "device/bus/unit_time.hpp"
#include "device/objects/configuration.hpp"
#include "device/objects/error_objects.hpp"
#include "device/objects/unit_objects.hpp"
#include "device/parameters/mirrored_parameters.hpp"
#include "device/parameters/parameter_window.hpp"
#include "device/process_data/axis_objects.hpp"
#include "device/process_data/unit_process_data.hpp"
#include "libcanopen/node/node.hpp"
#include "unit/face.hpp"
#include "unit/runner.hpp"

namespace device {

/// What the node tells the program around it. Called from within the functions of CanopenFace.
class BusListener {
 public:
  virtual ~BusListener() = default;
  /// The identifiers to be received have changed: see CanopenFace::subscriptions().
  virtual void on_subscriptions_changed() noexcept = 0;
  /// Another station has sent @p identifier, which belongs to this node-ID.
  virtual void on_foreign_frame(std::uint32_t identifier) noexcept = 0;
  /// Life guarding was asked for and stays off (see device::Configuration::remote_frames).
  virtual void on_life_guarding_withheld() noexcept {}
  /// When the RPDO that wakes the resting unit at @p now has come from the bus: @p now, or earlier if the program
  /// was kept from running.
  virtual canopen::TimePoint frame_arrival(canopen::TimePoint now) noexcept { return now; }
  /// p8608 asks for the controller to be restarted from bus-off. True if the bus can be used now, false if it
  /// cannot yet: CanopenFace::on_bus_state() tells when.
  virtual bool on_bus_restart() noexcept { return true; }
  /// The NMT state has changed.
  virtual void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
    static_cast<void>(from), static_cast<void>(to);
  }
  /// A save of the parameters is over; @p kept: with success.
  virtual void on_saved(bool kept) noexcept { static_cast<void>(kept); }
};

/// The drive unit as a CANopen node: control unit and axes behind the objects of CiA 301 and CiA 402. It is fed
/// frames, and time that the runner has been told, and hands its frames to a sink.
class CanopenFace final : public unit::Face,
                          private canopen::Application,
                          private canopen::EntryOwner,
                          private AlarmListener,
                          private drive::AccessListener {
 public:
  /// A face of the unit of @p runner, to be attached to it; all arguments but the configuration outlive this.
  CanopenFace(const Configuration& configuration, unit::Runner& runner, canopen::FrameSink& sink,
              BusListener& listener);
  ~CanopenFace() override = default;
  CanopenFace(const CanopenFace&) = delete;
  CanopenFace& operator=(const CanopenFace&) = delete;

  // The time is that of the runner.
  /// The unit is on, or the bus is back: sends the boot-up message and starts the communication afresh. If the
  /// node was Operational, that is leaving Operational.
  void start() noexcept;
  /// A frame from the bus; SDO requests are answered within the call, but saves: see Face::on_stored().
  void on_frame(const canopen::Frame& frame) noexcept {
    if (communication_.is_bus_off()) return serve_off_the_bus(frame);
    serve(frame);
  }
  /// Handles what is due of what is missing or lost, before the cycles that are due, and of the node, after them.
  void before_cycles() noexcept;
  void after_cycles() noexcept;
  /// When they are wanted next.
  canopen::TimePoint next_deadline() const noexcept {
    return std::min({node_.next_deadline(), reception_.next_deadline(), communication_.restart_at()});
  }

  /// The CAN controller is in error state @p state now. While the bus is off the unit sends nothing and hears
  /// nothing but SDO requests, which it answers: p8608 ends that also where no controller does.
  void on_bus_state(BusState state) noexcept;
  /// p8608[0] = 1; false if the bus is not off.
  bool restart_bus() noexcept;
  /// Frames that had arrived were lost before on_frame(): A08751.
  void on_frames_lost() noexcept { reception_.on_frames_lost(); }

  /// From now on frames go to @p sink, which outlives this.
  void send_to(canopen::FrameSink& sink) noexcept { communication_.send_to(sink); }

  const canopen::Node& node() const noexcept { return node_; }
  /// Before somebody beside the bus changes anything: the services of the node are told the time.
  void tell_time() noexcept { node_.on_time(now()); }
  /// Somebody beside the bus writes the number, or the text, @p entry of dictionary(), as a master over SDO does;
  /// what it leads to is carried out at once. A save that this begins goes on.
  canopen::Result<void> write_object(const canopen::Entry& entry, std::int64_t value) noexcept;
  canopen::Result<void> write_object(const canopen::Entry& entry, std::span<const std::uint8_t> text) noexcept;

  const canopen::Dictionary& dictionary() const noexcept { return objects_.dictionary; }
  canopen::Dictionary& objects() noexcept { return objects_.dictionary; }
  /// What the parameters of the drive objects are on the SDO servers.
  const ParameterWindow& window() const noexcept { return window_; }
  /// What must be received (see canopen::Node::subscriptions()).
  std::span<const canopen::Subscription> subscriptions() const noexcept { return node_.subscriptions(); }
  /// What the LEDs of the CANopen board show.
  IndicatorLeds leds() const noexcept;
  /// Frames of asynchronous RPDOs whose values were overwritten before a cycle has taken them.
  std::uint64_t lost_telegrams() const noexcept { return reception_.lost_telegrams(); }

 private:
  // unit::Face
  void bring() noexcept override;
  unit::AxisMask waiting() const noexcept override;
  void show() noexcept override;
  void on_cycles_over() noexcept override { node_.on_values_changed(now()); }
  void show_messages(bool changed) noexcept override { error_objects_.update(node_, changed); }
  void adopt(const unit::Replacement& replacement) noexcept override;
  void resume(const unit::Replacement& replacement) noexcept override;
  bool restart_unit() noexcept override;
  void on_stored(bool kept) noexcept override;
  bool follow_up() noexcept override;

  // canopen::Application
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  void on_reset(canopen::NmtCommand command) noexcept override;
  void before_rpdo(std::uint16_t number) noexcept override { reception_.before_rpdo(number); }
  void on_rpdo(std::uint16_t number) noexcept override;
  void on_subscriptions_changed() noexcept override { listener_.on_subscriptions_changed(); }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { listener_.on_foreign_frame(identifier); }
  void on_life_guarding_withheld() noexcept override { listener_.on_life_guarding_withheld(); }
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override;
  void on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept override;

  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  void on_alarm() noexcept override { runner_.tell_time(), runner_.show_messages_later(); }
  bool is_locked() const noexcept override { return runner_.is_saving(); }
  void on_access() noexcept override { runner_.tell_time(); }
  void on_written(std::uint8_t object, std::uint16_t number) noexcept override;

  canopen::TimePoint now() const noexcept { return node_time(runner_.now()); }
  void serve(const canopen::Frame& frame) noexcept {
    node_.on_frame(frame, now());
    follow_up_all();
  }
  void follow_up_all() noexcept {
    if (runner_.has_follow_ups() || !follow_ups_.is_empty()) runner_.follow_up();
  }
  void wire_mappings(std::uint8_t) noexcept;
  void plan_bus_restart(std::uint8_t asked) noexcept;
  void command_node(std::uint8_t command) noexcept;
  // canopen_face_bus.cpp
  void serve_off_the_bus(const canopen::Frame& frame) noexcept;
  void try_bus_restart() noexcept;
  void lose_connection() noexcept;
  void leave_operational(std::uint32_t value) noexcept;
  // canopen_face_parameters.cpp
  void take_over_parameters() noexcept;
  void forget_written() noexcept;
  void name_groups() noexcept;
  UnitProcessData::WiredBy wired_by(const unit::Replacement& replacement) const noexcept;

  unit::Runner& runner_;
  BusListener& listener_;
  bool fault_on_leaving_operational_;
  bool restarting_ = false;  ///< the unit itself leaves Operational
  BusFollowUps follow_ups_;
  NodeAddress address_;
  UnitObjects objects_;
  MirroredParameters mirrored_parameters_;
  std::deque<AxisObjects> axes_;
  ErrorObjects error_objects_;
  canopen::Node node_;
  UnitProcessData process_data_;
  Communication communication_;
  ParameterWindow window_;
  Reception reception_;
  bool restarts_unit_ = false;  ///< the reset that comes is that of restart_unit()
};

}  // namespace device
