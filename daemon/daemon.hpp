#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "can/connection/connection.hpp"
#include "daemon/bus_loop.hpp"
#include "daemon/configuration.hpp"
#include "daemon/control_server.hpp"
#include "daemon/instance_lock.hpp"
#include "daemon/log.hpp"
#include "daemon/service_events.hpp"
#include "daemon/station.hpp"
#include "daemon/unit_memory.hpp"
#include "daemon/watchdog.hpp"
#include "device/device.hpp"

namespace axisd {

/// The running program: one drive unit on one CAN bus, moved by a BusLoop; sd-event serves what is rare.
class Daemon final : private device::Listener, private Station {
 public:
  /// Opens everything that @p configuration names, with the state below @p state_root and the control socket at
  /// @p control (empty: none). Throws InstanceError, bus::OpenError or std::system_error.
  Daemon(const Configuration& configuration, const std::filesystem::path& state_root, const std::string& control,
         const Log& log);
  ~Daemon() override = default;
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// Serves until stop(), SIGTERM, SIGINT or SIGHUP.
  void run();
  /// Ends run() after the event being handled: a power-off of the unit.
  void stop() noexcept { stopping_ = true; }

  // Axes are counted from 1; 0 is the control unit.
  /// Raises a fault or alarm with @p value on @p axis (0..axes).
  tl::expected<void, drive::FaultError> raise(std::size_t axis, std::uint16_t number,
                                              std::uint32_t value) noexcept;
  /// Acknowledges the faults of @p axis (0..axes); true if none is left.
  bool acknowledge(std::size_t axis) noexcept;
  /// Sets the load torque of @p axis (1..axes; N·m; friction not negative).
  void set_load_torque(std::size_t axis, double torque, motor::LoadTorqueType type) noexcept;
  /// Sets the line voltage of the unit (V rms between lines, not negative).
  void set_line_voltage(double voltage) noexcept;
  /// The encoder of @p axis (1..axes) has @p defect from now on.
  void fail_encoder(std::size_t axis, motor::EncoderDefect defect) noexcept;

  /// Puts terminal @p number of the control unit (drive::Terminals::exists) to 24 V or 0 V.
  void set_input(unsigned number, bool high) noexcept;

  /// Restarts the controller from bus-off as p8608[0] does; false if the bus is not off.
  bool restart_bus() noexcept;

  const Configuration& configuration() const noexcept { return configuration_; }
  const device::Device& device() const noexcept { return device_; }
  const UnitMemory& memory() const noexcept { return memory_; }
  const bus::TransmitQueue& transmit_queue() const noexcept { return loop_.queue(); }
  bus::ErrorState bus_state() const noexcept { return loop_.port().error_state(); }
  bool link_is_up() const noexcept { return loop_.is_open(); }
  /// What a load does whatever else hangs on the shaft (N·m).
  struct LoadTorque {
    double constant = 0.0;
    double friction = 0.0;
  };
  /// Load torque of @p axis (1..axes) as last set.
  const LoadTorque& load_torque(std::size_t axis) const noexcept { return load_torques_[axis - 1]; }
  /// Frames received, frames lost in the socket, and frames of others under this node's identifiers.
  std::uint64_t received() const noexcept { return loop_.received(); }
  std::uint64_t receive_overflows() const noexcept { return loop_.port().dropped(); }
  std::uint64_t foreign_frames() const noexcept { return foreign_frames_; }
  /// Seconds since the start.
  double uptime_s() const noexcept;

 private:
  void on_subscriptions_changed() noexcept override;
  void on_foreign_frame(std::uint32_t identifier) noexcept override;
  void on_life_guarding_withheld() noexcept override;
  bool on_bus_restart() noexcept override;
  device::Keeping on_store(std::span<const std::byte> image) noexcept override { return memory_.store(image); }
  void on_restore() noexcept override { memory_.on_restore(); }
  canopen::TimePoint frame_arrival(canopen::TimePoint) noexcept override { return loop_.frame_arrival(); }

  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept override {
    device_.on_frame(frame, now);
  }
  void on_time(canopen::TimePoint now) noexcept override {
    device_.on_time(now);
    memory_.on_time(now);
    watchdog_.on_time(now);
    if (log_.due() <= now) log_.tell_left_out(now);
  }
  canopen::TimePoint next_deadline() const noexcept override {
    return std::min({device_.next_deadline(), memory_.due(), watchdog_.due(), log_.due()});
  }
  std::span<const canopen::Subscription> subscriptions() const noexcept override {
    return device_.subscriptions();
  }
  bool on_rare_event() noexcept override { return events_.dispatch(); }
  void on_link_lost() noexcept override;
  void on_burst_end() noexcept override;
  void on_error_state(bus::ErrorState state) noexcept override;

  static std::vector<LoadTorque> load_torques(const Configuration& configuration);
  void look_around() noexcept;
  void log_full_queue() noexcept;
  void log_skipped_cycles() noexcept;
  void log_held_back() noexcept;
  void tell_ready() noexcept;
  void link_up() noexcept;
  void link_down() noexcept;
  static int on_link(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  void log_receive_buffer() const;

  /// The bus as the user named it, for messages.
  const std::string& bus_name() const noexcept { return configuration_.address.text; }

  const Configuration& configuration_;
  const Log& log_;
  canopen::TimePoint started_;
  InstanceLock lock_;
  bus::Connection bus_;
  BusLoop loop_;
  device::Device device_;
  ServiceEvents events_;
  UnitMemory memory_;
  Watchdog watchdog_;
  EventSource link_source_;
  std::optional<ControlServer> control_;

  bool stopping_ = false;
  bool ready_told_ = false;
  bool full_logged_ = false;
  std::vector<LoadTorque> load_torques_;
  std::uint64_t foreign_frames_ = 0;
  canopen::TimePoint foreign_logged_{};
  bool withheld_logged_ = false;
  std::uint64_t overflows_seen_ = 0;
  std::uint64_t skipped_seen_ = 0;
  canopen::TimePoint skipped_logged_{};
  std::uint32_t held_back_seen_ = 0;  // axes, as Device::held_back_axes()
  std::uint64_t sent_before_boot_up_ = 0;
};

}  // namespace axisd
