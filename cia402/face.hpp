#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cia402/bus/axis_objects.hpp"
#include "cia402/bus/device_objects.hpp"
#include "cia402/bus/rpdo_actions.hpp"
#include "cia402/drive/drive_link.hpp"
#include "cia402/setup/configuration.hpp"
#include "cia402/storage/object_image.hpp"
#include "device/bus/bus_outlet.hpp"
#include "device/bus/unit_time.hpp"
#include "device/bus_face.hpp"
#include "libcanopen/lss/lss_slave.hpp"
#include "libcanopen/node/node.hpp"
#include "unit/parameter_storage.hpp"
#include "unit/runner.hpp"

namespace cia402 {

/// The drives as a CANopen node of the profile CiA 402: axes behind the objects of CiA 301 and CiA 402-2. It is
/// fed frames, and time that the runner has been told, and hands its frames to a sink.
class Face final : public device::BusFace,
                   private canopen::Application,
                   private canopen::LssApplication,
                   private AxisListener,
                   private WriteListener {
 public:
  /// A face of the unit of @p runner, to be attached to it; what is saved goes to @p keeper. All arguments but the
  /// configuration outlive this.
  Face(const Configuration& configuration, unit::Runner& runner, canopen::FrameSink& sink,
       device::BusListener& listener, unit::ParameterKeeper& keeper);
  ~Face() override = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  // device::BusFace
  void start() noexcept override;
  void on_frame(const canopen::Frame& frame) noexcept override;
  void before_cycles() noexcept override {}
  void after_cycles() noexcept override { node_.on_time(now()); }
  canopen::TimePoint next_deadline() const noexcept override { return node_.next_deadline(); }
  void on_bus_state(device::BusState state) noexcept override;
  bool restart_bus() noexcept override;
  void on_frames_lost() noexcept override;
  void send_to(canopen::FrameSink& sink) noexcept override { outlet_.connect(sink); }
  const canopen::Node& node() const noexcept override { return node_; }
  void tell_time() noexcept override { node_.on_time(now()); }
  canopen::Result<void> write_object(const canopen::Entry& entry, std::int64_t value) noexcept override;
  canopen::Result<void> write_object(const canopen::Entry& entry,
                                     std::span<const std::uint8_t> text) noexcept override;
  const canopen::Dictionary& dictionary() const noexcept override { return objects_.dictionary; }
  canopen::Dictionary& objects() noexcept override { return objects_.dictionary; }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return node_.subscriptions(); }
  device::IndicatorLeds leds() const noexcept override;
  tl::expected<void, drive::image_format::Error> load(std::span<const std::byte> image) noexcept override;
  std::optional<drive::Refusal> restore() noexcept override;
  bool is_saving() const noexcept override { return is_saving_; }
  bool is_stored() const noexcept override { return image_.is_saved(); }
  std::vector<std::string> explain(std::size_t number, std::vector<std::string> commanding) const override;
  device::AxisView view(std::size_t number) const noexcept override;
  std::vector<drive::TransitionView> state_machine(std::size_t number) const override;
  /// Of an axis also as the edge of bit 7 of its controlword does.
  bool acknowledge(std::size_t axis) noexcept override;
  bool spoil(std::size_t number, const device::AxisDefect& defect) noexcept override;

  /// Axis @p number (1..axes).
  const Axis& axis(std::size_t number) const noexcept { return axes_[number - 1].axis(); }

 private:
  // unit::Face
  void bring() noexcept override;
  unit::AxisMask waiting() const noexcept override;
  void show() noexcept override;
  void on_cycles_over() noexcept override { node_.on_values_changed(now()); }
  void show_messages(bool changed) noexcept override;
  bool restart_unit() noexcept override;
  void on_stored(bool kept) noexcept override;

  // canopen::Application
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  void on_reset(canopen::NmtCommand command) noexcept override;
  void on_rpdo(std::uint16_t number) noexcept override;
  void on_synchronous_rpdos() noexcept override;
  void on_sdo_written(const canopen::Entry& entry) noexcept override;
  void on_subscriptions_changed() noexcept override { listener_.on_subscriptions_changed(); }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { listener_.on_foreign_frame(identifier); }
  void on_life_guarding_withheld() noexcept override { listener_.on_life_guarding_withheld(); }
  canopen::Result<void> on_store(std::uint8_t sub_index) noexcept override;
  canopen::Result<void> on_restore(std::uint8_t sub_index) noexcept override;
  void on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept override;
  void on_time_of_day(const canopen::TimeOfDay& time) noexcept override;
  // canopen::LssApplication
  canopen::LssStored on_lss_store(const canopen::LssSettings& settings) noexcept override;

  // AxisListener, WriteListener
  void on_error(std::size_t axis, ErrorCode error) noexcept override;
  bool on_fault_reset(std::size_t axis) noexcept override;
  void on_acting(std::size_t axis, ActingSet what) noexcept override;

  canopen::TimePoint now() const noexcept { return device::node_time(runner_.now()); }
  void act(AxisActions& actions) noexcept;
  TimeNs instant() const noexcept;
  void wake_for(std::size_t axis) noexcept;
  std::uint64_t clock_us() const noexcept;
  bool rests(std::size_t axis) const noexcept;
  void lose_connection(bool only_late = false) noexcept;
  void power_on_axes() noexcept;
  void follow_rpdos() noexcept;
  void forget_errors(std::size_t axis) noexcept;
  canopen::Result<void> keep(std::span<const std::byte> image) noexcept;

  /// Of an axis: what it has told the master of.
  struct Errors {
    static constexpr std::size_t kMost = 8;
    std::array<std::uint16_t, kMost> codes{};
    std::size_t count = 0;
  };

  unit::Runner& runner_;
  device::BusListener& listener_;
  unit::ParameterKeeper& keeper_;
  DeviceObjects objects_;
  ObjectImage image_;
  canopen::Node node_;
  device::BusOutlet outlet_;
  canopen::LssSlave lss_;
  std::deque<AxisObjects> axes_;
  std::vector<DriveLink> links_;
  std::vector<Errors> errors_;
  RpdoActions rpdo_actions_;
  AxisActions pending_{};             ///< of synchronous RPDOs that wait for the rest of their SYNC
  unit::AxisMask touched_ = 0;        ///< something has come that no cycle has taken
  unit::AxisMask shown_ = 0;          ///< ran in the last cycle
  std::uint32_t seen_sequence_ = 0;   ///< of the newest message of a drive that was told
  std::int64_t clock_offset_us_ = 0;  ///< from the time of the unit to that of 1012h
  device::BusState bus_ = device::BusState::Active;
  bool is_saving_ = false;
  bool is_told_ = false;  ///< the library has sent the EMCY of the error that an axis reacts to
  bool restarts_unit_ = false;
};

}  // namespace cia402
