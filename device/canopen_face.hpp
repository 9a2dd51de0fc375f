#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device/bus/bus_follow_ups.hpp"
#include "device/bus/communication.hpp"
#include "device/bus/node_address.hpp"
#include "device/bus/reception.hpp"
#include "device/bus/unit_time.hpp"
#include "device/bus_face.hpp"
#include "device/objects/configuration.hpp"
#include "device/objects/error_objects.hpp"
#include "device/objects/unit_objects.hpp"
#include "device/parameters/mirrored_parameters.hpp"
#include "device/parameters/parameter_window.hpp"
#include "device/process_data/axis_objects.hpp"
#include "device/process_data/unit_process_data.hpp"
#include "libcanopen/node/node.hpp"
#include "unit/runner.hpp"

namespace device {

/// The drive unit as a CANopen node: control unit and axes behind the objects of CiA 301 and CiA 402. It is fed
/// frames, and time that the runner has been told, and hands its frames to a sink.
class CanopenFace final : public BusFace,
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

  // BusFace
  void start() noexcept override;
  void on_frame(const canopen::Frame& frame) noexcept override {
    if (communication_.is_bus_off()) return serve_off_the_bus(frame);
    serve(frame);
  }
  void before_cycles() noexcept override;
  void after_cycles() noexcept override;
  canopen::TimePoint next_deadline() const noexcept override {
    return std::min({node_.next_deadline(), reception_.next_deadline(), communication_.restart_at()});
  }
  /// p8608 ends bus-off also where no controller does.
  void on_bus_state(BusState state) noexcept override;
  /// p8608[0] = 1.
  bool restart_bus() noexcept override;
  /// A08751.
  void on_frames_lost() noexcept override { reception_.on_frames_lost(); }
  void send_to(canopen::FrameSink& sink) noexcept override { communication_.send_to(sink); }
  const canopen::Node& node() const noexcept override { return node_; }
  void tell_time() noexcept override { node_.on_time(now()); }
  canopen::Result<void> write_object(const canopen::Entry& entry, std::int64_t value) noexcept override;
  canopen::Result<void> write_object(const canopen::Entry& entry,
                                     std::span<const std::uint8_t> text) noexcept override;
  const canopen::Dictionary& dictionary() const noexcept override { return objects_.dictionary; }
  canopen::Dictionary& objects() noexcept override { return objects_.dictionary; }
  const ParameterWindow* window() const noexcept override { return &window_; }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return node_.subscriptions(); }
  IndicatorLeds leds() const noexcept override;
  std::uint64_t lost_telegrams() const noexcept override { return reception_.lost_telegrams(); }
  /// What drive::explain() says, and behind the faults what the node and its process data have to do with it; an
  /// axis that is commanded over SDO is not told of RPDOs.
  std::vector<std::string> explain(std::size_t number, std::vector<std::string> commanding) const override;
  AxisView view(std::size_t number) const noexcept override;
  std::vector<drive::TransitionView> state_machine(std::size_t number) const override {
    return drive::state_machine(runner_.unit().axes()[number - 1]);
  }
  bool acknowledge(std::size_t axis) noexcept override { return runner_.acknowledge(axis, runner_.now()); }
  tl::expected<void, drive::image_format::Error> load(std::span<const std::byte> image) noexcept override {
    return runner_.load_parameters(image);
  }
  std::optional<drive::Refusal> restore() noexcept override { return runner_.restore(unit::ParameterGroup::All); }
  bool is_saving() const noexcept override { return runner_.is_saving(); }
  bool is_stored() const noexcept override { return runner_.has_saved_parameters(); }

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
