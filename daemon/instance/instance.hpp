#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "can/connection/connection.hpp"
#include "daemon/configuration/configuration.hpp"
#include "daemon/instance/bus_reports.hpp"
#include "daemon/instance/bus_turn.hpp"
#include "daemon/instance/cycle_times.hpp"
#include "daemon/instance/memory/unit_memory.hpp"
#include "daemon/instance/modbus_door.hpp"
#include "daemon/instance/station.hpp"
#include "daemon/watch/event_watch.hpp"
#include "daemon/watch/frame_tap.hpp"
#include "daemon/watch/pdo_watch.hpp"
#include "daemon/watch/streams/frame_stream.hpp"
#include "daemon/watch/streams/sample_stream.hpp"
#include "daemon/watch/unit_audit.hpp"
#include "daemon/watch/unit_recording.hpp"
#include "daemon/watch/unit_trace.hpp"
#include "device/device.hpp"
#include "drive/interlude.hpp"
#include "injection/wire/unit_faults.hpp"
#include "profidrive/channel/parameter_channel.hpp"
#include "profidrive/interface/interface.hpp"
#include "service/log.hpp"

namespace axisd {

class Instance;

/// What an instance tells of itself.
enum class Condition : std::uint8_t {
  Ready,    ///< its boot-up frame is out, for the first time
  Down,     ///< its bus cannot be used
  UpAgain,  ///< its bus can be used again
  Off       ///< it is switched off
};

/// Who runs an instance.
class InstanceListener {
 public:
  virtual ~InstanceListener() = default;
  /// @p instance is in @p condition from now on.
  virtual void on_condition(const Instance& instance, Condition condition) noexcept = 0;
  /// Something has happened in @p instance, which was asked for it (Instance::tell_events()). Called on the thread
  /// of the unit.
  virtual void on_event(const Instance& instance, const UnitEvent& event) noexcept {
    static_cast<void>(instance), static_cast<void>(event);
  }
};

/// One drive unit on one CAN bus: what it is made of, what it keeps and what is logged of it. Whoever runs it
/// waits for its descriptors and deadlines; nothing here does.
class Instance final : private device::Listener,
                       private Station,
                       private TapOwner,
                       private EventListener,
                       private injection::UnitHooks,
                       private drive::WriteObserver,
                       private drive::Interlude {
 public:
  /// A descriptor that is readable when something rare is to be handled, and what handles it: one event at most.
  struct RareSource {
    int descriptor;
    Instance* instance;
    void (Instance::*handle)() noexcept;
  };

  /// Opens the bus that @p configuration names, with the state in @p folder; all arguments must outlive this.
  /// Throws bus::OpenError, ConfigurationError or std::system_error.
  Instance(const Configuration& configuration, const std::filesystem::path& folder, const Log& log,
           InstanceListener& listener);
  /// The same on a bus that was opened already.
  Instance(const Configuration& configuration, bus::Connection connection, const std::filesystem::path& folder,
           const Log& log, InstanceListener& listener);
  ~Instance() override = default;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// Takes up what the unit kept through the last power-off.
  void load() { memory_.load(); }
  /// Power-on: onto the bus, if that is there.
  void start() noexcept;
  /// What something else than a turn may have changed without telling.
  void look_around() noexcept;
  /// The beginning of power_off(), for several units whose states the disk is to take at once.
  void begin_power_off() noexcept;
  /// Power-off: the drives coast, and what survives is on the disk.
  void power_off() noexcept;

  /// What is rare here; the descriptors stay the same.
  std::span<const RareSource> rare_sources() const noexcept { return rare_sources_; }
  /// The part of the loop that is this instance's.
  BusTurn& bus() noexcept { return bus_; }
  const BusTurn& bus() const noexcept { return bus_; }
  device::Device& device() noexcept { return device_; }
  const device::Device& device() const noexcept { return device_; }
  /// Its process data beside the CAN bus.
  profidrive::Interface& if1() noexcept { return if1_; }
  const profidrive::Interface& if1() const noexcept { return if1_; }
  /// Whether masters and operators see parameters: not with profile cia402.
  bool has_parameters() const noexcept { return configuration().profile() == Profile::Unit; }
  const Configuration& configuration() const noexcept { return configuration_; }
  const UnitMemory& memory() const noexcept { return memory_; }
  /// The server of Modbus TCP; nullptr if the configuration has none.
  const ModbusServer* modbus() const noexcept { return modbus_ ? &modbus_->server() : nullptr; }
  const BusReports& reports() const noexcept { return reports_; }
  const CycleTimes& cycle_times() const noexcept { return cycle_times_; }
  /// The bus as the user named it, for messages.
  const std::string& bus_name() const noexcept { return configuration_.address.text; }
  /// Zero of the times that others are told: the start of the unit.
  canopen::TimePoint started() const noexcept { return started_; }
  /// Seconds since the start.
  double uptime_s() const noexcept;

  /// Where the frames of the unit can be heard, and what happens in it.
  FrameTap& frames() noexcept { return frames_; }
  EventWatch& events() noexcept { return events_; }
  /// The error state of the CAN controller: that which a fault holds, or its own.
  bus::ErrorState bus_state() const noexcept { return held_bus_state_.value_or(bus_.port().error_state()); }
  /// What of them is wrong on demand.
  injection::UnitFaults& faults() noexcept { return faults_; }
  const injection::UnitFaults& faults() const noexcept { return faults_; }
  /// What is kept of both in files.
  UnitRecording& recording() noexcept { return recording_; }
  /// What is judged of the frames, with key "audit".
  const UnitAudit& audit() const noexcept { return audit_; }
  /// What of both goes to other threads.
  FrameStream& frame_stream() noexcept { return frame_stream_; }
  SampleStream& sample_stream() noexcept { return sample_stream_; }
  /// Counts the frames of each PDO while it is on.
  PdoWatch& pdo_watch() noexcept { return pdo_watch_; }
  /// Saves of the parameters that were begun and have ended since the start, and whether the last one was kept.
  struct Saves {
    std::uint32_t ended = 0;
    bool kept = false;
  };
  const Saves& saves() const noexcept { return saves_; }
  /// The trace of its signals.
  UnitTrace& trace() noexcept { return trace_; }
  const UnitTrace& trace() const noexcept { return trace_; }
  /// Whether InstanceListener::on_event() is called from now on.
  void tell_events(bool wanted) noexcept;

  /// What a load does whatever else hangs on the shaft (N·m).
  struct LoadTorque {
    double constant = 0.0;
    double friction = 0.0;
  };
  /// The parameter channel of drive object @p object; nullptr if there is none.
  profidrive::ParameterChannel* parameter_channel(std::uint8_t object) noexcept;

  /// Load torque of @p axis (1..axes) as last set.
  const LoadTorque& load_torque(std::size_t axis) const noexcept { return load_torques_[axis - 1]; }
  /// Sets the load torque of @p axis (1..axes; N·m; friction not negative).
  void set_load_torque(std::size_t axis, double torque, motor::LoadTorqueType type,
                       canopen::TimePoint now) noexcept;

 private:
  /// Takes the place of the instance at the bus while somebody listens to its frames, or a fault is loaded.
  class Heard final : public Station {
   public:
    explicit Heard(Instance& instance) noexcept : instance_{instance} {}
    void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept override;
    void on_time(canopen::TimePoint now) noexcept override;
    canopen::TimePoint next_deadline() const noexcept override;
    std::span<const canopen::Subscription> subscriptions() const noexcept override;
    void on_turn_over() noexcept override { instance_.on_turn_over(); }
    void on_link_lost() noexcept override { instance_.on_link_lost(); }
    void on_burst_end() noexcept override { instance_.on_burst_end(); }
    void on_flood() noexcept override { instance_.on_flood(); }
    void on_error_state(bus::ErrorState state) noexcept override { instance_.on_error_state(state); }

   private:
    Instance& instance_;
  };

  void on_subscriptions_changed() noexcept override { bus_.follow_subscriptions(); }
  void on_foreign_frame(std::uint32_t identifier) noexcept override {
    reports_.on_foreign_frame(identifier, device_.node_id());
  }
  void on_life_guarding_withheld() noexcept override { reports_.on_life_guarding_withheld(); }
  bool on_bus_restart() noexcept override;
  device::Keeping on_store(std::span<const std::byte> image) noexcept override;
  void on_saved(bool kept) noexcept override {
    saves_ = {saves_.ended + 1, kept};
    tell(record::EventKind::Store, kept);
  }
  void on_restore() noexcept override {
    tell(record::EventKind::Restore, true);
    memory_.on_restore();
  }
  std::optional<drive::UtcTime> host_time() noexcept override;
  void on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept override;
  canopen::TimePoint frame_arrival(canopen::TimePoint) noexcept override { return bus_.frame_arrival(); }

  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept override {
    device_.on_frame(frame, now);
  }
  void on_time(canopen::TimePoint now) noexcept override;
  drive::DriveUnit* begin_time(canopen::TimePoint now) noexcept override;
  void finish_time(canopen::TimePoint now) noexcept override;
  void end_time(canopen::TimePoint now) noexcept;
  canopen::TimePoint next_deadline() const noexcept override {
    return std::min(device_.next_deadline(), memory_.due());
  }
  std::span<const canopen::Subscription> subscriptions() const noexcept override {
    return device_.subscriptions();
  }
  void on_turn_over() noexcept override { look_around(); }
  void on_link_lost() noexcept override;
  void on_burst_end() noexcept override;
  void on_flood() noexcept override { device_.let_in(this); }
  void between_steps() noexcept override { bus_.read_ahead(); }
  void on_error_state(bus::ErrorState state) noexcept override;

  void begin_recording() noexcept;
  void connect() noexcept;
  void load_faults() noexcept;
  void on_tap(bool is_open) noexcept override;
  void on_event(const UnitEvent& event) noexcept override { listener_.on_event(*this, event); }
  // injection::UnitHooks
  canopen::TimePoint now() const noexcept override { return frames_.now(); }
  void take(const canopen::Frame& frame, canopen::TimePoint now) noexcept override { on_frame(frame, now); }
  void power_cycle(canopen::TimePoint now) noexcept override { device_.power_cycle(now); }
  void set_bus_state(device::BusState state, canopen::TimePoint now) noexcept override;
  void on_loaded(bool) noexcept override { connect(); }

  void on_write(const drive::FoundParameter& parameter, double before, double value) noexcept override;
  void tell(record::EventKind kind, bool active) noexcept;

  void on_link() noexcept;
  void on_write_ended() noexcept { memory_.take_ended(); }
  void open_modbus(const ModbusSettings& settings);
  void on_modbus() noexcept;
  void tell_ready() noexcept;
  void link_up() noexcept;
  void link_down() noexcept;

  const Configuration& configuration_;
  const Log& log_;
  InstanceListener& listener_;
  canopen::TimePoint started_;
  bus::Connection connection_;
  BusTurn bus_;
  device::Device device_;
  profidrive::Interface if1_{device_.runner()};
  UnitMemory memory_;
  BusReports reports_;
  CycleTimes cycle_times_;
  canopen::TimePoint cycle_due_{};  ///< of the cycle of this turn, or of a later one
  Heard heard_{*this};
  FrameTap frames_{bus_.queue(), *this};
  injection::UnitFaults faults_{device_, frames_, *this};
  EventWatch events_{device_, frames_};
  UnitRecording recording_;
  UnitAudit audit_{device_, frames_, started_};
  PdoWatch pdo_watch_{frames_};
  FrameStream frame_stream_{frames_, started_};
  CycleTap cycles_{device_.runner()};
  SampleStream sample_stream_{cycles_, device_, started_};
  Saves saves_{};
  UnitTrace trace_{device_, cycles_, frames_, events_};
  std::vector<LoadTorque> load_torques_;
  std::unique_ptr<ModbusDoor> modbus_;  ///< none: Modbus TCP is not served
  std::vector<RareSource> rare_sources_;
  std::vector<profidrive::ParameterChannel> parameter_channels_;
  std::optional<bus::ErrorState> held_bus_state_{};  ///< by a fault
  bool ready_told_ = false;
  bool has_listeners_ = false;  ///< of its frames
  std::uint64_t overflows_seen_ = 0;
  std::uint64_t sent_before_boot_up_ = 0;
};

}  // namespace axisd
